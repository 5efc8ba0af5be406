// The bloom that Unity lessons teach: one shader of four numbered passes (extract, blur vertically, blur horizontally,
// composite), the blur repeated with growing spread on a small target. Source: article "Unity bloom" (formulas);
// drydock's decisions where it is silent.
//
// Contract. Every tap is clamped to its texture's rect: nothing outside is read, a constant stays constant to the edge.
//   Sizes: the small target is ceil-divided (as printed: truncated), never below 1x1, and mapped by UV, so that the
//   centroid of a light stays where it is.
//   NaN in a texel: NaN wherever a tap sees it. +Inf: Inf, and NaN where a tap of weight 0 sees it. Negative light:
//   luminance below the threshold gives 0; a negative channel of a bright texel passes on; -Inf gives NaN. A sum of
//   picture and bloom above 65504 is infinite in a half.
//   Alpha: the scene's own; the bloom carries none.
//   Soft knee: with k = SoftKnee * max(Threshold, 0), the weight's L - Threshold is max(L - Threshold, s^2 / (4 k))
//   with s = clamp(L - Threshold + k, 0, 2 k): no corner, and no jump as SoftKnee grows from 0, where the lesson's
//   extract holds bit for bit. Source of the parabola: Unity's post-processing stack, Bloom.shader; which divides by
//   the brightness, where the lesson cuts at 1.
// As printed (r.UnityBloom.AsPrinted 1): temporaries of 8 bit, which cut the light at 1 and band what is left, weights
// as written, no soft knee, alpha a channel like the others: extracted, blurred and added; runs after the tonemapper.
// Corrected: temporaries in half floats, weights divided by their sum.
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;
struct FFinalPostProcessSettings;

namespace Drydock
{

/** The shader's passes, by the number the article gives them. */
enum class EUnityBloomPass : uint8
{
	Extract,                // c * clamp(L - Threshold, 0, 1), L = 0.2125 R + 0.7154 G + 0.0721 B
	GaussianBlurVertical,   // five taps, Spread texels apart
	GaussianBlurHorizontal, // the same along x
	Composite,              // source + Intensity * bloom
	MAX
};

/** "Extract", "GaussianBlurVertical", ... */
DRYDOCK_API const TCHAR* ToString(EUnityBloomPass Pass);

/** The pass of that name, case ignored: the way one effect uses a pass of another. Unset when there is none. */
DRYDOCK_API TOptional<EUnityBloomPass> FindUnityBloomPass(const TCHAR* Name);

/** One pass alone. */
struct FUnityBloomPassInputs
{
	EUnityBloomPass Pass = EUnityBloomPass::Extract;
	/** Name of the output; kept as a pointer. Null: the pass's own. */
	const TCHAR* Name = nullptr;
	FScreenPassTexture Source;
	/** Composite only: what is added, stretched over Source. */
	FScreenPassTexture Bloom;
	/** Extract: luminance at which light starts to count. Any value; the setting's default is 0.6. */
	float Threshold = 0.6f;
	/** Extract: how far below the threshold light begins, softly, as a part of it; 0 to 1, 0 and below: sharp. */
	float SoftKnee = 0.0f;
	/** Blur: distance of the taps in texels of Source, 0 and above. */
	float Spread = 1.0f;
	/** Composite. */
	float Intensity = 1.0f;
	/** The target to draw to; a new texture like Source where invalid. */
	FScreenPassRenderTarget OverrideOutput;
	bool bAsPrinted = false;
};

DRYDOCK_API FScreenPassTexture AddUnityBloomPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FUnityBloomPassInputs& Inputs);

/** Eight times what the setting's range has. */
constexpr int32 GUnityBloomMaxIterations = 64;

/** The whole effect. */
struct FUnityBloomInputs
{
	FScreenPassTexture SceneColor;
	/** Written by the composite where valid. */
	FScreenPassRenderTarget OverrideOutput;
	float Threshold = 0.6f;
	float SoftKnee = 0.0f;
	/** Blurs of both directions; 0 leaves the extract unblurred. Below 0 counts as 0, more than
	 * GUnityBloomMaxIterations as that, with a warning (DD2110). */
	int32 Iterations = 3;
	/** Iteration i blurs with taps 1 + i * Spread texels apart. */
	float Spread = 0.6f;
	/** Size of the small target: the scene's over this. Below 1 counts as 1. */
	int32 DownSample = 2;
	float Intensity = 1.0f;
	bool bAsPrinted = false;

	/** Makes the inputs from the settings and r.UnityBloom.AsPrinted. */
	DRYDOCK_API static FUnityBloomInputs FromSettings(
		const FFinalPostProcessSettings& Settings, const FScreenPassTexture& SceneColor);
};

/** Passes: extract, Iterations times vertical and horizontal, composite. The result has SceneColor's rect. */
DRYDOCK_API FScreenPassTexture AddUnityBloomPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FUnityBloomInputs& Inputs);

/** Whether the effect follows the tonemapper (r.UnityBloom.Insertion 1, or as printed) or precedes it. */
DRYDOCK_API bool IsUnityBloomAfterTonemap();

} // namespace Drydock
