// Blurs of standard deviation s as plain code, without graph and shaders: the exact Gaussian in double that all are
// measured against, and, in float lanes as shaders run, algorithms that no shader of the engine's kind can run. Outside
// lies the edge texel, without end. Tiles of lines run on all threads; the same bits for any number of them and for any
// lane width. Each function names its paper.
#pragma once

#include "Picture/ImageFile.h"

#include <vector>

namespace Drydock
{

/** The exact Gaussian: weights exp(-x^2 / 2 s^2) at whole x, normalised, out to where the rest is below 2^-60 of the
 * sum; what the edge texel adds beyond the image is summed with it. Separable, which changes nothing but rounding. 0
 * and below: the image. Any number of channels. A value that is not finite spoils its row and column. */
DRYDOCK_API FImage BlurExact(const FImage& Image, double StandardDeviation);

/** RGBA, row-major. */
struct FFloatImage
{
	int Width = 0;
	int Height = 0;
	std::vector<float> Values;
};

/** Converts an image of four channels; rounded to nearest. */
DRYDOCK_API FFloatImage ToFloatImage(const FImage& Image);
DRYDOCK_API FImage ToImage(const FFloatImage& Image);

/** Three running averages over windows whose ends count by a fraction, so that the variances add up to the wanted one.
 * In place. 0 and below: nothing happens.
 *
 * Rounding: sums are compensated, so the result is within 4e-6 of the largest value around of what doubles give,
 * however wide the blur. A value that is not finite makes not finite what its windows reach, along both axes. Denormals
 * count as 0.
 *
 * Source: the extended box filter of Gwosdek, Grewenig, Bruhn, Weickert, "Theoretical Foundations of Gaussian
 * Convolution by Extended Box Filtering", 2011; end weights derived from the second moment. */
DRYDOCK_API void BlurBoxes(FFloatImage& Image, double StandardDeviation);

/** A recursive filter of third order, forth and back, as sections of first and second order. In place. 0 and below:
 * nothing happens; else at least 0.5 pixels.
 *
 * Rounding: the sections take differences, so a constant stays that constant at every width; other pictures are within
 * 4e-6 of their largest value of what doubles give, up to a deviation of 500 at least. A value that is
 * not finite spoils its row and column. Denormals count as 0.
 *
 * Source: Young, van Vliet, van Ginkel, "Recursive Gabor Filtering", IEEE Transactions on Signal Processing 50(11),
 * 2002 (the poles); their scale follows from the second moment, which has a closed form; what the filter does beyond
 * the edge is found by running it there once (the problem that Triggs and Sdika solved in 2006). */
DRYDOCK_API void BlurRecursive(FFloatImage& Image, double StandardDeviation);

/** The values that the blurs above read and write per pixel. */
struct FNativeBlurCost
{
	double Taps = 0.0;        // values read by the arithmetic
	double TexelsMoved = 0.0; // read from and written to memory, each once per pass over the image
};
DRYDOCK_API FNativeBlurCost GetExactCost(double StandardDeviation);
DRYDOCK_API FNativeBlurCost GetBoxesCost();
DRYDOCK_API FNativeBlurCost GetRecursiveCost();

} // namespace Drydock
