// Two versions beside each other: pictures against a plain loop, graphs of passes case by case.
#include <gtest/gtest.h>

#include "Matrix/MatrixCompare.h"

#include <cmath>
#include <limits>
#include <random>

using namespace Drydock;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

FImage MakeImage(int Width, int Height, std::vector<double> Values)
{
	const int NumChannels = static_cast<int>(Values.size()) / (Width * Height);
	return {Width, Height, NumChannels, std::move(Values)};
}

FMatrixPass MakePass(const std::string& Name, const std::string& Fingerprint, bool bExecuted = true)
{
	return {Name, bExecuted, "F" + Name + "PS", {{Name, Fingerprint}}};
}

using FPasses = std::vector<FMatrixPass>;

const FPasses GBefore = {MakePass("Bloom", "1"), MakePass("Tonemap", "2"), MakePass("Tint", "3")};

/** Of GBefore and Now. */
std::string Describe(const FPasses& Now)
{
	const std::optional<FPassDifference> Difference = FindFirstDifference(GBefore, Now);
	return Difference ? Difference->Pass + " " + Difference->What : "";
}

} // namespace

TEST(MatrixPictures, EqualOnesDoNotDiffer)
{
	const FImage Image = MakeImage(2, 1, {0.25, NaN, Infinity, -0.0});
	EXPECT_EQ(std::nullopt, ComparePictures(Image, Image));
	EXPECT_EQ(FingerprintPicture(Image), FingerprintPicture(MakeImage(2, 1, {0.25, -NaN, Infinity, -0.0})));
}

TEST(MatrixPictures, TheSmallestBitCounts)
{
	const FImage A = MakeImage(1, 1, {0.0, 0.5});
	EXPECT_EQ((FPictureDifference{false, 0.0, 1, 0, 0}), ComparePictures(A, MakeImage(1, 1, {-0.0, 0.5})));
	EXPECT_NE(FingerprintPicture(A), FingerprintPicture(MakeImage(1, 1, {-0.0, 0.5})));
	EXPECT_EQ((FPictureDifference{false, Infinity, 1, 0, 0}), ComparePictures(A, MakeImage(1, 1, {NaN, 0.5})));
}

TEST(MatrixPictures, OfOtherSizesSaySo)
{
	const FImage Wide = MakeImage(2, 1, {1.0, 2.0});
	const FImage High = MakeImage(1, 2, {1.0, 2.0});
	ASSERT_TRUE(ComparePictures(Wide, High));
	EXPECT_TRUE(ComparePictures(Wide, High)->bOtherSize);
	EXPECT_NE(FingerprintPicture(Wide), FingerprintPicture(High));
}

// 200 pairs of random pictures (seed 17) of which some values were changed.
TEST(MatrixPictures, DifferAsAPlainLoopSays)
{
	std::mt19937 Random(17);
	for (int Round = 0; Round < 200; ++Round)
	{
		const int Width = 1 + static_cast<int>(Random() % 9);
		const int Height = 1 + static_cast<int>(Random() % 7);
		FImage A{Width, Height, 3, {}};
		for (int Index = 0; Index < Width * Height * 3; ++Index)
		{
			A.Values.push_back(static_cast<double>(Random() % 256) / 255.0);
		}
		FImage B = A;
		for (uint32_t Count = Random() % 4; Count > 0; --Count)
		{
			B.Values[Random() % B.Values.size()] = static_cast<double>(Random() % 256) / 255.0;
		}

		double Max = 0.0;
		uint64_t NumPixels = 0;
		int First = -1;
		for (int Pixel = 0; Pixel < Width * Height; ++Pixel)
		{
			double OfPixel = 0.0;
			for (size_t Channel = 0; Channel < 3; ++Channel)
			{
				const size_t Index = static_cast<size_t>(Pixel) * 3 + Channel;
				OfPixel = std::fmax(OfPixel, std::fabs(A.Values[Index] - B.Values[Index]));
			}
			Max = std::fmax(Max, OfPixel);
			NumPixels += OfPixel > 0.0 ? 1 : 0;
			First = OfPixel > 0.0 && First < 0 ? Pixel : First;
		}
		const std::optional<FPictureDifference> Difference = ComparePictures(A, B);
		ASSERT_EQ(NumPixels > 0, Difference.has_value());
		EXPECT_EQ(NumPixels == 0, FingerprintPicture(A) == FingerprintPicture(B));
		if (Difference)
		{
			EXPECT_EQ((FPictureDifference{false, Max, NumPixels, First % Width, First / Width}), *Difference);
		}
	}
}

TEST(MatrixPasses, EqualOnesDoNotDiffer)
{
	EXPECT_EQ("", Describe(GBefore));
	EXPECT_EQ(std::nullopt, FindFirstDifference({}, {}));
}

TEST(MatrixPasses, TheFirstThatDrawsSomethingElseIsNamed)
{
	FPasses Now = GBefore;
	Now[1].Written[0].second = "x";
	Now[2].Written[0].second = "y";
	EXPECT_EQ("Tonemap draws something else", Describe(Now));
}

TEST(MatrixPasses, OfSeveralTexturesTheOtherOneIsNamed)
{
	FPasses Before = GBefore;
	Before[0].Written = {{"Color", "1"}, {"Mask", "2"}};
	FPasses Now = Before;
	Now[0].Written[1].second = "x";
	EXPECT_EQ("draws something else to Mask", FindFirstDifference(Before, Now)->What);
	Now[0].Written[1].first = "Other";
	EXPECT_EQ("writes Other, not Mask", FindFirstDifference(Before, Now)->What);
	Now[0].Written.pop_back();
	EXPECT_EQ("writes 1 textures, not 2", FindFirstDifference(Before, Now)->What);
}

TEST(MatrixPasses, NewGoneAndOtherOnes)
{
	EXPECT_EQ("FXAA is new", Describe({GBefore[0], MakePass("FXAA", "4"), GBefore[1], GBefore[2]}));
	EXPECT_EQ("FXAA is new", Describe({GBefore[0], GBefore[1], GBefore[2], MakePass("FXAA", "4")}));
	EXPECT_EQ("Tonemap is gone", Describe({GBefore[0], GBefore[2]}));
	EXPECT_EQ("Tint is gone", Describe({GBefore[0], GBefore[1]}));
	EXPECT_EQ("FXAA stands in place of Tonemap", Describe({GBefore[0], MakePass("FXAA", "4"), GBefore[2]}));
}

TEST(MatrixPasses, ShadersAndCullingCount)
{
	FPasses Now = GBefore;
	Now[2].Shader = "FOtherPS";
	EXPECT_EQ("Tint runs FOtherPS, not FTintPS", Describe(Now));
	Now[1] = MakePass("Tonemap", "2", false);
	EXPECT_EQ("Tonemap is left out, and ran before", Describe(Now));
}
