// Local exposure: brings areas much brighter or darker than middle grey nearer to it, without flattening details. A
// base layer (a bilateral grid of log2 luminance, blended with a wide blur of it) gives the brightness of a place; the
// distance of the base from middle grey is scaled, the detail above the base is kept. Bloom setup and tonemapper apply
// the factor. Source: engine file PostProcessLocalExposure.h.
//
// For a pixel of exposed log2 luminance l with base b, middle grey g, contrast k and threshold t (of highlights where b
// is above g, else of shadows) and detail strength d: log2 of the factor is (k - 1) max(|b - g| - t, 0) sign(b - g) +
// (d - 1) (l - b). The thresholds' rule is a guess that keeps the factor continuous; each counts times its
// ThresholdStrength, in engines that have thresholds (EngineProfile.h). The contrast curves have no keys here and count
// as 1.
//
// Contract. With contrasts and detail strength at 1 nothing is built and no bit changes. Luminance is the mean of the
// channels in scene units, at least LuminanceMin; NaN and negatives count as that, infinity as 65536. Texels that are
// not finite are left out of the grid. The factor is finite: black stays black, NaN and infinity stay what they are.
// The grid has a cell for each 64x64 texels of its input and 32 depths; a cell's weight is the share of its 4096
// texels, and where it is below 0.001 the blur alone is the base. Any size from 1x1 up; nothing outside the rect is
// read.
#pragma once

#include "CoreMinimal.h"
#include "Exposure/PostProcessEyeAdaptationParameters.h"
#include "RenderGraphFwd.h"
#include "ScreenPass.h"
#include "ShaderParameterMacros.h"

class FRDGBuilder;
class FViewInfo;
struct FFinalPostProcessSettings;

/** The settings as shaders read them, beside FEyeAdaptationParameters. Thresholds in EV. */
BEGIN_SHADER_PARAMETER_STRUCT(FLocalExposureParameters, DRYDOCK_API)
	SHADER_PARAMETER(float, HighlightContrastScale)
	SHADER_PARAMETER(float, ShadowContrastScale)
	SHADER_PARAMETER(float, HighlightThreshold)
	SHADER_PARAMETER(float, ShadowThreshold)
	SHADER_PARAMETER(float, DetailStrength)
	SHADER_PARAMETER(float, BlurredLuminanceBlend)
	SHADER_PARAMETER(float, MiddleGreyExposureCompensation)
	SHADER_PARAMETER(FVector2f, BilateralGridUVScale)
END_SHADER_PARAMETER_STRUCT()

namespace Drydock
{

/** Texels of the grid's input along a cell. */
constexpr int32 GBilateralGridCellSize = 64;
constexpr int32 GBilateralGridDepth = 32;

/** The inputs that a frame applies local exposure with; not valid where it is off. */
struct FLocalExposureTextures
{
	FLocalExposureParameters Parameters;
	FEyeAdaptationParameters EyeAdaptation;
	/** Texture3D: x the sum of log2 luminance, y the weight. */
	FRDGTextureRef BilateralGrid = nullptr;
	/** log2 luminance over the view, which it fills; any resolution. */
	FRDGTextureRef BlurredLogLuminance = nullptr;

	bool IsValid() const { return BilateralGrid != nullptr && BlurredLogLuminance != nullptr; }

	/** Gives them to the inputs of a pass (FBloomSetupInputs, FTonemapInputs), which refer to this. */
	template<typename FInputs>
	void GiveTo(FInputs& Inputs) const
	{
		Inputs.EyeAdaptationParameters = &EyeAdaptation;
		Inputs.LocalExposureParameters = &Parameters;
		Inputs.LocalExposureTexture = BilateralGrid;
		Inputs.BlurredLogLuminanceTexture = BlurredLogLuminance;
	}
};

/** A contrast or the detail strength is not 1. */
DRYDOCK_API bool IsLocalExposureEnabled(const FFinalPostProcessSettings& Settings);

/** r.Bloom.ApplyLocalExposure. */
DRYDOCK_API bool IsLocalExposureAppliedToBloom();

} // namespace Drydock

/** GridInputSize: size of the picture that AddLocalExposurePass is given. bManual: the exposure is the camera's, and
 * its compensation does not move middle grey. */
DRYDOCK_API FLocalExposureParameters GetLocalExposureParameters(
	const FViewInfo& View, FIntPoint GridInputSize, const FEyeAdaptationParameters& EyeAdaptation, bool bManual);

/** The bilateral grid of a picture, PF_G32R32F: on the CPU, texel by texel in a fixed order. SceneColor: linear,
 * pre-exposed. */
DRYDOCK_API FRDGTextureRef AddLocalExposurePass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FEyeAdaptationParameters& EyeAdaptation, FScreenPassTexture SceneColor);

/** log2 luminance of a small picture's rect, PF_R16F, blurred over KernelSizePercent of its width; mirrored at its
 * edges. */
DRYDOCK_API FRDGTextureRef AddLocalExposureBlurredLogLuminancePass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FEyeAdaptationParameters& EyeAdaptation, FScreenPassTexture SceneColor, float KernelSizePercent);
