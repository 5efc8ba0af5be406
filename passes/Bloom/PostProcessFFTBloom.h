// Bloom as a convolution with the picture of a point of light (BM_FFT). Source: engine file
// PostProcess/PostProcessFFTBloom.h; the split of energy is that of an independent port's description.
//
// Bloom moves energy: with s = BloomConvolutionScatterDispersion * BloomIntensity, Total the kernel's energy, Scatter
// the part outside its brightest texel, and Tint = Total divided by its largest channel, scene colour is multiplied by
// Tint * saturate((Total - Scatter * s) / Total) and bloom has the energy Tint * saturate(Scatter * s / Total);
// together Tint. So this bloom darkens the sharp picture, and BloomThreshold is not read.
//
// Per frame: pre-filter, forward transform, product with the kernel's spectrum, inverse transform. Kernel, kept in the
// view's state while texture, mips, size, centre and resolution stay: find the brightest texel, survey energies, clamp
// the brightest texel to the largest value beside it, resize, transform. The kernel then counts by its shape alone:
// each channel is divided by its sum. BloomConvolutionSize is the width of its picture as a part of the view's width
// (the height follows the picture), BloomConvolutionCenterUV the point of it that lies on the source of light.
// BloomConvolutionTexture None: "Builtin/Airy" (BuiltinTextures.h).
//
// Pre-filter, on luminance L in scene units: above BloomConvolutionPreFilterMin a pixel is scaled to the luminance
// min(Mult * (L - Min) + Min, Max); not at all where Max <= Min. The added light is not taken from the scene colour.
//
// The transform is circular: the picture is padded by half of min(BloomConvolutionSize, BloomConvolutionBufferScale) of
// its width (0 as a buffer scale: by half of the size), and what reaches farther comes in at the other side, as in the
// engine. A line of picture and padding is at most 4096 long, or as long as the picture. The transform limits padding
// and kernel to what reaches from one end of the picture to the other (2 * size - 1 pixels): the rest moves energy out
// of the picture and is counted, not convolved with.
//
// Contract. Bloom is PF_FloatRGBA (PF_A32B32G32R32F for such a scene colour), alpha 0, at r.Bloom.ScreenPercentage of
// the view. Scene colour that is NaN, or below -65504, counts as 0; above 65504 (infinity too) as 65504; so the result
// is finite, and one bad pixel changes no other. Smaller negative values pass. Rounding leaves up to some 1e-6 of the
// largest bloom, of either sign, where exact bloom is 0. Kernel texels that are NaN or negative count as 0. A kernel
// that is black, or a single texel, gives no bloom and leaves the scene colour. Any size from 1x1 up; the same bits for
// any number of threads.
#pragma once

#include "CoreMinimal.h"
#include "PostProcessSettings.h"
#include "ScreenPass.h"

#include <string>

class FRDGBuilder;
class FViewInfo;

struct FFFTBloomInputs
{
	/** [Required] Linear, pre-exposed, at the view's resolution. */
	FScreenPassTexture SceneColor;
	/** [Optional] The same at half and quarter resolution, read where bloom has no more than that. */
	FScreenPassTexture HalfResolution;
	FScreenPassTexture QuarterResolution;
};

struct FFFTBloomOutput
{
	/** The bloom for the tonemapper to add, energy applied. */
	FScreenPassTexture BloomTexture;
	/** Entry 0's rgb multiplies scene colour. */
	FRDGBufferRef SceneColorApplyParameters = nullptr;
};

/** Whether the view has FFT bloom: BM_FFT, an intensity above 0, a view state, and pixels for the kernel. */
DRYDOCK_API bool IsFFTBloomEnabled(const FViewInfo& View);

/** r.Bloom.ScreenPercentage as a factor of the view's resolution, within 0.1..1. */
DRYDOCK_API float GetFFTBloomResolutionFraction(FIntPoint ViewSize);

/** Settings come from View.FinalPostProcessSettings; the kernel must have pixels. */
DRYDOCK_API FFFTBloomOutput AddFFTBloomPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FFFTBloomInputs& Inputs);

namespace Drydock
{

/** Why settings that ask for BM_FFT get the sum of Gaussians in its place; empty: they do not. */
DRYDOCK_API std::string GetFFTBloomObstacle(const FFinalPostProcessSettings& Settings, bool bHasViewState);

/** SceneColor times what FFT bloom left of it, for those that composite bloom themselves. Same format. */
DRYDOCK_API FScreenPassTexture AddApplyFFTBloomPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& SceneColor, FRDGBufferRef SceneColorApplyParameters);

/** Pixels that are added to each axis of a picture of this size. */
DRYDOCK_API int32 ComputeFFTBloomPadding(FIntPoint ImageSize, float Size, float BufferScale);

} // namespace Drydock
