// Blurs of standard deviation s as plain code in double, without graph and shaders: the exact Gaussian that all are
// measured against, and algorithms that no shader of the engine's kind can run. Images are interleaved, any number of
// channels; outside lies the edge texel, without end. Tiles of lines run on all threads; the same bits for any number.
// A value that is not finite spoils its row and column. Each function names its paper.
#pragma once

#include "Picture/ImageFile.h"

namespace Drydock
{

/** The exact Gaussian: weights exp(-x^2 / 2 s^2) at whole x, normalised, out to where the rest is below 2^-60 of the
 * sum; what the edge texel adds beyond the image is summed with it. Separable, which changes nothing but rounding. 0
 * and below: the image. */
DRYDOCK_API FImage BlurExact(const FImage& Image, double StandardDeviation);

/** Three running averages over windows whose ends count by a fraction, so that the variances add up to the wanted one.
 * Source: the extended box filter of Gwosdek, Grewenig, Bruhn, Weickert, "Theoretical Foundations of Gaussian
 * Convolution by Extended Box Filtering", 2011; end weights derived from the second moment. */
DRYDOCK_API FImage BlurBoxes(const FImage& Image, double StandardDeviation);

/** A recursive filter of third order, forth and back. Source: Young, van Vliet, van Ginkel, "Recursive Gabor
 * Filtering", IEEE Transactions on Signal Processing 50(11), 2002 (the poles); their scale follows from the second
 * moment, which has a closed form; what the filter does beyond the edge is found by running it there once (the problem
 * that Triggs and Sdika solved in 2006). At least 0.5 pixels. */
DRYDOCK_API FImage BlurRecursive(const FImage& Image, double StandardDeviation);

/** What the above read and write per pixel. */
struct FNativeBlurCost
{
	double Taps = 0.0;        // values read by the arithmetic
	double TexelsMoved = 0.0; // read from and written to memory, each once per pass over the image
};
DRYDOCK_API FNativeBlurCost GetExactCost(double StandardDeviation);
DRYDOCK_API FNativeBlurCost GetBoxesCost();
DRYDOCK_API FNativeBlurCost GetRecursiveCost();

} // namespace Drydock
