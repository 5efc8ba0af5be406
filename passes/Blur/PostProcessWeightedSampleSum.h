// The engine's separable Gaussian blur: kernel, radius rules and the two passes. Source: engine file
// PostProcessWeightedSampleSum.h.
//
// Contract. The result has the filter's extent, rect and format; each pass stores once. Weights sum to 1 times the
// tint, over the whole kernel: with border addressing an image fades towards its edges (the engine's bloom does), with
// mirror or clamp addressing a constant stays constant. Taps whose weight is zero are left out, so that zero times
// infinity is never computed; NaN and infinities spread over the kernel's support and no further; negatives pass on
// until an unsigned store clips them. A radius of at most one texel copies. Any size from 1x1 up; a rect smaller than
// its texture reads as if the texture ended at the rect. From r.FastBlurThreshold on, the horizontal pass samples
// between texels, where the folded taps are not exact: it weighs single columns unevenly (up to 1.93 and 0.07), two
// neighbours together rightly.
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

/** One bilinear tap that replaces two neighbouring texels. */
struct FGaussianTap
{
	double Offset = 0.0; // in texels; never NaN
	double Weight = 0.0; // all weights of a kernel sum to 1
};

/** Most taps a kernel may have: 32, or 128 with r.Filter.LoopMode 1 or 2. */
DRYDOCK_API int32 GetFilterSampleCountMax();

/** The radius that sets the kernel's width, in texels: the wanted one within 1e-5 .. SampleCountMax - 1. */
DRYDOCK_API float GetClampedKernelRadius(int32 SampleCountMax, float KernelRadius);

/** The reach of taps: the clamped radius times r.Filter.SizeScale (0.1..10), rounded up. */
DRYDOCK_API int32 GetIntegerKernelRadius(int32 SampleCountMax, float KernelRadius);

/** The kernel exp(-16.7 (x / R)^2), sigma 0.17303 R, sampled at the integers of the reach R' and folded two by two from
 *  -R' up: R' + 1 taps. CrossCenterWeight c sharpens the centre: 0 < c <= 1 blends with a triangle of half-width 1,
 * above 1 takes the triangle to the power c. If both texels of a pair weigh nothing, the tap stays on its first texel.
 * Empty when KernelRadius is not a number. */
DRYDOCK_API TArray<FGaussianTap> ComputeGaussianKernel(
	int32 SampleCountMax, float KernelRadius, float CrossCenterWeight = 0.0f);

/** Radius in texels of a blur of KernelSizePercent of the width of an image, width and height alike. */
DRYDOCK_API float GetBlurRadius(uint32 ViewSize, float KernelSizePercent);

/** Whether the horizontal pass works at half width: from r.FastBlurThreshold texels of radius on. */
DRYDOCK_API bool IsFastBlurEnabled(float BlurRadius);

} // namespace Drydock

struct FGaussianBlurInputs
{
	/** Names of the two passes and their outputs; kept as pointers. */
	const TCHAR* NameX = nullptr;
	const TCHAR* NameY = nullptr;

	/** [Required] What is blurred: a texture as up to engine 5.3, or a slice as from 5.4. */
	Drydock::FScreenPassInput Filter;

	/** [Optional] Added to the result, at the same place of the view; clamp addressing. */
	Drydock::FScreenPassInput Additive;

	/** Sharpness of the centre, x horizontal, y vertical (ComputeGaussianKernel). */
	FVector2f CrossCenterWeight = FVector2f(0.0f, 0.0f);

	/** Multiplies the blurred image, alpha too; not what is added. */
	FLinearColor TintColor = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);

	/** Diameter of the kernel in percent of the filter's width. */
	float KernelSizePercent = 0.0f;

	/** Texels outside are the image's mirror (true), or black. */
	bool UseMirrorAddressMode = false;

	/** drydock: what lies outside is the edge texel, so that a constant stays constant; before the mirror. */
	bool UseClampAddressMode = false;
};

DRYDOCK_API FScreenPassTexture AddGaussianBlurPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FGaussianBlurInputs& Inputs);
