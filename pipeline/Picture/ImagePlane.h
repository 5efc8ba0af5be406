// One channel of an image file as it is stored. It stands apart from ImageReader.h because Imath's half.h takes long to
// compile.
#pragma once

#include <Imath/half.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace Drydock
{

/** One channel of a picture, row-major, in the width that it is stored in. */
struct FImagePlane
{
	std::vector<uint16_t> Halves; // where the file has half floats
	std::vector<float> Floats;    // otherwise; whole numbers as parts of the greatest

	float Get(size_t Pixel) const { return Halves.empty() ? Floats[Pixel] : imath_half_to_float(Halves[Pixel]); }

	/** Converts the values to floats, and keeps them so. */
	void MakeFloats()
	{
		if (!Halves.empty())
		{
			Floats.resize(Halves.size());
			std::transform(Halves.begin(), Halves.end(), Floats.begin(), imath_half_to_float);
			Halves = {};
		}
	}
};

} // namespace Drydock
