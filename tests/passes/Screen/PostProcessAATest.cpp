// FXAA on pictures whose result can be worked out by hand, and its contract.
#include "PassTestUtils.h"

#include "Screen/PostProcessAA.h"

using namespace PassTest;
using PassReference::MaxDifference;

namespace
{

struct FRun
{
	EFXAAQuality Quality = EFXAAQuality::Q4;
	bool bLumaInAlpha = false;
	EArithmetic Arithmetic = EArithmetic::Exact;
	EPixelFormat Format = PF_A32B32G32R32F;
};

FImage Fxaa(const FImage& Image, const FRun& Setup = {})
{
	FPassRun Run(Image, Setup.Arithmetic, Setup.Format);
	return Run.Execute(AddFXAAPass(Run.GraphBuilder, Run.View, {{}, Run.Input, Setup.Quality, Setup.bLumaInAlpha}));
}

FTexel Grey(double Value)
{
	return {Value, Value, Value, Value};
}

/** White below a border that steps up by one row at the middle. */
FImage MakeStep(int Width = 80, int Height = 8)
{
	return FImage::Make(
		Width, Height, [&](int X, int Y) { return Grey(Y >= (X < Width / 2 ? Height / 2 : Height / 2 - 1) ? 1 : 0); });
}

class FxaaQuality : public testing::TestWithParam<EFXAAQuality>
{
};

} // namespace

TEST_P(FxaaQuality, AFlatPictureIsTheSameBitForBit)
{
	const FImage Image(17, 9, {0.25, 0.625, 0.125, 0});
	EXPECT_EQ(Image.Texels, Fxaa(Image, {GetParam(), false, EArithmetic::Float32}).Texels);
}

TEST_P(FxaaQuality, ContrastBelowTheThresholdIsLeftAlone)
{
	// 0.0833 (quality 0: 0.05) is the least contrast that is an edge.
	const FImage Image = FImage::Make(16, 16, [](int X, int Y) { return Grey((X + Y) % 2 ? 0.25 : 0.296875); });
	EXPECT_EQ(0, MaxDifference(Image, Fxaa(Image, {GetParam()})));
}

TEST_P(FxaaQuality, NoChannelLeavesTheRangeAround)
{
	const FImage Image = FImage::Noise(33, 21);
	const FImage Result = Fxaa(Image, {GetParam()});
	for (const FTexel& Texel : Result.Texels)
	{
		EXPECT_TRUE(Texel[0] >= 0 && Texel[0] <= 1 && Texel[2] >= 0 && Texel[2] <= 1);
	}
}

TEST_P(FxaaQuality, SteepnessOfADiagonalFalls)
{
	const FImage Diagonal = FImage::Make(24, 24, [](int X, int Y) { return Grey(Y > X ? 1 : 0); });
	const FImage Result = Fxaa(Diagonal, {GetParam()});
	EXPECT_LT(Result.At(12, 13)[0], 0.9);
	EXPECT_GT(Result.At(12, 12)[0], 0.1);
	EXPECT_NEAR(1, Result.At(12, 16)[0], 1e-12);
}

TEST_P(FxaaQuality, OddSizesAndRectsInsideLargerTextures)
{
	// Snapped: a coordinate at the rect's edge reads none of what is beside it, which is NaN.
	const FRun Setup{GetParam(), false, EArithmetic::Float32};
	const FImage Image = FImage::Noise(13, 7), Expected = Fxaa(Image, Setup);
	FPassRun Run(Image, {5, 3, 18, 10}, FIntPoint(40, 20), EArithmetic::Float32, PF_A32B32G32R32F);
	const FImage Result = Run.Execute(AddFXAAPass(Run.GraphBuilder, Run.View, {{}, Run.Input, GetParam(), false}));
	EXPECT_LE(MaxDifference(Expected, Result), 2.0 / 256);
}

TEST_P(FxaaQuality, OnePixelAndOneColumn)
{
	const FRun Setup{GetParam(), false, EArithmetic::Float32};
	EXPECT_EQ(0, MaxDifference(FImage(1, 1, Grey(0.5)), Fxaa(FImage(1, 1, Grey(0.5)), Setup)));
	EXPECT_EQ(0, MaxDifference(FImage(1, 7, Grey(0.5)), Fxaa(FImage(1, 7, Grey(0.5)), Setup)));
}

INSTANTIATE_TEST_SUITE_P(All, FxaaQuality,
	testing::Values(
		EFXAAQuality::Q0, EFXAAQuality::Q1, EFXAAQuality::Q2, EFXAAQuality::Q3, EFXAAQuality::Q4, EFXAAQuality::Q5),
	[](const testing::TestParamInfo<EFXAAQuality>& Info)
	{ return "Q" + std::to_string(static_cast<int>(Info.param)); });

TEST(Fxaa, TheTexelBesideAStepMovesByItsDistanceFromIt)
{
	// The black texel left of the step, white below and to the right: the edge ends one step to the right (1 texel; 1.5
	// with quality 1) and never to the left, where all steps are made. Offset 0.5 - near / (near + far), and the white
	// share of a bilinear tap that far down is the offset. Softening of the texel alone, 0.75 * (1/2)^2, is less.
	const double Expected[] = {0.5 - 1.5 / 18, 0.5 - 1 / 21.5, 0.5 - 1 / 27.5, 0.5 - 1 / 31.5, 0.5 - 1 / 27.5};
	for (int Quality = 1; Quality <= 5; ++Quality)
	{
		const FImage Result = Fxaa(MakeStep(), {static_cast<EFXAAQuality>(Quality)});
		EXPECT_NEAR(Expected[Quality - 1], Result.At(39, 3)[0], 1e-6) << Quality;
	}
}

TEST(Fxaa, AStraightEdgeIsSoftenedOnly)
{
	// Black above white: low-pass 1/3 away; t = 1/3, (3 - 2t) t^2 = 7/27, squared, times 0.75.
	const FImage Edge = FImage::Make(80, 8, [](int, int Y) { return Grey(Y >= 4 ? 1 : 0); });
	const FImage Result = Fxaa(Edge);
	EXPECT_NEAR(0.75 * (7.0 / 27) * (7.0 / 27), Result.At(40, 3)[0], 1e-6);
	EXPECT_NEAR(1 - 0.75 * (7.0 / 27) * (7.0 / 27), Result.At(40, 4)[0], 1e-6);
	EXPECT_NEAR(0, Result.At(40, 2)[0], 1e-12);
}

TEST(Fxaa, ColumnsAreTreatedAsRows)
{
	const FImage Step = MakeStep(24, 24);
	const FImage Turned = FImage::Make(24, 24, [&](int X, int Y) { return Step.At(Y, X); });
	const FImage A = Fxaa(Step), B = Fxaa(Turned);
	EXPECT_LE(MaxDifference(A, FImage::Make(24, 24, [&](int X, int Y) { return B.At(Y, X); })), 1e-6);
}

TEST(Fxaa, StrengthRisesWithContrast)
{
	double Previous = 0;
	for (const double Contrast : {0.0625, 0.125, 0.25, 0.5})
	{
		FImage Image(9, 9, Grey(0.25));
		Image.At(4, 4) = Grey(0.25 + Contrast);
		const double Change = Image.At(4, 4)[0] - Fxaa(Image).At(4, 4)[0];
		EXPECT_GE(Change, Previous);
		Previous = Change;
	}
	EXPECT_GT(Previous, 0.1);
}

TEST(Fxaa, LumaComesFromAlphaWhereItIsThere)
{
	FImage Image = MakeStep();
	EXPECT_EQ(Fxaa(Image).Texels, Fxaa(Image, {.bLumaInAlpha = true}).Texels);
	for (FTexel& Texel : Image.Texels)
	{
		Texel[3] = 0.5;
	}
	EXPECT_EQ(0, MaxDifference(Image, Fxaa(Image, {.bLumaInAlpha = true, .Arithmetic = EArithmetic::Float32})));
}

TEST(Fxaa, NaNStaysNear)
{
	FImage Image = MakeStep(32, 32);
	Image.At(5, 5) = {NaN, NaN, NaN, NaN};
	const FImage Result = Fxaa(Image);
	for (int Y = 0; Y < 32; ++Y)
	{
		for (int X = 0; X < 32; ++X)
		{
			EXPECT_TRUE(!std::isnan(Result.At(X, Y)[0]) || (std::abs(X - 5) <= 1 && std::abs(Y - 5) <= 1))
				<< X << " " << Y;
		}
	}
}
