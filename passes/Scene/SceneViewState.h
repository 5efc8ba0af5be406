// What of a view lives on from frame to frame, as passes see it; each effect has a member of its own. pipeline/ keeps
// one for each view. Source: engine file ScenePrivate.h (FSceneViewState).
#pragma once

#include "FFTConvolution.h"
#include "RHIResources.h"
#include "RenderGraphResourcePool.h"
#include "RendererInterface.h"
#include "SceneView.h"

/** The kernel of FFT bloom, transformed, and what it was made from. */
struct FBloomFFTKernel
{
	/** Held, so that no other texture gets its address. */
	FTextureRHIRef Texture;
	uint32 NumMips = 0;
	float Size = 0.0f;
	FVector2D CenterUV = FVector2D(0.0, 0.0);
	Drydock::FFFTDomain Domain;
	/** r.Drydock.Storage. */
	int32 Storage = 0;

	/** Written when the graph that makes them has run; null until then. */
	TRefCountPtr<IPooledRenderTarget> Spectrum;
	TRefCountPtr<FRDGPooledBuffer> Constants;

	bool IsMadeFrom(const FBloomFFTKernel& Other) const
	{
		return Texture == Other.Texture && NumMips == Other.NumMips && Size == Other.Size &&
			   CenterUV == Other.CenterUV && Domain == Other.Domain && Storage == Other.Storage;
	}
};

class DRYDOCK_API FSceneViewState : public FSceneViewStateInterface
{
public:
	explicit FSceneViewState(uint32 InKey)
		: Key(InKey)
	{
	}
	uint32 GetViewKey() const override { return Key; }

	FBloomFFTKernel BloomFFTKernel;

	/** The frame's exposure (PostProcessEyeAdaptation.h): the next one adapts from it. Null before the first. */
	TRefCountPtr<FRDGPooledBuffer> EyeAdaptation;

	/** Read by the next frame's reflections in place of scene colour, where an extension made it. */
	TRefCountPtr<IPooledRenderTarget> CustomSSRInput;

private:
	uint32 Key;
};
