// The font that is built in: every letter is there, sizes follow, nothing is drawn outside.
#include <gtest/gtest.h>

#include "Picture/StrokeText.h"

#include <cmath>
#include <set>

using namespace Drydock;

namespace
{

FImage Black(int Width, int Height)
{
	return {Width, Height, 3, std::vector<double>(static_cast<size_t>(Width) * static_cast<size_t>(Height) * 3)};
}

FImage Draw(const std::string& Text, double CapHeight = 14, int Width = 60, int Height = 40)
{
	FImage Picture = Black(Width, Height);
	DrawStrokeText(Picture, 10, 25, Text, CapHeight, {1, 1, 1});
	return Picture;
}

double SumOf(const FImage& Picture)
{
	double Sum = 0;
	for (const double Value : Picture.Values)
	{
		Sum += Value;
	}
	return Sum;
}

} // namespace

TEST(StrokeText, EveryLetterIsThereAndDiffersFromAllOthers)
{
	std::set<std::vector<double>> Seen;
	for (char Letter = '!'; Letter <= '~'; ++Letter)
	{
		const FImage Picture = Draw(std::string(1, Letter));
		EXPECT_GT(SumOf(Picture), 5) << Letter;
		EXPECT_TRUE(Seen.insert(Picture.Values).second) << Letter;
	}
	EXPECT_EQ(0, SumOf(Draw(" ")));
}

TEST(StrokeText, LettersStayWithinTheirWidth)
{
	for (char Letter = '!'; Letter <= '~'; ++Letter)
	{
		const FImage Picture = Draw(std::string(1, Letter));
		const int Right = 10 + static_cast<int>(std::ceil(GetStrokeTextWidth(std::string(1, Letter), 14))) + 2;
		for (int Y = 0; Y < Picture.Height; ++Y)
		{
			for (int X = 0; X < Picture.Width; ++X)
			{
				const bool bInside = X >= 8 && X <= Right && Y >= 8 && Y <= 31;
				EXPECT_TRUE(bInside || Picture.Get(X, Y, 0) == 0) << Letter << " at " << X << ", " << Y;
			}
		}
	}
}

TEST(StrokeText, CapitalsAreAsHighAsAsked)
{
	// An I of 14 pixels over the baseline 25: its middle is lit, the rows above 11 and below 25 are not.
	const FImage Picture = Draw("I");
	EXPECT_GT(Picture.Get(10, 18, 0), 0.9);
	EXPECT_EQ(0, Picture.Get(10, 9, 0));
	EXPECT_EQ(0, Picture.Get(10, 27, 0));
}

TEST(StrokeText, WidthIsTheSumOfLettersAndGaps)
{
	// I: 0.6 units of 2 pixels, L: 3.8, and 1.6 between them.
	EXPECT_NEAR(2 * 0.6, GetStrokeTextWidth("I", 14), 1e-12);
	EXPECT_NEAR(2 * (0.6 + 1.6 + 3.8), GetStrokeTextWidth("IL", 14), 1e-12);
	EXPECT_EQ(0, GetStrokeTextWidth("", 14));
}

TEST(StrokeText, WhatIsNotAsciiIsAQuestionMark)
{
	EXPECT_EQ(Draw("a?b").Values, Draw("a\xC3\xA9"
									   "b")
									  .Values);
	EXPECT_EQ(Draw("?").Values, Draw("\n").Values);
}

TEST(StrokeText, LongTextEndsInDots)
{
	const double Width = GetStrokeTextWidth("abc...", 10);
	EXPECT_EQ("abc...", FitStrokeText("abcdefgh", 10, Width));
	EXPECT_EQ("abcdefgh", FitStrokeText("abcdefgh", 10, 1000));
	EXPECT_EQ("", FitStrokeText("abcdefgh", 10, 1));
}

TEST(StrokeText, OutsideThePictureIsLeftOut)
{
	FImage Picture = Black(8, 8);
	DrawStrokeText(Picture, -20, 4, "Wide text", 14, {1, 1, 1});
	DrawStrokeText(Picture, 100, 200, "far", 14, {1, 1, 1});
	EXPECT_EQ(8u * 8 * 3, Picture.Values.size());
}

TEST(StrokeText, ColorIsThatOfTheInk)
{
	FImage Picture = Black(20, 20);
	DrawStrokeText(Picture, 8, 18, "I", 14, {0.25, 0.5, 1});
	EXPECT_NEAR(0.25, Picture.Get(8, 10, 0), 1e-12);
	EXPECT_NEAR(1, Picture.Get(8, 10, 2), 1e-12);
}
