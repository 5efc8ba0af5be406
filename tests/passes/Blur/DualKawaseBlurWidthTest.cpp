// Level sizes, widths and matched settings of the dual Kawase blur, as pure functions.
#include <gtest/gtest.h>

#include "DocFigures.h"
#include "DualKawaseBlurReference.h"

#include "Blur/DualKawaseBlurWidth.h"

#include <cmath>

using namespace Drydock;

namespace
{

std::vector<FIntPoint> ToVector(const TArray<FIntPoint>& Sizes)
{
	return std::vector<FIntPoint>(Sizes.GetData(), Sizes.GetData() + Sizes.Num());
}

using FSizes = std::vector<FIntPoint>;

} // namespace

TEST(DualKawaseWidth, LevelsAreCeilDivided)
{
	EXPECT_EQ((FSizes{{1366, 767}, {683, 384}, {342, 192}, {171, 96}}),
		ToVector(GetDualKawaseLevelSizes(FIntPoint(1366, 767), 3)));
}

TEST(DualKawaseWidth, LevelsStopBeforeTheShorterSideFallsBelowTwo)
{
	EXPECT_EQ((FSizes{{100, 5}, {50, 3}, {25, 2}}), ToVector(GetDualKawaseLevelSizes(FIntPoint(100, 5), 8)));
}

TEST(DualKawaseWidth, LessThanThreePixelsHaveNoLevel)
{
	EXPECT_EQ((FSizes{{1, 1}}), ToVector(GetDualKawaseLevelSizes(FIntPoint(1, 1), 3)));
	EXPECT_EQ((FSizes{{2, 500}}), ToVector(GetDualKawaseLevelSizes(FIntPoint(2, 500), 3)));
	EXPECT_EQ((FSizes{{3, 3}, {2, 2}}), ToVector(GetDualKawaseLevelSizes(FIntPoint(3, 3), 3)));
}

TEST(DualKawaseWidth, PrintedPassesStartAtFullSizeAndTruncate)
{
	// 43 -> 21 -> 10, then doubled from 10; 10 -> 5 -> 2, then doubled from 2.
	EXPECT_EQ((FSizes{{43, 10}, {21, 5}, {20, 4}, {40, 8}}), ToVector(GetDualKawasePrintedSizes(FIntPoint(43, 10), 2)));
}

TEST(DualKawaseWidth, PrintedLossOfTheArticlesSizes)
{
	// 1366 / 32 = 42.7 -> 42 * 32 = 1344; 768 / 32 = 24. 1921 / 256 = 7.5 -> 7 * 256 = 1792; 1080 / 256 -> 4 * 256 =
	// 1024.
	EXPECT_EQ(FIntPoint(22, 0), GetDualKawasePrintedLoss(FIntPoint(1366, 768), 5));
	EXPECT_EQ(FIntPoint(129, 56), GetDualKawasePrintedLoss(FIntPoint(1921, 1080), 8));
	EXPECT_EQ(FIntPoint(0, 0), GetDualKawasePrintedLoss(FIntPoint(1920, 1080), 3));
}

TEST(DualKawaseWidth, PrintedPassesEndBeforeASideBecomesZero)
{
	EXPECT_EQ((FSizes{{5, 3}, {4, 2}}), ToVector(GetDualKawasePrintedSizes(FIntPoint(5, 3), 4)));
	EXPECT_EQ((FSizes{}), ToVector(GetDualKawasePrintedSizes(FIntPoint(1, 9), 4)));
	EXPECT_EQ(FIntPoint(0, 0), GetDualKawasePrintedLoss(FIntPoint(1, 9), 4));
}

TEST(DualKawaseWidth, TapsAreRoundedToTheSamplersGrid)
{
	const FDualKawaseTaps Taps = GetDualKawaseTaps(0.7); // 179.2 / 256 and 89.6 / 256
	EXPECT_EQ(179.0 / 256, Taps.DownDiagonal);
	EXPECT_EQ(179.0 / 256, Taps.UpAxis);
	EXPECT_EQ(90.0 / 256, Taps.UpDiagonal);
}

TEST(DualKawaseWidth, TheOffsetsSignDoesNotMatter)
{
	EXPECT_EQ(GetDualKawaseVariance(3, 1.25), GetDualKawaseVariance(3, -1.25));
	EXPECT_EQ(GetDualKawaseTaps(1.25).UpDiagonal, GetDualKawaseTaps(-1.25).UpDiagonal);
}

TEST(DualKawaseWidth, NoLevelHasNoWidth)
{
	EXPECT_EQ(0, GetDualKawaseVariance(0, 1.0));
	EXPECT_EQ(0, GetDualKawaseReach(0, 1.0));
}

TEST(DualKawaseWidth, OneLevelAtOffsetZero)
{
	// Down is a box of two texels: variance 1/4. Up interpolates at a quarter texel of two pixels: 4 * 3/16 = 3/4.
	EXPECT_DOUBLE_EQ(1.0, GetDualKawaseVariance(1, 0.0));
}

TEST(DualKawaseWidth, OneLevelAtOffsetOne)
{
	// Down: diagonals at distance 1 with half the weight, a box around each tap: 1/2 + 1/4. Up, in texels of two
	// pixels: the axis taps at 1 weigh 1/6, the diagonal ones at 1/2 weigh 2/3: 1/6 + 1/6, and 3/16 of interpolation: 4
	// * 25/48.
	EXPECT_DOUBLE_EQ(3.0 / 4 + 25.0 / 12, GetDualKawaseVariance(1, 1.0));
}

TEST(DualKawaseWidth, EachLevelAddsFourTimesTheOneBefore)
{
	for (const double Offset : {0.0, 0.6, 1.0, 1.7})
	{
		EXPECT_NEAR((1 + 4 + 16) * GetDualKawaseVariance(1, Offset), GetDualKawaseVariance(3, Offset), 1e-9);
	}
}

TEST(DualKawaseWidth, WiderWithEachLevelAndWithTheOffset)
{
	for (int32 Levels = 1; Levels <= GDualKawaseMaxPasses; ++Levels)
	{
		EXPECT_LT(GetDualKawaseVariance(Levels - 1, 0.0), GetDualKawaseVariance(Levels, 0.0));
		for (double Offset = 0.5; Offset < 4.0; Offset += 1.0 / 64)
		{
			EXPECT_LT(GetDualKawaseVariance(Levels, Offset), GetDualKawaseVariance(Levels, Offset + 1.0 / 64))
				<< Levels << " levels, offset " << Offset;
		}
	}
}

TEST(DualKawaseWidth, ClosedFormIsTheMeasuredVariance)
{
	for (const auto& [Levels, Offset] :
		{std::pair(1, 0.0), {1, 0.7}, {1, 2.6}, {2, 0.55}, {2, 1.0}, {2, 1.8}, {3, 1.0}})
	{
		const int Size = 2 * GetDualKawaseReach(Levels, Offset) + (2 << Levels);
		const auto Blur = [Levels = Levels, Offset = Offset](const PassReference::FImage& Image)
		{
			return DualKawaseReference::Blur(Image, Levels, Offset);
		};
		const DualKawaseReference::FMoments Moments = DualKawaseReference::MeasureBlock(Size, Size, 1 << Levels, Blur);
		EXPECT_NEAR(Moments.XX / Moments.Sum, GetDualKawaseVariance(Levels, Offset), 1e-9)
			<< Levels << " levels, offset " << Offset;
		EXPECT_NEAR(Moments.YY / Moments.Sum, GetDualKawaseVariance(Levels, Offset), 1e-9);
	}
}

TEST(DualKawaseWidth, NothingReachesFurtherThanTheReach)
{
	for (const auto& [Levels, Offset] : {std::pair(1, 0.0), {1, 1.0}, {2, 1.3}, {3, 0.8}})
	{
		const int Reach = GetDualKawaseReach(Levels, Offset);
		const int Size = 2 * Reach + 12;
		const int At = Reach + 6;
		const PassReference::FImage Result =
			DualKawaseReference::Blur(DualKawaseReference::Impulse(Size, Size, At, At), Levels, Offset);
		for (int X = 0; X < Size; ++X)
		{
			if (std::abs(X - At) > Reach)
			{
				EXPECT_EQ(0, Result.At(X, At)[0]) << Levels << " levels, offset " << Offset << ", " << X - At;
			}
		}
	}
}

TEST(DualKawaseWidth, PublicFit)
{
	EXPECT_EQ(1, FitDualKawase(1.0).PassNum);
	EXPECT_DOUBLE_EQ(0.4538, FitDualKawase(1.0).Offset);
	// 4/3 ln 10 = 3.07; 0.4538^3 = 0.093454.
	EXPECT_EQ(3, FitDualKawase(10.0).PassNum);
	EXPECT_NEAR(0.93454, FitDualKawase(10.0).Offset, 1e-5);
	EXPECT_EQ(1, FitDualKawase(0.0).PassNum);
	EXPECT_EQ(1, FitDualKawase(std::nan("")).PassNum);
}

TEST(DualKawaseWidth, MatchReachesEveryWidthFromOnePixel)
{
	for (double Wanted = 1.0; Wanted < 420.0; Wanted *= 1.0007)
	{
		const FDualKawaseMatch Match = MatchDualKawaseWidth(Wanted);
		EXPECT_TRUE(Match.bReached) << Wanted;
		EXPECT_NEAR(1.0, Match.StandardDeviation / Wanted, Wanted < 1.5 ? 0.0025 : 0.0016) << Wanted;
		EXPECT_EQ(GetDualKawaseStandardDeviation(Match.Setting.PassNum, Match.Setting.Offset), Match.StandardDeviation);
		EXPECT_LE(Match.Setting.Offset, GDualKawaseBlockyOffset + 0.01) << Wanted;
	}
}

TEST(DualKawaseWidth, MatchFindsTheWidthOfASetting)
{
	const FDualKawaseMatch Match = MatchDualKawaseWidth(std::sqrt(17.0 / 6 * 21));
	EXPECT_EQ(3, Match.Setting.PassNum);
	EXPECT_EQ(1.0, Match.Setting.Offset);
}

TEST(DualKawaseWidth, MatchSaysWhatItCannotReach)
{
	const FDualKawaseMatch Narrow = MatchDualKawaseWidth(0.5);
	EXPECT_FALSE(Narrow.bReached);
	EXPECT_EQ(1, Narrow.Setting.PassNum);
	EXPECT_EQ(1.0, Narrow.StandardDeviation);
	const FDualKawaseMatch Wide = MatchDualKawaseWidth(5000.0);
	EXPECT_FALSE(Wide.bReached);
	EXPECT_EQ(GDualKawaseMaxPasses, Wide.Setting.PassNum);
	EXPECT_NEAR(GDualKawaseMaxOffset, Wide.Setting.Offset, 1.0 / 128);
	EXPECT_FALSE(MatchDualKawaseWidth(3.0, 0).bReached);
}

TEST(DualKawaseWidth, MatchTakesALargerOffsetWhereLevelsAreShort)
{
	const FDualKawaseMatch Match = MatchDualKawaseWidth(6.0, 2);
	EXPECT_TRUE(Match.bReached);
	EXPECT_EQ(2, Match.Setting.PassNum);
	EXPECT_GT(Match.Setting.Offset, 1.5);
}

TEST(DualKawaseWidth, GaussianHasTheWantedVarianceAlthoughItsTailsAreCut)
{
	for (const double Wanted : {0.5, 1.0, 7.714, 62.2})
	{
		const TArray<double> Weights = ComputeMatchedGaussian(Wanted);
		EXPECT_EQ(std::max(1, static_cast<int>(std::ceil(3 * Wanted))), Weights.Num() - 1);
		double Sum = Weights[0], Variance = 0;
		for (int32 X = 1; X < Weights.Num(); ++X)
		{
			EXPECT_LT(Weights[X], Weights[X - 1]);
			Sum += 2 * Weights[X];
			Variance += 2 * Weights[X] * X * X;
		}
		EXPECT_NEAR(1.0, Sum, 1e-12);
		EXPECT_NEAR(Wanted, std::sqrt(Variance), 1e-9 * Wanted);
	}
}

// docs/dual-kawase.md -----------------------------------------------------------------------------------------------

TEST(DualKawaseDoc, WidthsAreThoseOfTheClosedForm)
{
	const DocFigures::FPage Page(DRYDOCK_TEST_SOURCE_DIR, "dual-kawase.md");
	const auto Rows = Page.GetTable("| levels | offset 0 |");
	ASSERT_EQ(8u, Rows.size());
	for (int32 Levels = 1; Levels <= 8; ++Levels)
	{
		const auto& Row = Rows[static_cast<size_t>(Levels - 1)];
		ASSERT_EQ(6u, Row.size());
		for (size_t Column = 1; Column < 6; ++Column)
		{
			const double Offset = 0.5 * static_cast<double>(Column - 1);
			DocFigures::ExpectWritten(DocFigures::ParseFigure(Row[Column]),
				GetDualKawaseStandardDeviation(Levels, Offset), Row[0] + " levels, column " + std::to_string(Column));
		}
	}
	const auto Corrected = Page.GetTable("| levels | 1 | 2 |")[1];
	ASSERT_EQ(9u, Corrected.size());
	for (int32 Levels = 1; Levels <= 8; ++Levels)
	{
		DocFigures::ExpectWritten(DocFigures::ParseFigure(Corrected[static_cast<size_t>(Levels)]),
			GetDualKawaseStandardDeviation(Levels, 1.0), "corrected, " + std::to_string(Levels) + " levels");
	}
}

namespace
{

/** A weight of a column of taps, Step half pixels of the output to the right. */
struct FTapColumn
{
	double Weight;
	double Step;
};

// The taps by columns: along one axis rows do not matter.
const std::vector<FTapColumn> GDownColumns = {{4.0 / 8, 0}, {2.0 / 8, -1}, {2.0 / 8, 1}};
const std::vector<FTapColumn> GUpColumns = {
	{2.0 / 12, 0}, {1.0 / 12, -2}, {1.0 / 12, 2}, {4.0 / 12, -1}, {4.0 / 12, 1}};

/** Means over what each output column gathers; sizes of the article's textures, point taps. */
std::vector<double> GatherAsPrinted(
	const std::vector<double>& Input, size_t Size, const std::vector<FTapColumn>& Columns)
{
	std::vector<double> Output(Size);
	for (size_t Column = 0; Column < Size; ++Column)
	{
		for (const FTapColumn& Tap : Columns)
		{
			const double UV = (static_cast<double>(Column) + 0.5 + 0.5 * Tap.Step) / static_cast<double>(Size);
			const double Texel = std::floor(UV * static_cast<double>(Input.size()));
			Output[Column] +=
				Tap.Weight * Input[static_cast<size_t>(std::clamp(Texel, 0.0, static_cast<double>(Input.size() - 1)))];
		}
	}
	return Output;
}

std::vector<double> BlurAsPrinted(std::vector<double> Line, int32 Levels)
{
	size_t Size = Line.size();
	for (int32 Level = 0; Level < Levels; ++Level, Size /= 2)
	{
		Line = GatherAsPrinted(Line, Size, GDownColumns);
	}
	for (int32 Level = 0; Level < Levels; ++Level)
	{
		Size *= 2;
		Line = GatherAsPrinted(Line, Size, GUpColumns);
	}
	return Line;
}

} // namespace

// Of lines that hold the places and their squares: what comes out is where a column's light is from, and how far apart.
TEST(DualKawaseDoc, PrintedWidthsAndShiftsAreThoseOfTheArticlesLoop)
{
	const DocFigures::FPage Page(DRYDOCK_TEST_SOURCE_DIR, "dual-kawase.md");
	const auto Rows = Page.GetTable("| levels | 1 | 2 |");
	ASSERT_EQ(4u, Rows.size());
	for (int32 Levels = 1; Levels <= 8; ++Levels)
	{
		const size_t Size = size_t(1) << (Levels + 6);
		std::vector<double> Places(Size), Squares(Size);
		for (size_t Column = 0; Column < Size; ++Column)
		{
			Places[Column] = static_cast<double>(Column);
			Squares[Column] = Places[Column] * Places[Column];
		}
		const std::vector<double> From = BlurAsPrinted(Places, Levels), FromSquares = BlurAsPrinted(Squares, Levels);
		double Mean = 0.0, MeanSquare = 0.0;
		for (size_t Column = Size / 4; Column < 3 * Size / 4; ++Column) // clear of the borders; every phase as often
		{
			const double X = static_cast<double>(Column);
			Mean += (From[Column] - X) / static_cast<double>(Size / 2);
			MeanSquare += (FromSquares[Column] - 2.0 * X * From[Column] + X * X) / static_cast<double>(Size / 2);
		}
		const std::string Name = std::to_string(Levels) + " levels";
		DocFigures::ExpectWritten(DocFigures::ParseFigure(Rows[0][static_cast<size_t>(Levels)]),
			std::sqrt(MeanSquare - Mean * Mean), "width, " + Name);
		DocFigures::ExpectWritten(
			DocFigures::ParseFigure(Rows[2][static_cast<size_t>(Levels)]), Mean, "shift, " + Name);
	}
}

TEST(DualKawaseDoc, TapsPerPixelAreCountedLevelByLevel)
{
	const DocFigures::FPage Page(DRYDOCK_TEST_SOURCE_DIR, "dual-kawase.md");
	double Kawase = 0.0;
	double PixelsOfLevel = 1.0;
	for (const auto& Row : Page.GetTable("| levels | standard deviation | dual Kawase |"))
	{
		const auto InBrackets = [&](size_t Column)
		{
			return DocFigures::ParseFigure(Row[Column].substr(Row[Column].find('(') + 1));
		};
		// Five taps for each texel of the next level down, eight for each of this one up.
		Kawase += 5.0 * PixelsOfLevel / 4.0 + 8.0 * PixelsOfLevel;
		PixelsOfLevel /= 4.0;
		const double Sigma = GetDualKawaseStandardDeviation(std::stoi(Row[0]), 1.0);
		const double Across = 2.0 * std::ceil(3.0 * Sigma) + 1.0;
		DocFigures::ExpectWritten(DocFigures::ParseFigure(Row[1]), Sigma, "width of " + Row[0]);
		DocFigures::ExpectWritten(InBrackets(2), Kawase, "taps of " + Row[0]);
		DocFigures::ExpectWritten(InBrackets(3), 2.0 * Across, "taps of two passes, " + Row[0]);
		DocFigures::ExpectWritten(InBrackets(4), Across * Across, "taps of the direct one, " + Row[0]);
	}
}
