// Distance of a point to the convex hull of other points. Source: Gilbert, Johnson, Keerthi, "A fast procedure for
// computing the distance between complex objects in three-dimensional space", 1988; the corners that carry the nearest
// point are found by trying all of them instead of by Johnson's recursion.
#pragma once

#include "CoreMinimal.h"

#include <vector>

namespace Drydock
{

/** 0 inside, else exact but for rounding: the error is some 1e-15 of the largest distance between Point and a corner,
 * and what lies below that counts as inside. Corners may lie in a plane, on a line, on one point, and repeat. Infinite
 * without corners. */
DRYDOCK_API double GetDistanceToHull(const std::vector<FVector>& Corners, const FVector& Point);

} // namespace Drydock
