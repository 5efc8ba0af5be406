// Measures how smooth a gradient is after it has been stored: counts that order the pictures of one gradient in
// different formats, and a map that shows where the bands lie.
#pragma once

#include "Picture/ImageFile.h"

#include <array>
#include <cstdint>

namespace Drydock
{

/** Steps between neighbours, in 1/255: none, up to 1/4, 1/2, 1, 2, 4, 8, and above. */
constexpr std::array<double, 7> BandingStepBounds = {0.0, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0};

/** A gradient below this counts as dark, for an eye and for these figures. */
constexpr double DarkBelow = 0.05;

struct FBandingFigures
{
	/** Different values. NaN counts as none. */
	uint64_t UniqueLevels = 0;
	/** Those of them below DarkBelow, where an eye sees bands first. */
	uint64_t DarkLevels = 0;
	/** Texels in a row or column that have one value, strictly between the least and the greatest of the image. */
	int LongestFlatRun = 0;
	/** Pairs of horizontal and vertical neighbours by the size of their difference. */
	std::array<uint64_t, BandingStepBounds.size() + 1> StepHistogram = {};
};

/** Measures one channel. */
DRYDOCK_API FBandingFigures MeasureBanding(const FImage& Image, int Channel);

/** Deviation of a stored gradient from the exact one in its dark part (0 is not part of a gradient, and does not
 * count), in steps of 1/255. Rounding to 8 bit gives an Rms of 1 / sqrt(12) = 0.29, rounding the root less; errors that
 * pile up from one rounded temporary to the next, or that a coarse one spreads over blocks of texels, more. */
struct FDarkDeviation
{
	double Rms = 0.0;
	double Largest = 0.0;
	uint64_t Texels = 0; // that count
};

/** Measures one channel of two images of one size, both decoded to what lighting reads. */
DRYDOCK_API FDarkDeviation MeasureDarkDeviation(const FImage& Stored, const FImage& Exact, int Channel);

/** Red: the value steps here, green: it is as its neighbours and lies within a gradient, so that bands are green
 * between red lines and a smooth gradient is red all over; the value itself beneath, in grey. */
DRYDOCK_API FImage MakeBandingMap(const FImage& Image, int Channel);

} // namespace Drydock
