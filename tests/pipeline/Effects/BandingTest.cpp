// Banding figures on images small enough to count by hand.
#include <gtest/gtest.h>

#include "Effects/Banding.h"

#include <cmath>
#include <limits>

using namespace Drydock;

namespace
{

FImage Row(const std::vector<double>& Values)
{
	return {static_cast<int>(Values.size()), 1, 1, Values};
}

/** A ramp over a range, rounded to 8 bit, as itself or as its root. */
FImage Ramp(double Greatest, bool bRoot, int Width = 256)
{
	std::vector<double> Values;
	for (int X = 0; X < Width; ++X)
	{
		const double Value = Greatest * X / (Width - 1);
		const double Stored = std::round((bRoot ? std::sqrt(Value) : Value) * 255) / 255;
		Values.push_back(bRoot ? Stored * Stored : Stored);
	}
	return Row(Values);
}

/** The same, not rounded. */
FImage ExactRamp(double Greatest, int Width)
{
	std::vector<double> Values;
	for (int X = 0; X < Width; ++X)
	{
		Values.push_back(Greatest * X / (Width - 1));
	}
	return Row(Values);
}

/** As a chain of 8-bit temporaries leaves it: each block of texels has one value, rounded. */
FImage Mosaic(double Greatest, int Width, int Block)
{
	std::vector<double> Values;
	for (int X = 0; X < Width; ++X)
	{
		Values.push_back(std::round(Greatest * (X / Block * Block) / (Width - 1) * 255) / 255);
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

TEST(BandingDeviation, IsTheRootMeanSquareInSteps)
{
	// Errors of 3, 0 and 4 steps: sqrt(25 / 3).
	const FDarkDeviation Deviation =
		MeasureDarkDeviation(Row({4 / 255.0, 2 / 255.0, 7 / 255.0}), Row({1 / 255.0, 2 / 255.0, 3 / 255.0}), 0);
	EXPECT_NEAR(std::sqrt(25.0 / 3.0), Deviation.Rms, 1e-12);
	EXPECT_NEAR(4.0, Deviation.Largest, 1e-12);
	EXPECT_EQ(3u, Deviation.Texels);
}

TEST(BandingDeviation, OnlyTheDarkGradientCounts)
{
	// Black is no gradient, 1/20 and above is not dark, NaN is nothing.
	const double NaN = std::numeric_limits<double>::quiet_NaN();
	const FDarkDeviation Deviation = MeasureDarkDeviation(Row({1, 1, 1, 0.5}), Row({0, 0.05, 0.6, NaN}), 0);
	EXPECT_EQ(0u, Deviation.Texels);
	EXPECT_EQ(0.0, Deviation.Rms);
}

TEST(BandingDeviation, OfNothingIsNothing)
{
	EXPECT_EQ(0.0, MeasureDarkDeviation(ExactRamp(1, 256), ExactRamp(1, 256), 0).Largest);
	EXPECT_EQ(0u, MeasureDarkDeviation(FImage(), FImage(), 0).Texels);
}

TEST(BandingDeviation, RoundingARampGivesOneOverTheRootOfTwelve)
{
	// Errors spread evenly over half a step either way: variance 1/12.
	const FDarkDeviation Deviation =
		MeasureDarkDeviation(Ramp(10 / 255.0, false, 10001), ExactRamp(10 / 255.0, 10001), 0);
	EXPECT_NEAR(1 / std::sqrt(12.0), Deviation.Rms, 0.003);
	EXPECT_NEAR(0.5, Deviation.Largest, 0.001);
}

TEST(BandingDeviation, RoundingTheRootGivesLessInTheDark)
{
	// A step of the root r is 2 r steps of the value v = r * r: variance 4 v / 12, of which the mean over 0..1/20 is
	// 4 * 0.025 / 12; the largest is half a step at 1/20.
	const FDarkDeviation Deviation = MeasureDarkDeviation(Ramp(0.05, true, 10001), ExactRamp(0.05, 10001), 0);
	EXPECT_NEAR(std::sqrt(4 * 0.025 / 12), Deviation.Rms, 0.003);
	EXPECT_NEAR(std::sqrt(0.05), Deviation.Largest, 0.01);
}

TEST(BandingDeviation, OrdersMosaicBandsAndSmooth)
{
	// Over 10000 texels 12.75 steps, so blocks of 2000 are 2.55 steps wide.
	const FImage Exact = ExactRamp(0.05, 10001);
	const double OfMosaic = MeasureDarkDeviation(Mosaic(0.05, 10001, 2000), Exact, 0).Rms;
	const double OfBands = MeasureDarkDeviation(Ramp(0.05, false, 10001), Exact, 0).Rms;
	const double OfSmooth = MeasureDarkDeviation(Ramp(0.05, true, 10001), Exact, 0).Rms;
	EXPECT_GT(OfMosaic, 2 * OfBands);
	EXPECT_GT(OfBands, 2 * OfSmooth);
}
