// Motion blur: where light goes, how far, that none is lost, what must not change, and hazards.
#include "MotionTestUtils.h"

#include "Lens/PostProcessMotionBlur.h"

using namespace PassTest;
using PassReference::FRect;
using PassReference::MaxDifference;
using PassReference::SumOf;

namespace
{

struct FMotionBlurRun
{
	EArithmetic Arithmetic = EArithmetic::Float32;
	FIntPoint Padding = FIntPoint(0, 0);
	float VelocityScale = 1.0f;
	float MaxLength = 64.0f;
	EMotionBlurQuality Quality = EMotionBlurQuality::VeryHigh;

	FImage Run(const FImage& Color, const FMotionAt& Motion) const
	{
		const FRect Rect{Padding.X, Padding.Y, Padding.X + Color.Width, Padding.Y + Color.Height};
		const FIntPoint Extent(Color.Width + 2 * Padding.X, Color.Height + 2 * Padding.Y);
		FPassRun Pass(Color, Rect, Extent, Arithmetic, PF_A32B32G32R32F);
		// Reversed depth of a near plane at 10 cm: z = 10 / d.
		Pass.View.UniformParameters.InvDeviceZToWorldZTransform = FVector4f(0.0f, 0.0f, 0.1f, 0.0f);
		Pass.View.InitViewUniformBuffer(Extent);
		const FSceneTextures SceneTextures = AddMotion(Pass, Rect, Extent, Motion);
		FMotionBlurInputs Inputs;
		Inputs.SceneColor = Pass.Input;
		Inputs.SceneTextures = CreateSceneTextureUniformBuffer(Pass.GraphBuilder, &SceneTextures);
		Inputs.VelocityScale = VelocityScale;
		Inputs.MaxLength = MaxLength;
		Inputs.Quality = Quality;
		return Pass.Execute(AddMotionBlurPass(Pass.GraphBuilder, Pass.View, Inputs));
	}

	FImage Run(const FImage& Color, const FMotion& Motion) const
	{
		return Run(Color, [=](int, int) { return Motion; });
	}
};

FTexel Grey(double Value)
{
	return {Value, Value, Value, 1};
}

constexpr int LineX = 40;

/** A bright upright line, one pixel wide, on black. */
FImage MakeLine()
{
	return FImage::Make(80, 48, [](int X, int) { return Grey(X == LineX ? 1.0 : 0.0); });
}

/** The line moves over a still background, which is farther away. */
FMotionAt LineMoves(double X, double Y = 0.0)
{
	return [=](int PixelX, int)
	{
		return PixelX == LineX ? FMotion{X, Y, 300.0} : FMotion{};
	};
}

/** Centre and standard deviation of the light of a row. */
std::pair<double, double> MeasureRow(const FImage& Image, int Y)
{
	double Sum = 0, First = 0, Second = 0;
	for (int X = 0; X < Image.Width; ++X)
	{
		const double Value = Image.At(X, Y)[0];
		Sum += Value;
		First += Value * X;
		Second += Value * X * X;
	}
	return {First / Sum, std::sqrt(Second / Sum - (First / Sum) * (First / Sum))};
}

void ExpectSameBits(const FImage& Expected, const FImage& Actual)
{
	ASSERT_EQ(Expected.Texels.size(), Actual.Texels.size());
	for (size_t Index = 0; Index < Expected.Texels.size(); ++Index)
	{
		ASSERT_EQ(Expected.Texels[Index], Actual.Texels[Index]) << Index;
	}
}

} // namespace

TEST(MotionBlur, StillnessIsTheIdentityBitForBit)
{
	for (const EArithmetic Arithmetic : {EArithmetic::Float32, EArithmetic::Double})
	{
		FMotionBlurRun Blur;
		Blur.Arithmetic = Arithmetic;
		const FImage Noise = FImage::Noise(67, 35, 4.0);
		ExpectSameBits(Noise, Blur.Run(Noise, FMotion{}));
	}
}

TEST(MotionBlur, NoBlurIsLongerThanTwiceWidthAndHeight)
{
	// Half of it, to either side, crosses the picture from any pixel: 2 * (80 + 48).
	FMotionBlurRun Longest;
	Longest.MaxLength = 256.0f;
	const FMotionAt Motion = [](int X, int)
	{
		return FMotion{X < 40 ? 3000.0 : 7.0, X < 20 ? 1500.0 : 0.0};
	};
	const FImage Noise = FImage::Noise(80, 48);
	const FImage Expected = Longest.Run(Noise, Motion);
	for (const float MaxLength : {257.0f, 1e5f, 1.6e8f, 1e20f, 3e38f, std::numeric_limits<float>::infinity()})
	{
		FMotionBlurRun Blur;
		Blur.MaxLength = MaxLength;
		ExpectSameBits(Expected, Blur.Run(Noise, Motion));
	}
}

TEST(MotionBlur, LessThanHalfAPixelIsStillness)
{
	const FImage Noise = FImage::Noise(67, 35);
	ExpectSameBits(Noise, FMotionBlurRun().Run(Noise, FMotion{0.3, 0.3}));
}

TEST(MotionBlur, StillPixelsOutOfReachDoNotChange)
{
	const FImage Noise = FImage::Noise(128, 64);
	const FImage Result = FMotionBlurRun().Run(Noise, [](int X, int) { return X < 8 ? FMotion{12, 0} : FMotion{}; });
	// A blur of 12 reaches 6 pixels.
	for (int X = 16; X < 128; ++X)
	{
		ASSERT_EQ(Noise.At(X, 30), Result.At(X, 30)) << X;
	}
}

TEST(MotionBlur, AConstantStaysConstant)
{
	const FImage Result = FMotionBlurRun().Run(FImage(70, 50, Grey(0.75)),
		[](int X, int Y) {
			return FMotion{X % 9 - 4.0, Y % 7 * 2.0, 200.0 + 10 * X};
		});
	EXPECT_LT(MaxDifference(FImage(70, 50, Grey(0.75)), Result), 1e-6);
}

TEST(MotionBlur, AMovingLineHasTheLengthOfItsMovement)
{
	for (const double Length : {4.0, 8.0, 16.0, 24.0})
	{
		const FImage Result = FMotionBlurRun().Run(MakeLine(), LineMoves(Length));
		const auto [Center, Deviation] = MeasureRow(Result, 24);
		EXPECT_NEAR(LineX, Center, 1.0) << Length;
		// An even spread over a length L has standard deviation L / sqrt(12).
		EXPECT_NEAR(Length, Deviation * std::sqrt(12.0), 1.0) << Length;
	}
}

TEST(MotionBlur, AMovingLineKeepsItsLight)
{
	for (const double Length : {4.0, 8.0, 16.0, 24.0})
	{
		const FImage Result = FMotionBlurRun().Run(MakeLine(), LineMoves(Length));
		// Half a sample of two for each pixel of the length.
		EXPECT_NEAR(48.0, SumOf(Result, 0), 48.0 * 1.5 / Length) << Length;
		EXPECT_NEAR(1.0 / Length, Result.At(LineX + 1, 24)[0], 1.0 / Length / 2) << Length;
	}
}

TEST(MotionBlur, GoesAlongTheMovement)
{
	// A dot that moves down and right, two to one.
	const FImage Dot = FImage::Make(96, 96, [](int X, int Y) { return Grey(X == 48 && Y == 48 ? 1.0 : 0.0); });
	const FImage Result = FMotionBlurRun().Run(Dot,
		[](int X, int Y) {
			return X == 48 && Y == 48 ? FMotion{24, 12, 300.0} : FMotion{};
		});
	double XX = 0, XY = 0;
	for (int Y = 0; Y < 96; ++Y)
	{
		for (int X = 0; X < 96; ++X)
		{
			XX += Result.At(X, Y)[0] * (X - 48) * (X - 48);
			XY += Result.At(X, Y)[0] * (X - 48) * (Y - 48);
		}
	}
	EXPECT_NEAR(0.5, XY / XX, 0.05);
	EXPECT_GT(Result.At(56, 52)[0], 0.0);
	EXPECT_EQ(0.0, Result.At(56, 44)[0]);
}

TEST(MotionBlur, EvenMovementIsTheMeanAlongIt)
{
	// Everything moves by 8: a pixel shows the mean of 8 pixels around it, of a ramp the ramp.
	const FImage Ramp = FImage::Make(96, 32, [](int X, int) { return Grey(X / 96.0); });
	const FImage Result = FMotionBlurRun().Run(Ramp, FMotion{8, 0});
	for (int X = 8; X < 88; ++X)
	{
		EXPECT_NEAR(X / 96.0, Result.At(X, 16)[0], 0.5 / 96.0) << X;
	}
}

TEST(MotionBlur, NoLengthIsAboveTheLargest)
{
	FMotionBlurRun Blur;
	Blur.MaxLength = 8.0f;
	const FImage Result = Blur.Run(MakeLine(), LineMoves(40.0));
	EXPECT_EQ(0.0, Result.At(LineX + 6, 24)[0]);
	EXPECT_GT(Result.At(LineX + 3, 24)[0], 0.0);
}

TEST(MotionBlur, ScaleIsProportionalToTheLength)
{
	FMotionBlurRun Half;
	Half.VelocityScale = 0.5f;
	const double Deviation = MeasureRow(Half.Run(MakeLine(), LineMoves(32.0)), 24).second;
	EXPECT_NEAR(16.0, Deviation * std::sqrt(12.0), 1.0);
}

TEST(MotionBlur, WhatMovesBehindAStillThingDoesNotCoverIt)
{
	// Left of 40 a still wall at 2 m; right of it a bright plane moves at 10 m.
	const FImage Color = FImage::Make(80, 32, [](int X, int) { return Grey(X < 40 ? 0.25 : 1.0); });
	const FImage Result = FMotionBlurRun().Run(Color,
		[](int X, int) {
			return X < 40 ? FMotion{0, 0, 200.0} : FMotion{20, 0, 1000.0};
		});
	for (int X = 20; X < 40; ++X)
	{
		EXPECT_FLOAT_EQ(0.25f, static_cast<float>(Result.At(X, 16)[0])) << X;
	}
}

TEST(MotionBlur, WhatMovesInFrontCoversAStillThing)
{
	const FImage Color = FImage::Make(80, 32, [](int X, int) { return Grey(X < 40 ? 0.25 : 1.0); });
	const FImage Result = FMotionBlurRun().Run(Color,
		[](int X, int) {
			return X < 40 ? FMotion{0, 0, 1000.0} : FMotion{20, 0, 200.0};
		});
	EXPECT_GT(Result.At(36, 16)[0], 0.3);
	EXPECT_EQ(0.25, Result.At(25, 16)[0]);
}

TEST(MotionBlur, IsTheSameInAPaddedTexture)
{
	const FMotionAt Motion = [](int X, int Y)
	{
		return FMotion{X % 23 - 11.0, Y % 5 * 3.0, 300.0 + X};
	};
	FMotionBlurRun Padded;
	Padded.Padding = FIntPoint(13, 7);
	const FImage Noise = FImage::Noise(61, 37);
	ExpectSameBits(FMotionBlurRun().Run(Noise, Motion), Padded.Run(Noise, Motion));
}

TEST(MotionBlur, SmallAndOddSizesGiveFinitePictures)
{
	for (const auto& [Width, Height] : {std::pair(1, 1), {1, 17}, {17, 1}, {2, 2}, {31, 3}})
	{
		const FImage Result = FMotionBlurRun().Run(FImage(Width, Height, Grey(0.5)), FMotion{30, -20});
		EXPECT_LT(MaxDifference(FImage(Width, Height, Grey(0.5)), Result), 1e-6) << Width << "x" << Height;
	}
}

TEST(MotionBlur, NaNStaysOnTheLineOfMovement)
{
	FImage Color(64, 48, Grey(0.5));
	Color.At(32, 20) = {NaN, NaN, NaN, 1};
	const FImage Result = FMotionBlurRun().Run(Color, FMotion{10, 0});
	EXPECT_TRUE(std::isnan(Result.At(33, 20)[0]));
	EXPECT_FALSE(std::isnan(Result.At(33, 21)[0]));
	EXPECT_FALSE(std::isnan(Result.At(44, 20)[0]));
}

TEST(MotionBlur, VelocitiesThatAreNotFiniteCountAsStillness)
{
	const FImage Noise = FImage::Noise(40, 20);
	ExpectSameBits(Noise, FMotionBlurRun().Run(Noise, FMotion{NaN, NaN}));
	ExpectSameBits(Noise, FMotionBlurRun().Run(Noise, FMotion{Infinity, 0}));
}

TEST(MotionBlur, QualityOffBuildsNoPass)
{
	FMotionBlurRun Off;
	Off.Quality = EMotionBlurQuality::Off;
	ExpectSameBits(MakeLine(), Off.Run(MakeLine(), LineMoves(16.0)));
	FMotionBlurRun Zero;
	Zero.VelocityScale = 0.0f;
	ExpectSameBits(MakeLine(), Zero.Run(MakeLine(), LineMoves(16.0)));
}

TEST(MotionBlur, LengthFollowsAmountMaxAndTheRateOfFrames)
{
	FFinalPostProcessSettings Settings;
	Settings.MotionBlurAmount = 0.5f;
	Settings.MotionBlurMax = 5.0f;
	Settings.MotionBlurTargetFPS = 30;
	FPassRun Pass(FImage(200, 100), EArithmetic::Float32);
	// Exposure is half a frame of 1/30 s: at 24 frames a second 0.5 * 24 / 30 of the frame's movement.
	EXPECT_FLOAT_EQ(0.4f, FMotionBlurInputs::FromSettings(Settings, Pass.Input, 1.0f / 24).VelocityScale);
	EXPECT_FLOAT_EQ(0.5f, FMotionBlurInputs::FromSettings(Settings, Pass.Input, 0.0f).VelocityScale);
	EXPECT_FLOAT_EQ(10.0f, FMotionBlurInputs::FromSettings(Settings, Pass.Input, 0.0f).MaxLength);
	Settings.MotionBlurTargetFPS = 0;
	EXPECT_FLOAT_EQ(0.5f, FMotionBlurInputs::FromSettings(Settings, Pass.Input, 1.0f / 24).VelocityScale);
	Pass.GraphBuilder.Discard();
}
