// Measures how much bloom lands outside the toon pixels, and how much inside.
//
// Formula, over all pixels of the view: energy = luminance(0.3, 0.59, 0.11) of the bloom texel that the pixel's centre
// lies in, as the tonemapper gets it, over PreExposure; a pixel is inside where its shading model id is cloth. Texels
// that are not finite count as 0.
#pragma once

#include "DrydockAPI.h"
#include "Picture/ImageFile.h"

namespace Drydock
{

struct FToonBleed
{
	double Outside = 0.0;
	double Inside = 0.0;

	/** Outside / inside; 0 when there is nothing inside. */
	double GetRatio() const { return Inside > 0.0 ? Outside / Inside : 0.0; }
};

/** Bloom: three channels at least, of any size. Alpha: G-buffer B's, one channel, one value for each pixel. */
DRYDOCK_API FToonBleed MeasureToonBleed(const FImage& Bloom, const FImage& Alpha, double PreExposure);

} // namespace Drydock
