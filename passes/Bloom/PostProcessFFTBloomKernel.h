// The kernel of FFT bloom, from its picture to its spectrum and its energies. Inner to PostProcessFFTBloom.h.
// Source: engine files Bloom/*.usf (order and purpose of the passes).
#pragma once

#include "Bloom/FFTConvolution.h"
#include "CoreMinimal.h"
#include "RHIResources.h"
#include "RenderGraphResourcePool.h"
#include "RendererInterface.h"

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
	/** One float4, the sum of the whole kernel; null where the spectrum's frequency 0 is that. */
	FRDGBufferRef Sum = nullptr;
};

/** The kernel, transformed, and what it was made from: a cache of the view (ViewCaches.h). */
struct FBloomFFTKernel
{
	/** Held, so that no other texture gets its address. */
	FTextureRHIRef Texture;
	uint32 NumMips = 0;
	float Size = 0.0f;
	FVector2D CenterUV = FVector2D(0.0, 0.0);
	FFFTDomain Domain;
	/** The size that holds all of the kernel. The domain is smaller where parts of it are too far away to reach the
	 * picture. */
	FIntPoint WholeSize = FIntPoint(0, 0);
	/** r.Drydock.Storage. */
	int32 Storage = 0;

	/** Written when the graph that makes them has run; null until then. */
	TRefCountPtr<IPooledRenderTarget> Spectrum;
	TRefCountPtr<FRDGPooledBuffer> Constants;
	TRefCountPtr<FRDGPooledBuffer> Sum;

	bool IsCut() const { return WholeSize != Domain.FrequencySize; }
	bool IsMadeFrom(const FBloomFFTKernel& Other) const
	{
		return Texture == Other.Texture && NumMips == Other.NumMips && Size == Other.Size &&
			   CenterUV == Other.CenterUV && Domain == Other.Domain && WholeSize == Other.WholeSize &&
			   Storage == Other.Storage;
	}
};

/** Made anew, or out of View's state where that holds what Wanted describes (its results are not looked at). */
FBloomKernel FindOrAddBloomKernel(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FBloomFFTKernel& Wanted);

/** Size in pixels of the picture that a kernel texture covers. */
FVector2D GetBloomKernelSize(FIntPoint ImageSize, FIntPoint TextureSize, float Size);

} // namespace Drydock
