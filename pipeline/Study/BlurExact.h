// The exact Gaussian of standard deviation s in double, without graph and shaders: what all blurs are measured against.
// Outside lies the edge texel, without end. Tiles of lines run on all threads; the same bits for any number of them.
#pragma once

#include "Picture/ImageFile.h"

namespace Drydock
{

/** The exact Gaussian: weights exp(-x^2 / 2 s^2) at whole x, normalised, out to where the rest is below 2^-60 of the
 * sum; what the edge texel adds beyond the image is summed with it. Separable, which changes nothing but rounding. 0
 * and below: the image. Any number of channels. A value that is not finite spoils its row and column. */
DRYDOCK_API FImage BlurExact(const FImage& Image, double StandardDeviation);

/** The values that its arithmetic reads per pixel. */
DRYDOCK_API double GetExactTaps(double StandardDeviation);

} // namespace Drydock
