// Error figures against closed forms.
#include <gtest/gtest.h>

#include "Picture/ImageMetrics.h"

#include <cmath>
#include <limits>

using namespace Drydock;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

FImage MakeImage(int Width, int Height, int NumChannels, double Value)
{
	return {Width, Height, NumChannels, std::vector<double>(static_cast<size_t>(Width * Height * NumChannels), Value)};
}

FImage Row(const std::vector<double>& Values)
{
	return {static_cast<int>(Values.size()), 1, 1, Values};
}

} // namespace

TEST(ImageMetrics, EqualImagesHaveNoError)
{
	const FImage Image = Row({0.1, NaN, Infinity, 3.0});
	const FImageError Error = CompareImages(Image, Image);
	EXPECT_EQ(0.0, Error.Max);
	EXPECT_EQ(0.0, Error.Rms);
	EXPECT_EQ(0.0, Error.Relative);
	EXPECT_EQ(Infinity, Error.Psnr);
	EXPECT_DOUBLE_EQ(1.0, Error.Ssim);
	EXPECT_EQ(0u, Error.NumNonFinite);
}

TEST(ImageMetrics, ConstantDifferenceIsMaxAndRms)
{
	// Relative 0.125 / 0.5; PSNR 20 log10(1 / 0.125).
	const FImageError Error = CompareImages(MakeImage(7, 5, 3, 0.625), MakeImage(7, 5, 3, 0.5));
	EXPECT_EQ(0.125, Error.Max);
	EXPECT_EQ(0.125, Error.Rms);
	EXPECT_EQ(0.25, Error.Relative);
	EXPECT_NEAR(18.0617997398, Error.Psnr, 1e-9);
}

TEST(ImageMetrics, LargestErrorIsLocated)
{
	FImage A = MakeImage(4, 3, 2, 1.0);
	A.Values[(2 * 4 + 1) * 2 + 1] = 1.75;
	const FImageError Error = CompareImages(A, MakeImage(4, 3, 2, 1.0));
	EXPECT_EQ(0.75, Error.Max);
	EXPECT_EQ(1, Error.MaxX);
	EXPECT_EQ(2, Error.MaxY);
	EXPECT_EQ(1, Error.MaxChannel);
	EXPECT_EQ(1.75, Error.MaxA);
	EXPECT_EQ(1.0, Error.MaxB);
	EXPECT_DOUBLE_EQ(0.75 / std::sqrt(24.0), Error.Rms);
}

TEST(ImageMetrics, PeakIsTheReferencesLargestValueFromOneUp)
{
	// Squares 4 of two values: RMS sqrt(2); against 8 that is 20 log10(8 / 1.41421).
	const FImageError Error = CompareImages(Row({8.0, 2.0}), Row({8.0, 0.0}));
	EXPECT_EQ(8.0, Error.Peak);
	EXPECT_NEAR(15.0514997832, Error.Psnr, 1e-9);
	EXPECT_EQ(1.0, CompareImages(Row({0.5}), Row({0.25})).Peak);
}

TEST(ImageMetrics, OnlyTheFirstChannelsCountWhereAsked)
{
	FImageErrorOptions Options;
	Options.NumChannels = 3;
	EXPECT_EQ(0.0, CompareImages({1, 1, 4, {1, 2, 3, 4}}, {1, 1, 4, {1, 2, 3, 9}}, Options).Max);
}

TEST(ImageMetrics, OneSidedNonFiniteIsCountedAndInfinite)
{
	const FImageError Error = CompareImages(Row({NaN, 1.0, Infinity}), Row({0.0, 1.0, -Infinity}));
	EXPECT_EQ(2u, Error.NumNonFinite);
	EXPECT_EQ(Infinity, Error.Max);
	EXPECT_EQ(Infinity, Error.Rms);
}

TEST(ImageMetrics, BlackReferenceHasInfiniteRelativeError)
{
	EXPECT_EQ(Infinity, CompareImages(Row({0.5}), Row({0.0})).Relative);
	EXPECT_EQ(0.0, CompareImages(Row({0.0}), Row({0.0})).Relative);
}

TEST(ImageMetrics, SsimOfFlatImagesIsTheirLuminanceTerm)
{
	// (2 * 0.5 * 0.25 + 0.0001) / (0.25 + 0.0625 + 0.0001)
	EXPECT_NEAR(0.2501 / 0.3126,
		ComputeSsim(MakeImage(20, 15, 1, 0.5), MakeImage(20, 15, 1, 0.25), EImageEncoding::Display), 1e-12);
}

TEST(ImageMetrics, SsimOfAMirroredEdgeIsNearMinusOne)
{
	// A window of two equal weights: means 0.5, variances 0.09, covariance -0.09, C2 = 0.0009.
	EXPECT_NEAR(-0.1791 / 0.1809, ComputeSsim(Row({0.2, 0.8}), Row({0.8, 0.2}), EImageEncoding::Display), 1e-12);
}

TEST(ImageMetrics, SsimWindowIsAGaussianOfOneAndAHalf)
{
	// Three texels weigh w, 1 - 2w, w with w = q / (1 + 2q), q = exp(-1 / 4.5); one at the end is lit in A, none in B:
	// mean w, variance w - w^2.
	const double Q = std::exp(-1.0 / 4.5);
	const double W = Q / (1.0 + 2.0 * Q);
	const double Expected = 0.0001 * 0.0009 / ((W * W + 0.0001) * (W - W * W + 0.0009));
	EXPECT_NEAR(1.0, ComputeSsim(Row({1, 0, 0}), Row({0, 0, 0}), EImageEncoding::Display) / Expected, 1e-10);
}

TEST(ImageMetrics, SsimWeighsColoursByTheirLuminance)
{
	// Green alone: luminance 0.7152 against 0: C1 / (0.7152^2 + C1).
	FImage Green{1, 1, 3, {0, 1, 0}};
	EXPECT_NEAR(
		0.0001 / (0.7152 * 0.7152 + 0.0001), ComputeSsim(Green, MakeImage(1, 1, 3, 0), EImageEncoding::Display), 1e-12);
}

TEST(ImageMetrics, SsimOfLinearImagesIsOfWhatIsSeen)
{
	// Above 1 all is white; 0.21404114 is sRGB 0.5.
	EXPECT_DOUBLE_EQ(1.0, ComputeSsim(MakeImage(12, 12, 3, 2.0), MakeImage(12, 12, 3, 50.0), EImageEncoding::Linear));
	EXPECT_NEAR(ComputeSsim(MakeImage(12, 12, 3, 0.5), MakeImage(12, 12, 3, 1.0), EImageEncoding::Display),
		ComputeSsim(MakeImage(12, 12, 3, 0.21404114), MakeImage(12, 12, 3, 1.0), EImageEncoding::Linear), 1e-7);
}

TEST(ImageMetrics, MetricsHaveNames)
{
	const FImageError Error = CompareImages(MakeImage(3, 3, 1, 0.75), MakeImage(3, 3, 1, 0.5));
	for (const std::string& Name : GetMetricNames())
	{
		EXPECT_FALSE(std::isnan(GetMetric(Error, Name))) << Name;
	}
	EXPECT_EQ(0.25, GetMetric(Error, "rms"));
	EXPECT_TRUE(std::isnan(GetMetric(Error, "flop")));
	EXPECT_TRUE(IsHigherBetter("psnr"));
	EXPECT_FALSE(IsHigherBetter("max"));
}

TEST(ImageMetrics, HeatMapIsBrightestAtTheLargestErrorAndBlackAtFourDecadesBelow)
{
	const FImage Map = MakeHeatMap(Row({1.0, 1e-4, 0.0, NaN}), Row({0.0, 0.0, 0.0, 0.0}), 1.0);
	double Brightest[3];
	double Black[3];
	GetHeatColor(1.0, Brightest);
	GetHeatColor(0.0, Black);
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		EXPECT_EQ(Brightest[Channel], Map.Get(0, 0, Channel));
		EXPECT_NEAR(Black[Channel], Map.Get(1, 0, Channel), 1e-12);
		EXPECT_EQ(Black[Channel], Map.Get(2, 0, Channel));
		EXPECT_EQ(Channel == 0 ? 0.0 : 1.0, Map.Get(3, 0, Channel)); // cyan
	}
}

TEST(ImageMetrics, HeatGrowsBrighterAllTheWay)
{
	double Last = -1.0;
	for (int Step = 0; Step <= 20; ++Step)
	{
		double Color[3];
		GetHeatColor(Step / 20.0, Color);
		const double Luminance = 0.2126 * Color[0] + 0.7152 * Color[1] + 0.0722 * Color[2];
		EXPECT_GT(Luminance, Last) << Step;
		Last = Luminance;
	}
}
