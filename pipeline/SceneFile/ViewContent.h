// Measures a view's part of the scene, as far as it can leave out or confine an effect's passes: the third and the
// fourth gate (settings, the graph's outputs, content, region, loading). Measured on the file's own channels before the
// graph is built; only the questions of effects that the settings call for are answered.
#pragma once

#include "CoreMinimal.h"

#include <optional>

namespace Drydock
{

/** The contents that have to be looked at. */
struct FContentQuestions
{
	bool bToon = false;      // shadingmodel.ID
	bool bGlowMask = false;  // custommask.B
	bool bStill = false;     // velocity.X, velocity.Y
	bool bBrightest = false; // R, G, B

	bool Any() const { return bToon || bGlowMask || bStill || bBrightest; }
};

/** The answers; empty: not asked, or the file does not say. Rects count from the view's corner in the scene textures;
 * one without area: there is no such pixel. */
struct FViewContent
{
	/** Size of the view in the scene textures, pixels. */
	FIntPoint Size = FIntPoint(0, 0);
	/** Bounds of what is shaded as cloth (SHADINGMODELID_CLOTH, the toon mark). */
	std::optional<FIntRect> Toon;
	/** Bounds of a mask that is not 0; the whole view where a value in sight is not a multiple of 1/255: not finite, or
	 * below 1/256, where running sums of it would not be exact. */
	std::optional<FIntRect> GlowMask;
	/** Every velocity is 0. */
	std::optional<bool> bStill;
	/** Largest of R, G and B, not exposed; empty where one is not finite. */
	std::optional<double> Brightest;
};

} // namespace Drydock
