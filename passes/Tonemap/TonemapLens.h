// Holds the parameters of the lens and sensor effects before the film curve. Pure functions from settings to what the
// shader reads. Source: engine file PostProcessTonemap.cpp.
#pragma once

#include "CoreMinimal.h"
#include "PixelFormat.h"
#include "RHIResources.h"
#include "PostProcessSettings.h"

namespace Drydock
{

/** Viewport position (-1..1) to vignette space: the corner is at sqrt(2) for any aspect ratio. */
DRYDOCK_API FVector2f ComputeVignetteScale(FIntPoint ViewSize);

/** x, y: shift of red and green against blue in viewport positions (-1..1), at 1 beyond the start; z: where it begins.
 * Intensity: percent. Primaries of 611.3, 549.1 and 464.3 nm; 0 where StartOffset is 1. */
DRYDOCK_API FVector4f ComputeChromaticAberration(float Intensity, float StartOffset);

/** Whether a fringe of this intensity is built at all: above 0.01, as in the engine. */
DRYDOCK_API bool HasChromaticAberration(const FPostProcessSettings& Settings);

/** Sharpen of the settings; r.Tonemapper.Sharpen, 0 to 10, in its place where it is not below 0. */
DRYDOCK_API float GetSharpenAmount(const FPostProcessSettings& Settings);

struct FFilmGrain
{
	FVector3f Intensities; // of shadows, midtones, highlights
	FVector4f Ranges;      // where shadows end, highlights begin and are full; texels of grain per pixel
	uint32 Frame = 0;      // of the noise's sequence
};

/** Frames repeat after r.FilmGrain.SequenceLength. */
DRYDOCK_API FFilmGrain MakeFilmGrain(const FPostProcessSettings& Settings, uint32 FrameNumber);

/** Whether there is any: intensity above 0 and r.FilmGrain 1. */
DRYDOCK_API bool HasFilmGrain(const FPostProcessSettings& Settings);

/** The picture that becomes grain: it is repeated over the view, and divided by its mean so that the light stays.
 * Source: descriptions of r.FilmGrain.SequenceLength and r.FilmGrain.CacheTextureConstants; dividing by the mean is
 * drydock's reading. */
struct FFilmGrainPicture
{
	FVector2f UVPerPixel;  // of FilmGrainTexelSize
	FVector2f UVOffset;    // whole texels, by the Halton sequence of the frame
	FVector3f MeanInverse; // by channel; 0 where the mean is not above 0
};

DRYDOCK_API FFilmGrainPicture MakeFilmGrainPicture(const FFilmGrain& Grain, FRHITexture& Picture);

/** Between two codes of an output of 8 or 10 bits, over which r.Tonemapper.GrainQuantization spreads the values between
 * them; 0: it does not, or the output is none of these. */
DRYDOCK_API float GetGrainQuantizationStep(EPixelFormat OutputFormat);

} // namespace Drydock
