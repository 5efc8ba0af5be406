// The kernel of FFT bloom, from its picture to its spectrum and its energies. Inner to PostProcessFFTBloom.h.
// Source: engine files Bloom/*.usf (order and purpose of the passes).
#pragma once

#include "CoreMinimal.h"
#include "SceneViewState.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

/** Entries of the constants, float4 each. */
enum class EBloomKernelConstant : uint32
{
	Center,     // x, y of the brightest texel
	Total,      // sum of the texels, by channel
	Scatter,    // the same without the brightest texel
	MaxScatter, // largest values beside the brightest texel
	MAX
};

struct FBloomKernel
{
	FRDGTextureRef Spectrum = nullptr;
	FRDGBufferRef Constants = nullptr;
};

/** Made anew, or out of View's state where that holds what Wanted describes (its results are not looked at). */
FBloomKernel FindOrAddBloomKernel(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomFFTKernel& Wanted);

/** Size in pixels of the picture that a kernel texture covers. */
FVector2D GetBloomKernelSize(FIntPoint ImageSize, FIntPoint TextureSize, float Size);

} // namespace Drydock
