// Fills a scene texture from the planes of a file: row by row, or at another resolution pixel by pixel.
#pragma once

#include "Picture/ImageReader.h"
#include "RHITexture.h"
#include "SceneFile/NonFinite.h"
#include "SceneFile/SceneResolution.h"
#include "SceneFile/SceneTexturePacking.h"

#include <array>
#include <vector>

namespace Drydock
{

/** Source of one slot of a packing. */
struct FSceneFillSource
{
	const FImagePlane* Plane = nullptr; // null: Default everywhere
	float Default = 0.0f;
};

using FNonFiniteSlots = std::array<FNonFiniteCount, std::tuple_size_v<FScenePackValues>>;

struct FSceneFillInputs
{
	const FScenePacking& Packing;
	std::vector<FSceneFillSource> Sources; // one to a slot in use
	int Width = 0;                         // of the planes
	FScenePackContext Context;
	std::vector<FSceneRegion> Regions; // what lies outside of them is padding
	FIntPoint Corner;                  // of the picture in the texture
};

/** Writes every texel of the texture, under r.Drydock.NonFinite and, for scene colour, r.Drydock.SceneColorClamp.
 * Returns the values that are not finite, by slot, in pixels of the file; depth that is infinitely far is not among
 * them. */
FNonFiniteSlots FillSceneTexture(FRHITexture& Texture, const FSceneFillInputs& Inputs);

} // namespace Drydock
