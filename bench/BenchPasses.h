// Passes that benchmarks time, as functions that add them to a graph, and the picture that they run on.
#pragma once

#include "Bloom/PostProcessBloomSetup.h"
#include "Blur/DualKawaseBlurPass.h"
#include "Blur/FourTapBlur.h"
#include "Blur/MatchedGaussianBlur.h"
#include "Blur/PostProcessWeightedSampleSum.h"
#include "Exposure/PostProcessEyeAdaptation.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "SceneTextureParameters.h"
#include "SceneTextures.h"
#include "Screen/PostProcessDownsample.h"
#include "Tonemap/PostProcessCombineLUTs.h"
#include "Tonemap/PostProcessTonemap.h"
#include "Toon/CharaGlow.h"

#include <functional>
#include <random>

namespace Drydock::Bench
{

const FIntPoint GSize(1920, 1080);

using FAddPasses = std::function<FScreenPassTexture(FRDGBuilder&, FViewInfo&, const FScreenPassTexture&)>;

inline FAddPasses Gaussian(float Radius)
{
	return [Radius](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
	{
		FGaussianBlurInputs Inputs;
		Inputs.NameX = TEXT("X");
		Inputs.NameY = TEXT("Y");
		Inputs.Filter = Input;
		Inputs.KernelSizePercent = 200.0f * Radius / static_cast<float>(GSize.X);
		return AddGaussianBlurPass(GraphBuilder, View, Inputs);
	};
}

inline FAddPasses Kawase(int32 Levels)
{
	return [Levels](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
	{
		FDualKawaseBlurInputs Inputs;
		Inputs.SceneColor = Input;
		Inputs.PassNum = Levels;
		return AddDualKawaseBlurPass(GraphBuilder, View, Inputs);
	};
}

inline FAddPasses Separable(double StandardDeviation)
{
	return [StandardDeviation](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
	{
		FMatchedGaussianBlurInputs Inputs;
		Inputs.SceneColor = Input;
		Inputs.StandardDeviation = StandardDeviation;
		Inputs.bSeparable = true;
		return AddMatchedGaussianBlurPasses(GraphBuilder, View, Inputs);
	};
}

inline FAddPasses Pyramid(double StandardDeviation)
{
	return [StandardDeviation](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
	{
		return AddPyramidBlurPasses(GraphBuilder, View, Input, StandardDeviation);
	};
}

/** CharaGlow's two box passes; the mask is blue of the input. */
inline FAddPasses Box(float Area)
{
	return [Area](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
	{
		FSceneTextures SceneTextures;
		SceneTextures.GBufferD = Input.Texture;
		FCharaGlowInputs Inputs;
		Inputs.SceneColor = Input;
		Inputs.Area = Area;
		Inputs.SceneTextures = CreateSceneTextureUniformBuffer(GraphBuilder, &SceneTextures);
		return AddCharaGlowPasses(GraphBuilder, View, Inputs);
	};
}

inline FAddPasses Downsample(EDownsampleQuality Quality)
{
	return [Quality](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
	{
		FDownsamplePassInputs Inputs;
		Inputs.Name = TEXT("Half");
		Inputs.SceneColor = Input;
		Inputs.Quality = Quality;
		return AddDownsamplePass(GraphBuilder, View, Inputs);
	};
}

enum class ELens
{
	None,
	Bloom,
	Everything
};

inline FLocalExposureTextures AddLocalExposure(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input)
{
	FLocalExposureTextures Textures;
	Textures.Parameters.HighlightContrastScale = 0.8f;
	Textures.Parameters.ShadowContrastScale = 0.8f;
	Textures.Parameters.DetailStrength = 1.0f;
	Textures.Parameters.BlurredLuminanceBlend = 0.6f;
	Textures.Parameters.MiddleGreyExposureCompensation = 1.0f;
	Textures.EyeAdaptation.HistogramScale = 0.06f;
	Textures.EyeAdaptation.HistogramBias = 0.5f;
	Textures.EyeAdaptation.LuminanceMin = 0.001f;
	FDownsamplePassInputs Half;
	Half.Name = TEXT("Half");
	Half.SceneColor = Input;
	const FScreenPassTexture Small = AddDownsamplePass(GraphBuilder, View, Half);
	const FIntPoint Size = Small.ViewRect.Size();
	Textures.Parameters.BilateralGridUVScale =
		FVector2f(Size) / FVector2f(FIntPoint::DivideAndRoundUp(Size, GBilateralGridCellSize) * GBilateralGridCellSize);
	Textures.BilateralGrid = AddLocalExposurePass(GraphBuilder, View, Textures.EyeAdaptation, Small);
	Textures.BlurredLogLuminance =
		AddLocalExposureBlurredLogLuminancePass(GraphBuilder, View, Textures.EyeAdaptation, Small, 10.0f);
	return Textures;
}

inline FAddPasses Tonemap(ELens Lens)
{
	return [Lens](FRDGBuilder& GraphBuilder, FViewInfo& View, const FScreenPassTexture& Input)
	{
		FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
		const bool bEverything = Lens == ELens::Everything;
		Settings.VignetteIntensity = bEverything ? 0.4f : 0.0f;
		Settings.SceneFringeIntensity = bEverything ? 0.5f : 0.0f;
		Settings.FilmGrainIntensity = bEverything ? 0.1f : 0.0f;
		Settings.Sharpen = bEverything ? 0.3f : 0.0f;
		FLocalExposureTextures LocalExposure;
		FTonemapInputs Inputs;
		Inputs.SceneColor = Input;
		Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(GraphBuilder, 1.0f);
		Inputs.ColorGradingTexture = AddCombineLUTPass(GraphBuilder, View);
		if (Lens != ELens::None)
		{
			FDownsamplePassInputs Half;
			Half.Name = TEXT("Half");
			Half.SceneColor = Input;
			Half.FormatOverride = PF_FloatR11G11B10;
			Inputs.Bloom = AddDownsamplePass(GraphBuilder, View, Half);
		}
		if (bEverything)
		{
			LocalExposure = AddLocalExposure(GraphBuilder, View, Input);
			LocalExposure.GiveTo(Inputs);
		}
		return AddTonemapPass(GraphBuilder, View, Inputs);
	};
}

inline FAddPasses SetUpBloom(bool bLocalExposure)
{
	return [bLocalExposure](FRDGBuilder& GraphBuilder, FViewInfo& View, const FScreenPassTexture& Input)
	{
		FBloomSetupInputs Inputs;
		Inputs.SceneColor = Input;
		Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(GraphBuilder, 1.0f);
		Inputs.Threshold = 0.5f;
		FLocalExposureTextures LocalExposure;
		if (bLocalExposure)
		{
			LocalExposure = AddLocalExposure(GraphBuilder, View, Input);
			LocalExposure.GiveTo(Inputs);
		}
		return AddBloomSetupPass(GraphBuilder, View, Inputs);
	};
}

/** Numbers from 0 to 1. */
inline FTextureRHIRef MakeNoise(EPixelFormat Format)
{
	const FTextureRHIRef Texture = new FRHITexture(
		FRDGTextureDesc::Create2D(GSize, Format, FClearValueBinding::None, TexCreate_ShaderResource), TEXT("Input"));
	std::mt19937 Random(1);
	std::uniform_real_distribution<double> Value(0.0, 1.0);
	for (int32 Y = 0; Y < GSize.Y; ++Y)
	{
		for (int32 X = 0; X < GSize.X; ++X)
		{
			Texture->WriteTexelDouble(X, Y, FVector4(Value(Random), Value(Random), Value(Random), 1.0));
		}
	}
	return Texture;
}

} // namespace Drydock::Bench
