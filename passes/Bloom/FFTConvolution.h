// Convolution of pictures through their spectra, as graph passes: forward transform of both, product, inverse. It is
// circular: what leaves the transform's extent on one side comes in on the other. The parts are those
// of the engine's GPUFastFourierTransform.h.
//
// Spectra are textures of four floats (PF_A32B32G32R32F). Along the axis that is transformed first a picture is real,
// so half of its frequencies say all: frequency k lies at texels 2k (real part) and 2k + 1 (imaginary part), k from 0
// to half of the size; that is the size + 2 texels. Red, green and blue are transformed, alpha is 0.
//
// Contract. Lines are transformed in double arithmetic and stored as the texture stores them. A finite input whose
// product stays below the largest float gives a finite output; one NaN or infinity spoils all of it. The error is below
// 1e-6 of the root of (sum of squares of the picture times that of the kernel). The same bits for any number of
// threads.
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

/** Sizes that belong to a transform. */
struct FFFTDomain
{
	FIntPoint ImageSize = FIntPoint(1, 1);
	/** Powers of two, at least 2. */
	FIntPoint FrequencySize = FIntPoint(2, 2);
	/** The axis that is transformed first: the one that leaves less to be stored in between. */
	bool bHorizontalFirst = true;

	/** FrequencySize: the next powers of two of MinSize, which is at least ImageSize. */
	DRYDOCK_API static FFFTDomain Make(FIntPoint ImageSize, FIntPoint MinSize);

	/** Texels of a spectrum. */
	DRYDOCK_API FIntPoint GetSpectrumExtent() const;

	bool operator==(const FFFTDomain& Other) const
	{
		return ImageSize == Other.ImageSize && FrequencySize == Other.FrequencySize &&
			   bHorizontalFirst == Other.bHorizontalFirst;
	}
};

/** Two passes. Image: PF_A32B32G32R32F, a rect of at most FrequencySize; beyond it lies black. Name: of the spectrum;
 * kept as a pointer. */
DRYDOCK_API FRDGTextureRef AddForwardFFTPasses(
	FRDGBuilder& GraphBuilder, const FFFTDomain& Domain, const FScreenPassTexture& Image, const TCHAR* Name);

/** Product of two spectra of one domain. FFTMulParameters: a structured buffer of one float4 that multiplies it. */
DRYDOCK_API FRDGTextureRef AddMultiplySpectraPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FFFTDomain& Domain, FRDGTextureRef ImageSpectrum, FRDGTextureRef KernelSpectrum,
	FRDGBufferRef FFTMulParameters);

/** Two passes. Output: any format that can be a UAV; its rect, of at most FrequencySize, is filled from the transform's
 * origin on, alpha 0. */
DRYDOCK_API void AddInverseFFTPasses(
	FRDGBuilder& GraphBuilder, const FFFTDomain& Domain, FRDGTextureRef Spectrum, const FScreenPassTexture& Output);

} // namespace Drydock
