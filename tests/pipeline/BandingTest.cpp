// Banding figures on images small enough to count by hand.
#include <gtest/gtest.h>

#include "Banding.h"

#include <cmath>
#include <limits>

using namespace Drydock;

namespace
{

FImage Row(const std::vector<double>& Values)
{
	return {static_cast<int>(Values.size()), 1, 1, Values};
}

/** A ramp of 256 texels over a range, rounded to 8 bit, as itself or as its root. */
FImage Ramp(double Greatest, bool bRoot)
{
	std::vector<double> Values;
	for (int X = 0; X < 256; ++X)
	{
		const double Value = Greatest * X / 255;
		const double Stored = std::round((bRoot ? std::sqrt(Value) : Value) * 255) / 255;
		Values.push_back(bRoot ? Stored * Stored : Stored);
	}
	return Row(Values);
}

} // namespace

TEST(Banding, LevelsAreCountedOnce)
{
	EXPECT_EQ(3u, MeasureBanding(Row({0, 0.5, 1, 0.5, 0}), 0).UniqueLevels);
	EXPECT_EQ(2u, MeasureBanding(Row({0, 0.04, 0.05, 1, 0.04}), 0).DarkLevels);
}

TEST(Banding, LongestFlatRunLeavesOutTheEnds)
{
	// The zeros and ones are the ends of the gradient; three halves lie within it.
	EXPECT_EQ(3, MeasureBanding(Row({0, 0, 0, 0, 0.25, 0.5, 0.5, 0.5, 1, 1, 1, 1, 1}), 0).LongestFlatRun);
}

TEST(Banding, ColumnsCountAsRowsDo)
{
	const FImage Image{1, 6, 1, {0, 0.5, 0.5, 0.5, 0.5, 1}};
	EXPECT_EQ(4, MeasureBanding(Image, 0).LongestFlatRun);
}

TEST(Banding, StepsFallIntoTheirBins)
{
	// 0, 1/255, 3/255, 3/255, 13/255: steps of 1, 2, 0 and 10.
	const FBandingFigures Figures = MeasureBanding(Row({0, 1 / 256.0, 3 / 256.0, 3 / 256.0, 13 / 256.0}), 0);
	EXPECT_EQ(1u, Figures.StepHistogram[0]); // none
	EXPECT_EQ(1u, Figures.StepHistogram[3]); // up to 1
	EXPECT_EQ(1u, Figures.StepHistogram[4]); // up to 2
	EXPECT_EQ(1u, Figures.StepHistogram[7]); // above 8
}

TEST(Banding, OnlyTheChannelAskedForCounts)
{
	const FImage Image{2, 1, 2, {0, 5, 0, 7}};
	EXPECT_EQ(1u, MeasureBanding(Image, 0).UniqueLevels);
	EXPECT_EQ(2u, MeasureBanding(Image, 1).UniqueLevels);
}

TEST(Banding, ConstantAndEmptyImages)
{
	EXPECT_EQ(0, MeasureBanding(Row({0.5, 0.5, 0.5}), 0).LongestFlatRun);
	EXPECT_EQ(0u, MeasureBanding(FImage(), 0).UniqueLevels);
}

TEST(Banding, NaNIsNoLevelAndNoStep)
{
	const FBandingFigures Figures = MeasureBanding(Row({0, std::numeric_limits<double>::quiet_NaN(), 1}), 0);
	EXPECT_EQ(2u, Figures.UniqueLevels);
	uint64_t Steps = 0;
	for (const uint64_t Count : Figures.StepHistogram)
	{
		Steps += Count;
	}
	EXPECT_EQ(0u, Steps);
}

TEST(Banding, FiguresOrderTheStoresOfADarkRamp)
{
	// A ramp to 1/20 has 13 levels of 8 bit, and 57 squares of them.
	const FBandingFigures Linear = MeasureBanding(Ramp(0.05, false), 0);
	const FBandingFigures Root = MeasureBanding(Ramp(0.05, true), 0);
	EXPECT_LE(Linear.UniqueLevels, 14u);
	EXPECT_GE(Root.UniqueLevels, 50u);
	EXPECT_GT(Linear.LongestFlatRun, Root.LongestFlatRun);
}

TEST(Banding, MapIsRedAtStepsAndGreenInBands)
{
	const FImage Map = MakeBandingMap(Row({0, 0.5, 0.5, 1}), 0);
	EXPECT_EQ(3, Map.NumChannels);
	EXPECT_EQ(1.0, Map.Get(1, 0, 0));                    // a step
	EXPECT_GT(Map.Get(2, 0, 1), Map.Get(2, 0, 0) + 0.2); // within a band
	EXPECT_EQ(Map.Get(0, 0, 0), Map.Get(0, 0, 1));       // outside the gradient
}
