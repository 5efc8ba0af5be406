// The passes that local exposure is applied with: the bilateral grid and the blurred luminance. Source: engine file
// PostProcessLocalExposure.cpp.
#include "Exposure/PostProcessLocalExposure.h"

#include "Blur/PostProcessWeightedSampleSum.h"
#include "Exposure/ExposureMetering.h"
#include "Exposure/PostProcessEyeAdaptationParameters.h"
#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "PassFunctions.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "ShaderParameterStruct.h"
#include "TileExecutor.h"

#include <array>
#include <cmath>
#include <vector>

namespace
{

TAutoConsoleVariable<bool> CVarBloomApplyLocalExposure(TEXT("r.Bloom.ApplyLocalExposure"), true,
	TEXT("Local exposure acts on the bloom's input too (default)."), ECVF_RenderThreadSafe);

BEGIN_SHADER_PARAMETER_STRUCT(FBilateralGridParameters, )
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
	SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture3D<float2>, BilateralGrid)
END_SHADER_PARAMETER_STRUCT()

class FSetupLogLuminancePS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FSetupLogLuminancePS);
	SHADER_USE_PARAMETER_STRUCT(FSetupLogLuminancePS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER(float, LuminanceMin)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(
	FSetupLogLuminancePS, "/Engine/Private/PostProcessLocalExposure.usf", "SetupLogLuminancePS", SF_Pixel);

/** The inputs that the cells of a grid are made of. */
struct FBilateralGridWork
{
	FIntRect Rect; // of the input
	double OneOverPreExposure = 1.0;
	FEyeAdaptationParameters Parameters;
};

/** One cell of the grid, all depths. */
void FillCell(FRHITexture& Input, FRHITexture& Grid, const FBilateralGridWork& Work, int32 CellX, int32 CellY)
{
	struct FSum
	{
		double LogLuminance = 0.0;
		double Weight = 0.0;
	};
	std::array<FSum, Drydock::GBilateralGridDepth> Sums;
	const int32 MinX = Work.Rect.Min.X + CellX * Drydock::GBilateralGridCellSize;
	const int32 MinY = Work.Rect.Min.Y + CellY * Drydock::GBilateralGridCellSize;
	const int32 MaxX = FMath::Min(MinX + Drydock::GBilateralGridCellSize, Work.Rect.Max.X);
	const int32 MaxY = FMath::Min(MinY + Drydock::GBilateralGridCellSize, Work.Rect.Max.Y);
	std::vector<float> Row;
	std::vector<double> Means;
	for (int32 Y = MinY; Y < MaxY; ++Y)
	{
		Drydock::ReadMeanColors(Input, MinX, Y, MaxX - MinX, Row, Means);
		for (const double Mean : Means)
		{
			if (!std::isfinite(Mean))
			{
				continue;
			}
			const double LogLuminance = Drydock::GetMeteredLogLuminance(
				Mean, Work.OneOverPreExposure, static_cast<double>(Work.Parameters.LuminanceMin));
			const Drydock::FBucketShare Share =
				Drydock::ShareBetweenBuckets(LogLuminance, static_cast<double>(Work.Parameters.HistogramScale),
					static_cast<double>(Work.Parameters.HistogramBias), Drydock::GBilateralGridDepth);
			FSum* const Sum = &Sums[static_cast<size_t>(Share.First)];
			Sum[0].LogLuminance += LogLuminance * Share.FirstWeight;
			Sum[0].Weight += Share.FirstWeight;
			Sum[1].LogLuminance += LogLuminance * Share.SecondWeight;
			Sum[1].Weight += Share.SecondWeight;
		}
	}
	constexpr double Normalize = 1.0 / (Drydock::GBilateralGridCellSize * Drydock::GBilateralGridCellSize);
	for (int32 Z = 0; Z < Drydock::GBilateralGridDepth; ++Z)
	{
		const FSum& Sum = Sums[static_cast<size_t>(Z)];
		Grid.WriteTexelDouble(
			CellX, CellY, FVector4(Sum.LogLuminance * Normalize, Sum.Weight * Normalize, 0.0, 0.0), 0, Z);
	}
}

} // namespace

namespace Drydock
{

bool IsLocalExposureEnabled(const FFinalPostProcessSettings& Settings)
{
	return !FMath::IsNearlyEqual(Settings.LocalExposureHighlightContrastScale, 1.0f) ||
		   !FMath::IsNearlyEqual(Settings.LocalExposureShadowContrastScale, 1.0f) ||
		   !FMath::IsNearlyEqual(Settings.LocalExposureDetailStrength, 1.0f);
}

bool IsLocalExposureAppliedToBloom()
{
	return CVarBloomApplyLocalExposure.GetValueOnRenderThread();
}

} // namespace Drydock

FLocalExposureParameters GetLocalExposureParameters(
	const FViewInfo& View, FIntPoint GridInputSize, const FEyeAdaptationParameters& EyeAdaptation, bool bManual)
{
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	const FVector2f Cells(
		FIntPoint::DivideAndRoundUp(GridInputSize, Drydock::GBilateralGridCellSize) * Drydock::GBilateralGridCellSize);
	FLocalExposureParameters Parameters;
	Parameters.HighlightContrastScale = Settings.LocalExposureHighlightContrastScale;
	Parameters.ShadowContrastScale = Settings.LocalExposureShadowContrastScale;
	if (View.EngineProfile.bLocalExposureThresholds)
	{
		Parameters.HighlightThreshold =
			Settings.LocalExposureHighlightThreshold * Settings.LocalExposureHighlightThresholdStrength;
		Parameters.ShadowThreshold =
			Settings.LocalExposureShadowThreshold * Settings.LocalExposureShadowThresholdStrength;
	}
	Parameters.DetailStrength = Settings.LocalExposureDetailStrength;
	Parameters.BlurredLuminanceBlend = Settings.LocalExposureBlurredLuminanceBlend;
	const float Compensation = EyeAdaptation.ExposureCompensationSettings * EyeAdaptation.ExposureCompensationCurve;
	Parameters.MiddleGreyExposureCompensation =
		std::exp2(FMath::Clamp(Settings.LocalExposureMiddleGreyBias, -60.0f, 60.0f)) / (bManual ? Compensation : 1.0f);
	Parameters.BilateralGridUVScale = FVector2f(GridInputSize) / Cells;
	return Parameters;
}

FRDGTextureRef Drydock::BuiltInAddLocalExposurePass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FEyeAdaptationParameters& EyeAdaptation, FScreenPassTexture SceneColor)
{
	check(SceneColor.IsValid());
	const FIntPoint Cells = FIntPoint::DivideAndRoundUp(SceneColor.ViewRect.Size(), Drydock::GBilateralGridCellSize);
	const FRDGTextureRef Grid =
		GraphBuilder.CreateTexture(FRDGTextureDesc::Create3D(FIntVector(Cells.X, Cells.Y, Drydock::GBilateralGridDepth),
									   PF_G32R32F, FClearValueBinding::None, TexCreate_ShaderResource | TexCreate_UAV),
			TEXT("LocalExposureBilateralGrid"));

	auto* PassParameters = GraphBuilder.AllocParameters<FBilateralGridParameters>();
	PassParameters->InputTexture = SceneColor.Texture;
	PassParameters->BilateralGrid = GraphBuilder.CreateUAV(Grid);
	const FBilateralGridWork Work{SceneColor.ViewRect, 1.0 / static_cast<double>(View.PreExposure), EyeAdaptation};
	GraphBuilder.AddPass(
		RDG_EVENT_NAME("LocalExposureBilateralGrid %dx%dx%d", Cells.X, Cells.Y, Drydock::GBilateralGridDepth),
		PassParameters, ERDGPassFlags::Compute,
		[Input = SceneColor.Texture, Grid, Work, Cells](FRHIComputeCommandList&)
		{
			FRHITexture& InputRHI = *Input->GetRHI();
			FRHITexture& GridRHI = *Grid->GetRHI();
			InputRHI.EnsureMemory();
			GridRHI.EnsureMemory();
			Drydock::ForEachTile({0, 0, 0, Cells.X, Cells.Y, 1}, FIntPoint(1, 1),
				[&](const Drydock::FKernelTile& Tile) { FillCell(InputRHI, GridRHI, Work, Tile.MinX, Tile.MinY); });
		});
	return Grid;
}

FRDGTextureRef Drydock::BuiltInAddLocalExposureBlurredLogLuminancePass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FEyeAdaptationParameters& EyeAdaptation, FScreenPassTexture SceneColor, float KernelSizePercent)
{
	check(SceneColor.IsValid());
	const FScreenPassRenderTarget Output = Drydock::CreateSmallRasterTarget(
		GraphBuilder, SceneColor, SceneColor.ViewRect.Size(), TEXT("LogLuminance"), PF_R16F);

	auto* PassParameters = GraphBuilder.AllocParameters<FSetupLogLuminancePS::FParameters>();
	PassParameters->View = View.ViewUniformBuffer;
	PassParameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(SceneColor));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->InputTexture = SceneColor.Texture;
	PassParameters->LuminanceMin = EyeAdaptation.LuminanceMin;
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	TShaderMapRef<FSetupLogLuminancePS> PixelShader(View.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("LogLuminance %dx%d", Output.ViewRect.Width(), Output.ViewRect.Height()), PixelShader,
		PassParameters, Output.ViewRect);

	FGaussianBlurInputs BlurInputs;
	BlurInputs.NameX = TEXT("BlurredLogLuminanceX");
	BlurInputs.NameY = TEXT("BlurredLogLuminanceY");
	BlurInputs.Filter = FScreenPassTexture(Output.Texture, Output.ViewRect);
	BlurInputs.KernelSizePercent = KernelSizePercent;
	BlurInputs.UseMirrorAddressMode = true;
	return AddGaussianBlurPass(GraphBuilder, View, BlurInputs).Texture;
}
