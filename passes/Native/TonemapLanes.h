// Runs the tonemapper with its combined table on lanes, from those of a pass's parameters that a tile needs, as plain
// data.
//
// Contract. Stored are the bits that PostProcessTonemap.usf stores, for every lane width, tiling and thread count; a
// NaN is a NaN, of any payload.
#pragma once

#include "Native/LocalExposureLanes.h"

namespace Drydock
{

/** Parts whose flag is not set are left out, as the shader's permutations leave them out. */
struct FTonemapJob
{
	uint64_t Pass = 0;     // a number that no other pass has
	int64_t NumPixels = 0; // of the whole pass
	FViewportAxis Viewport[2];
	FSampledTexture Color;
	float Exposure = 1.0f;
	float ColorScale[3] = {1.0f, 1.0f, 1.0f};

	bool bFringe = false;
	float FringeShifts[2] = {}; // of red and green
	float FringeStart = 0.0f;

	bool bSharpen = false;
	float SharpenAmount = 0.0f;
	float NeighborSteps[2] = {};

	bool bVignette = false;
	float VignetteScale[2] = {};
	float VignetteIntensity = 0.0f;

	bool bLocalExposure = false;
	FLocalExposureJob LocalExposure;

	bool bBloom = false;
	FSampledTexture Bloom;

	bool bFilmGrain = false;
	float GrainIntensities[3] = {};
	float GrainRanges[4] = {};
	uint32_t GrainFrame = 0;

	const FKernelTexture* Table = nullptr; // sampled clamped
	float TableSize = 0.0f;
	float LumaToAlpha = 0.0f;
};

template<int N>
struct TTonemapLanes
{
	/** Pixels: of the target, inside it, and those that the viewport counts. False, with nothing stored, where a place
	 *  is out of reach. */
	[[gnu::weak]] static bool Run(const FTonemapJob& Job, const FKernelTexture& Target, const FKernelTile& Pixels);
};

} // namespace Drydock
