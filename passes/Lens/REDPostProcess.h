// RED post process: the diffusion filter, soft focus and glow of an animation-style engine, and the small passes they
// are made of. Source: article "RED post process" (formulas); drydock's decisions where it is silent.
//
// Luma is BT.601: 0.299, 0.587, 0.114. screen(a, b) = 1 - (1 - a)(1 - b).
//   DownSample       mean of four bilinear taps half a source texel off; size ceil-divided by two
//   BlurH, BlurV     seven taps .0044 .0540 .2420 .3990 .2420 .0540 .0044, one texel apart, divided by their sum
//   DiffusionFilter  c * saturate(pow(luma(c), LuminancePow) - LuminanceThreshold), alpha 1
//   DiffusionFilter2 pow(screen(c, blurred), Power), or max; then sepia: lerp(c, luma(c) * SepiaTint, Sepia)
//   SoftFocus        lerp(luma(s), s, Saturation) of s = lerp(c, blurred, Blend)
//   Glow             screen(c, blurred * GlowIntensity)
//
// Contract. Nothing outside the rects is read; a constant stays constant to the edge. Corrected: operands of screen and
// pow are cut to 0..1 and what lies above 1 is added, so light is never lost and no NaN is made of finite numbers; on
// 0..1 both forms agree. Luma below 0 counts as 0. Alpha: the picture's own. NaN and what is below 0 become 0 in
// DiffusionFilter2 and Glow and pass on in SoftFocus; +Inf stays; picture and blur above 65504 together are infinite in
// half floats. Any size from 1x1.
// As printed (r.RED.AsPrinted 1): the blur runs 13 taps over the same table by |i|, which doubles the light (1.9952 a
// pass) and makes two lobes; screen and pow take light above 1 as it is: negative, then NaN for a power that is not a
// whole number. The kernel is declared to be faulty, so that the audit (KernelAudit.h) warns and does not refuse.
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

/** What the passes need of the settings; each pass reads its own. */
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
	bool bAsPrinted = false;

	/** From the settings and r.RED.AsPrinted. */
	DRYDOCK_API static FREDPostProcessParameters FromSettings(const FFinalPostProcessSettings& Settings);

	bool WantsDiffusionFilter() const { return DiffusionFilterIntensity > 0.0f; }
	bool WantsSoftFocus() const { return SoftFocusBlend > 0.0f || SoftFocusSaturation != 1.0f; }
	bool WantsGlow() const { return GlowIntensity > 0.0f; }
};

struct FREDPostProcessPassInputs
{
	EREDPostProcessPass Pass = EREDPostProcessPass::DownSample;
	/** Name of the output; kept as a pointer. Null: the pass's own. */
	const TCHAR* Name = nullptr;
	FScreenPassTexture SceneColor;
	/** DiffusionFilter2, SoftFocus and Glow: the blurred picture, stretched over SceneColor. */
	FScreenPassTexture Blurred;
	FREDPostProcessParameters Parameters;
	/** Where to draw; a new texture where invalid. */
	FScreenPassRenderTarget OverrideOutput;
};

/** One pass alone: DownSample gives half the size, the others SceneColor's rect. */
DRYDOCK_API FScreenPassTexture AddREDPostProcessPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FREDPostProcessPassInputs& Inputs);

/** The chain: DownSample, (DiffusionFilter,) BlurH, BlurV, DiffusionFilter2; then SoftFocus and Glow with a blur that
 * is not filtered. As printed the extract is left out and all share one blur. Neutral parameters add no pass and give
 *  SceneColor itself (then OverrideOutput is not written). */
DRYDOCK_API FScreenPassTexture AddREDPostProcessPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& SceneColor, const FREDPostProcessParameters& Parameters,
	const FScreenPassRenderTarget& OverrideOutput = FScreenPassRenderTarget());

/** Where the chain goes. */
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

/** Weight of the tap i texels away; 0 outside the kernel. The sum over all taps is 1 corrected, 1.9952 as printed. */
DRYDOCK_API float GetREDBlurWeight(int32 Tap, bool bAsPrinted);

/** How far taps reach: 3 corrected, 6 as printed. */
DRYDOCK_API int32 GetREDBlurReach(bool bAsPrinted);

} // namespace Drydock
