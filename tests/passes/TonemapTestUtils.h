// Runs the tonemapper with any settings, in one line.
#pragma once

#include "PassTestUtils.h"

#include "Tonemap/PostProcessCombineLUTs.h"
#include "Tonemap/PostProcessTonemap.h"

#include <functional>

namespace TonemapTest
{

using PassReference::FImage;
using PassReference::FTexel;
using PassTest::EArithmetic;

struct FTonemapRun
{
	/** On top of no vignette. */
	std::function<void(FFinalPostProcessSettings&)> Settings = [](FFinalPostProcessSettings&) {
	};
	std::function<void(FViewInfo&)> View = [](FViewInfo&) {
	};
	EArithmetic Arithmetic = EArithmetic::Float32;
	EPixelFormat OutputFormat = PF_A32B32G32R32F;
	bool bLUT = false;
	bool bGammaOnly = false;
	bool bCompute = false;
	uint32 FrameNumber = 0;
	FImage Bloom = {};
};

inline FImage Tonemap(const FImage& Image, const FTonemapRun& Setup = {})
{
	PassTest::FPassRun Run(Image, Setup.Arithmetic, PF_A32B32G32R32F);
	Run.View.bUseComputePasses = Setup.bCompute;
	Run.View.UniformParameters.StateFrameIndex = Setup.FrameNumber;
	Run.View.FinalPostProcessSettings.VignetteIntensity = 0.0f;
	Setup.Settings(Run.View.FinalPostProcessSettings);
	Setup.View(Run.View);

	FTonemapInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.EyeAdaptationBuffer = Drydock::CreateEyeAdaptationBuffer(Run.GraphBuilder, 1.0f);
	Inputs.OutputFormat = Setup.OutputFormat;
	Inputs.bGammaOnly = Setup.bGammaOnly;
	if (Setup.bLUT)
	{
		Inputs.ColorGradingTexture = AddCombineLUTPass(Run.GraphBuilder, Run.View);
	}
	if (Setup.Bloom.Width > 0)
	{
		Inputs.Bloom = Run.AddInput(Setup.Bloom, PF_A32B32G32R32F, TEXT("Bloom"));
	}
	return Run.Execute(AddTonemapPass(Run.GraphBuilder, Run.View, Inputs));
}

inline FTexel TonemapPixel(const FTexel& Color, const FTonemapRun& Setup = {})
{
	return Tonemap(FImage(1, 1, Color), Setup).At(0, 0);
}

/** No curve, no corrections: linear in, sRGB out. */
inline void Linear(FFinalPostProcessSettings& Settings)
{
	Settings.ToneCurveAmount = 0.0f;
	Settings.BlueCorrection = 0.0f;
	Settings.ExpandGamut = 0.0f;
}

/** Dull and saturated colours from 2^-8 to 2^5; the first row is grey. */
inline FImage MakeSwatches(unsigned Seed = 3)
{
	std::mt19937 Random(Seed);
	std::uniform_real_distribution<float> Stops(-8, 5), Unit(0, 1);
	return FImage::Make(32, 24,
		[&](int, int Y)
		{
			const double Level = std::exp2(Stops(Random));
			const double Dullness = Y == 0 ? 1.0 : Unit(Random);
			const auto Channel = [&]
			{
				return static_cast<double>(static_cast<float>(Level * (Dullness + (1 - Dullness) * Unit(Random))));
			};
			const double R = Channel(), G = Channel(), B = Channel();
			return FTexel{R, G, B, 1};
		});
}

} // namespace TonemapTest
