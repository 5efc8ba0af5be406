// Runs the bloom setup on lanes, from those of a pass's parameters that a tile needs, as plain data.
//
// Contract. Stored are the bits that PostProcessBloom.usf stores, for every lane width, tiling and thread count; a NaN
// is a NaN, of any payload.
#pragma once

#include "Native/LocalExposureLanes.h"

namespace Drydock
{

/** Parts whose flag is not set are left out, as the shader's permutations leave them out. */
struct FBloomSetupJob
{
	/** The input is sampled at the pixels' centres, as the transform in its axes maps them. */
	FSampledTexture Input;
	float OneOverPreExposure = 1.0f;
	float PreExposure = 1.0f;

	/** The toon's input, with its factor in it. */
	bool bToon = false;
	FSampledTexture Toon;
	float ToonIntensity = 1.0f;

	bool bThreshold = false;
	float Threshold = 0.0f;
	float ExposureScale = 1.0f;

	bool bLocalExposure = false;
	FViewportAxis LocalExposureViewport[2];
	FLocalExposureJob LocalExposure;
};

template<int N>
struct TBloomSetupLanes
{
	/** Pixels: of the target, inside it, and those that the viewport counts. False, with nothing stored, where a place
	 *  is out of reach. */
	[[gnu::weak]] static bool Run(const FBloomSetupJob& Job, const FKernelTexture& Target, const FKernelTile& Pixels);
};

} // namespace Drydock
