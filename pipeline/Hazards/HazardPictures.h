// Hazards as pictures: the inputs that the stability table's passes are run with, and those of `drydock hazards`.
#pragma once

#include "Hazards/Hazards.h"
#include "Picture/ImageFile.h"

#include <vector>

namespace Drydock
{

struct FHazardPicture
{
	FImage Picture;        // RGBA, linear
	FImage Clean;          // the same without the hazard; itself where the whole picture is the hazard
	bool bFloat32 = false; // half floats do not hold it
};

/** One picture, or several where a hazard is several cases: 65520 and 65519, denormals of floats and of halves,
 * positions of a moving light. None for a hazard that has no picture of its own. X, Y: the pixel that differs from the
 * others, with one at its right (checked for the moving light). */
DRYDOCK_API std::vector<FHazardPicture> MakeHazardPictures(EHazard Hazard, int Width, int Height, int X, int Y);

/** Multiples of 1/64 in 0..1, alpha 1: exact in every float format, the same at every call. */
DRYDOCK_API FImage MakeHazardNoise(int Width, int Height);

} // namespace Drydock
