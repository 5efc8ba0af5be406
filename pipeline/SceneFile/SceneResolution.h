// Renders the scene at another resolution than the output: places a view's pixels in smaller (or larger) scene
// textures, and resamples the file's pixels. Colour is averaged over the area that a pixel covers, as if the renderer
// had taken more samples; everything else (depth, normals, ids, velocity, shadow) is taken at the pixel's centre, as it
// would have been rendered. Pure functions. Rounding up is the engine's.
#pragma once

#include "CoreMinimal.h"

#include <vector>

namespace Drydock
{

/** Both counted from the picture's corner. */
struct FSceneRegion
{
	FIntRect Source; // in the file
	FIntRect Target; // in the scene textures
};

/** Edges times Percentage / 100, rounded up; at least one pixel. Rects that touch still touch. */
DRYDOCK_API FIntRect ScaleRect(const FIntRect& Rect, double Percentage);

/** Source pixels that a target pixel covers along one axis, with the part of it that each has; the parts sum to 1. */
struct FCoverage
{
	int First = 0;
	std::vector<double> Parts;
};

/** Coverage of target pixel Index of TargetSize, which cover SourceSize pixels evenly. */
DRYDOCK_API FCoverage MakeCoverage(int SourceSize, int TargetSize, int Index);

/** The source pixel that holds the centre of a target pixel. */
DRYDOCK_API int FindCenterPixel(int SourceSize, int TargetSize, int Index);

} // namespace Drydock
