// RED post process: the diffusion filter, soft focus and glow of an animation-style engine, and the small passes they
// are made of. Source: article "RED post process" (formulas); drydock's decisions where it is silent.
//
// Luma is BT.601: 0.299, 0.587, 0.114. screen(a, b) = 1 - (1 - a)(1 - b).
//   DownSample       mean of four bilinear taps half a source texel off; size ceil-divided by two
//   BlurH, BlurV     seven taps .0044 .0540 .2420 .3990 .2420 .0540 .0044, one texel apart, divided by their sum
//   DiffusionFilter  extract: c * saturate(pow(luma(c), LuminancePow) - LuminanceThreshold), alpha 1
//   DiffusionFilter2 pow(screen(c, blurred), Power), or max; then sepia: lerp(c, luma(c) * SepiaTint, Sepia)
//   SoftFocus        lerp(luma(s), s, Saturation) of s = lerp(c, blurred, Blend)
//   Glow             screen(c, blurred * GlowIntensity)
//
// The article's seven weights can be read in several ways (EREDBlurKernel). The table lists the factor on the light, by
// which the corrected kernels are divided, and the width (standard deviation, texels of the blurred picture):
//   SevenTaps        0.9998  0.9977  W[i + 3], i = -3..3
//   ThirteenTexels   0.9998  1.6820  the same, but for the middle one each weight is a bilinear fetch of two texels
//   NineTaps         1.0000  0.9992  the half kernel of the article's comment: .3990 .2420 .0540 .0044 .0001
//   Printed          1.9952  3.1650  the article's loop: W[abs(i)], i = -6..6
//
// Contract. Nothing outside the rects is read; a constant stays constant to the edge. Corrected: operands of screen and
// pow are cut to 0..1 and what lies above 1 is added, so light is never lost and no NaN is made of finite numbers; on
// 0..1 the blends of both forms agree. Luma below 0 counts as 0. Alpha: the picture's own. NaN and what is below 0
// become 0 in DiffusionFilter2 and Glow and pass on in SoftFocus; +Inf stays; picture and blur above 65504 together are
// infinite in half floats. Any size from 1x1.
//
// As printed (r.RED.AsPrinted 1): the blur runs the article's loop, which doubles the light and makes two lobes, and
// there is no extract before it: LuminancePow and LuminanceThreshold go to the last node, whose blurred picture is
// extracted there. Screen and pow take light above 1 as it is: the screen of two such lights is negative, and pow of
// what is negative is NaN in HLSL, exp2(p * log2(x)), for every power: 1 and 0 and whole numbers too. So is the
// extract's pow of a negative luma, but saturate makes 0 of that NaN. The kernel is declared to be faulty, so that the
// audit (KernelAudit.h) warns and does not refuse.
#pragma once

#include "CoreMinimal.h"
#include "PostProcessSettings.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

enum class EREDPostProcessPass : uint8
{
	DownSample,
	BlurH,
	BlurV,
	DiffusionFilter,
	DiffusionFilter2,
	SoftFocus,
	Glow,
	MAX
};

/** The readings of the article's blur weights: r.RED.Kernel chooses one, except for Printed, which r.RED.AsPrinted
 * chooses. */
enum class EREDBlurKernel : uint8
{
	SevenTaps,
	ThirteenTexels,
	NineTaps,
	Printed,
	MAX
};

/** The settings that the passes need; each pass reads its own. */
struct FREDPostProcessParameters
{
	float LuminancePow = 1.0f;
	float LuminanceThreshold = 0.0f;
	/** Scales the blurred part of DiffusionFilter2. */
	float DiffusionFilterIntensity = 1.0f;
	float DiffusionFilterPower = 1.0f;
	EDiffusionFilterBlend DiffusionFilterBlend = EDiffusionFilterBlend::Screen;
	/** 0..1; 0 builds the variant without. */
	float Sepia = 0.0f;
	FLinearColor SepiaTint = FLinearColor(1.0f, 0.82f, 0.6f, 1.0f);
	float SoftFocusBlend = 0.0f;
	float SoftFocusSaturation = 1.0f;
	float GlowIntensity = 0.0f;
	/** Taken off the luma before it weighs what glows, as in the extract; up to -1 all glows alike. */
	float GlowLuminanceThreshold = -1.0f;
	/** Kernel of the corrected form. */
	EREDBlurKernel Kernel = EREDBlurKernel::SevenTaps;
	/** The blur runs at a quarter of the resolution: DownSample twice. */
	bool bQuarterResolution = false;
	bool bAsPrinted = false;

	/** Makes the parameters from the settings and the console variables r.RED.*. */
	DRYDOCK_API static FREDPostProcessParameters FromSettings(const FFinalPostProcessSettings& Settings);

	bool WantsDiffusionFilter() const { return DiffusionFilterIntensity > 0.0f; }
	bool WantsSoftFocus() const { return SoftFocusBlend > 0.0f || SoftFocusSaturation != 1.0f; }
	bool WantsGlow() const { return GlowIntensity > 0.0f; }
	bool WantsGlowExtract() const { return WantsGlow() && GlowLuminanceThreshold > -1.0f; }
	EREDBlurKernel GetKernel() const { return bAsPrinted ? EREDBlurKernel::Printed : Kernel; }
};

struct FREDPostProcessPassInputs
{
	EREDPostProcessPass Pass = EREDPostProcessPass::DownSample;
	/** Name of the output; kept as a pointer. Null: the pass's own. */
	const TCHAR* Name = nullptr;
	FScreenPassTexture SceneColor;
	/** DiffusionFilter2, SoftFocus and Glow: the blurred picture, stretched over SceneColor. */
	FScreenPassTexture Blurred;
	/** BlurH and BlurV: multiplies the distances of the taps. */
	float BlurStep = 1.0f;
	FREDPostProcessParameters Parameters;
	/** The target to draw to; a new texture where invalid. */
	FScreenPassRenderTarget OverrideOutput;
};

/** One pass alone: DownSample gives half the size, the others SceneColor's rect. */
DRYDOCK_API FScreenPassTexture AddREDPostProcessPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FREDPostProcessPassInputs& Inputs);

/** The chain: DownSample, (DiffusionFilter,) BlurH, BlurV, DiffusionFilter2; then SoftFocus and Glow, whose blur is not
 * extracted, or for a Glow with a threshold extracted by that. All blurs begin from one downsampled picture, and
 * equal ones are made once. Neutral parameters add no pass and give SceneColor itself (then OverrideOutput is not
 * written). */
DRYDOCK_API FScreenPassTexture AddREDPostProcessPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& SceneColor, const FREDPostProcessParameters& Parameters,
	const FScreenPassRenderTarget& OverrideOutput = FScreenPassRenderTarget());

/** Position of the chain. */
enum class EREDPostProcessInsertion : uint8
{
	BeforeTranslucency,
	AfterTranslucency,
	AfterBloom
};

/** r.REDPostprocessAfterTranslucency, clamped to 0..2. */
DRYDOCK_API EREDPostProcessInsertion GetREDPostProcessInsertion();

/** "DownSample", "BlurH", ... */
DRYDOCK_API const TCHAR* ToString(EREDPostProcessPass Pass);

/** "SevenTaps", ... */
DRYDOCK_API const TCHAR* ToString(EREDBlurKernel Kernel);

/** Weight of the texel that many texels away; 0 outside the kernel. Corrected kernels sum to 1, Printed to 1.9952. */
DRYDOCK_API float GetREDBlurWeight(int32 Texel, EREDBlurKernel Kernel);

/** The farthest texel that a kernel weighs: 3, 6, 4 and 6. */
DRYDOCK_API int32 GetREDBlurReach(EREDBlurKernel Kernel);

} // namespace Drydock
