// Depth of field: the lens by its formula, discs of points, what is in focus, what covers what, hazards.
#include "PassTestUtils.h"

#include "Lens/DiaphragmDOF.h"

using namespace PassTest;
using DiaphragmDOF::FPhysicalCocModel;
using PassReference::FRect;
using PassReference::MaxDifference;
using PassReference::SumOf;

namespace
{

/** 24 mm of sensor, a field of view of 90 degrees: focal length 12 mm. */
FFinalPostProcessSettings MakeLens()
{
	FFinalPostProcessSettings Settings;
	Settings.DepthOfFieldSensorWidth = 24.0f;
	Settings.DepthOfFieldFstop = 1.0f;
	Settings.DepthOfFieldFocalDistance = 101.2f;
	Settings.DepthOfFieldDepthBlurRadius = 0.0f;
	return Settings;
}

struct FDofRun
{
	FPhysicalCocModel Model;
	FIntPoint Padding = FIntPoint(0, 0);
	EArithmetic Arithmetic = EArithmetic::Float32;

	/** In focus at 400 cm, InfinityRadius pixels at infinity. */
	explicit FDofRun(float InfinityRadius)
	{
		Model.FocusDistance = 400.0f;
		Model.InfinityRadius = InfinityRadius;
		Model.MaxForegroundRadius = Model.MaxBackgroundRadius = 40.0f;
	}

	FImage Run(const FImage& Color, const std::function<double(int, int)>& Depth) const
	{
		const FRect Rect{Padding.X, Padding.Y, Padding.X + Color.Width, Padding.Y + Color.Height};
		const FIntPoint Extent(Color.Width + 2 * Padding.X, Color.Height + 2 * Padding.Y);
		FPassRun Pass(Color, Rect, Extent, Arithmetic, PF_A32B32G32R32F);
		// Reversed depth of a near plane at 10 cm: z = 10 / d.
		Pass.View.UniformParameters.InvDeviceZToWorldZTransform = FVector4f(0.0f, 0.0f, 0.1f, 0.0f);
		Pass.View.InitViewUniformBuffer(Extent);
		FSceneTextures SceneTextures;
		SceneTextures.Depth = Pass.AddInput(FImage::Make(Color.Width, Color.Height,
												[&](int X, int Y) {
													return FTexel{10 / Depth(X, Y), 0, 0, 0};
												}),
									  Rect, Extent, PF_R32_FLOAT, TEXT("Depth"))
								  .Texture;
		const auto Textures = CreateSceneTextureUniformBuffer(Pass.GraphBuilder, &SceneTextures);
		return Pass.Execute(DiaphragmDOF::AddPasses(Pass.GraphBuilder, Pass.View, Textures, Pass.Input, Model));
	}

	FImage Run(const FImage& Color, double Depth) const
	{
		return Run(Color, [=](int, int) { return Depth; });
	}
};

FTexel Grey(double Value)
{
	return {Value, Value, Value, 1};
}

/** Two by two bright pixels on black: one pixel of half size. */
FImage MakePoint()
{
	return FImage::Make(96, 96, [](int X, int Y) { return Grey(X / 2 == 24 && Y / 2 == 24 ? 1.0 : 0.0); });
}

/** Radius of the even disc with the same second moment. */
double MeasureRadius(const FImage& Image)
{
	double Sum = 0, Second = 0;
	for (int Y = 0; Y < Image.Height; ++Y)
	{
		for (int X = 0; X < Image.Width; ++X)
		{
			const double Distance2 = (X - 48.5) * (X - 48.5) + (Y - 48.5) * (Y - 48.5);
			Sum += Image.At(X, Y)[0];
			Second += Image.At(X, Y)[0] * Distance2;
		}
	}
	// A disc: the mean of the squared distance is R^2 / 2. Of that, 2/3 + 1/3 pixel are the point's own size and the
	// bilinear way back from half size (variances of a box and of a tent of two pixels, both axes).
	return std::sqrt(2 * (Second / Sum - 1.0));
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

TEST(DiaphragmDOF, LensFollowsTheThinLensFormula)
{
	// f = 12 mm, A = 12 mm, focus 1012 mm: A f / (F - f) = 144 / 1000 = 0.144 mm of diameter at infinity; of 24 mm over
	// 1000 pixels that is 6 pixels, 3 of radius.
	const FPhysicalCocModel Model = FPhysicalCocModel::Compile(MakeLens(), 1000, 1.0f);
	EXPECT_NEAR(3.0, Model.InfinityRadius, 1e-5);
	EXPECT_EQ(0.0f, Model.DepthToCocRadius(101.2f));
	EXPECT_NEAR(1.5, Model.DepthToCocRadius(202.4f), 1e-5);
	EXPECT_NEAR(-3.0, Model.DepthToCocRadius(50.6f), 1e-5);
}

TEST(DiaphragmDOF, StopFocalLengthAndSensorActAsInALens)
{
	FFinalPostProcessSettings Settings = MakeLens();
	Settings.DepthOfFieldFstop = 4.0f;
	EXPECT_NEAR(0.75, FPhysicalCocModel::Compile(Settings, 1000, 1.0f).InfinityRadius, 1e-5);
	// Twice the focal length, 24 mm: A f / (F - f) = 24 * 24 / 988 mm, of 24 mm: 0.024291 of the width.
	EXPECT_NEAR(1000 * 24.0 / 988 / 2, FPhysicalCocModel::Compile(MakeLens(), 1000, 2.0f).InfinityRadius, 1e-4);
}

TEST(DiaphragmDOF, RadiusIsLimitedOnBothSides)
{
	FPhysicalCocModel Model = FPhysicalCocModel::Compile(MakeLens(), 1000, 1.0f);
	Model.MaxBackgroundRadius = 1.0f;
	Model.MaxForegroundRadius = 2.0f;
	EXPECT_EQ(1.0f, Model.DepthToCocRadius(1e6f));
	EXPECT_EQ(-2.0f, Model.DepthToCocRadius(1.0f));
}

TEST(DiaphragmDOF, TheAirBlursTheDistance)
{
	FFinalPostProcessSettings Settings = MakeLens();
	Settings.DepthOfFieldFstop = 1e6f;
	Settings.DepthOfFieldDepthBlurRadius = 4.0f;
	Settings.DepthOfFieldDepthBlurAmount = 0.5f; // km
	const FPhysicalCocModel Model = FPhysicalCocModel::Compile(Settings, 960, 1.0f);
	EXPECT_NEAR(1.0, Model.DepthToCocRadius(50000.0f), 1e-5); // half of 4 pixels at 1920 wide
	EXPECT_NEAR(2.0, Model.DepthToCocRadius(5e6f), 1e-4);
}

TEST(DiaphragmDOF, DepthsThatAreNoneAreInFocus)
{
	const FPhysicalCocModel Model = FPhysicalCocModel::Compile(MakeLens(), 1000, 1.0f);
	for (const double Depth : {NaN, Infinity, 0.0, -5.0})
	{
		EXPECT_EQ(0.0f, Model.DepthToCocRadius(static_cast<float>(Depth))) << Depth;
	}
}

TEST(DiaphragmDOF, APointBehindTheFocusIsADiscOfItsRadius)
{
	for (const double Radius : {4.0, 8.0, 12.0, 16.0})
	{
		// At twice the focal distance the radius is half of that at infinity.
		const FImage Result = FDofRun(static_cast<float>(2 * Radius)).Run(MakePoint(), 800.0);
		EXPECT_NEAR(Radius, MeasureRadius(Result), 0.5) << Radius;
	}
}

TEST(DiaphragmDOF, APointBeforeTheFocusIsADiscOfItsRadius)
{
	for (const double Radius : {4.0, 8.0, 12.0, 16.0})
	{
		// At half the focal distance it is that at infinity.
		const FImage Result = FDofRun(static_cast<float>(Radius)).Run(MakePoint(), 200.0);
		EXPECT_NEAR(Radius, MeasureRadius(Result), 0.5) << Radius;
	}
}

TEST(DiaphragmDOF, ADiscKeepsTheLightOfItsPoint)
{
	for (const double Depth : {800.0, 200.0})
	{
		EXPECT_NEAR(4.0, SumOf(FDofRun(16.0f).Run(MakePoint(), Depth), 0), 0.2) << Depth;
	}
}

TEST(DiaphragmDOF, WhatIsInFocusIsUnchangedBitForBit)
{
	for (const EArithmetic Arithmetic : {EArithmetic::Float32, EArithmetic::Double})
	{
		FDofRun Dof(20.0f);
		Dof.Arithmetic = Arithmetic;
		const FImage Noise = FImage::Noise(65, 43, 4.0);
		ExpectSameBits(Noise, Dof.Run(Noise, 400.0));
	}
}

TEST(DiaphragmDOF, ASharpThingBeforeABlurredOneKeepsItsEdge)
{
	// Left in focus, right far behind: the left half is untouched, up to its edge.
	const FImage Color = FImage::Make(96, 48, [](int X, int) { return Grey(X < 48 ? 0.25 : 1.0); });
	const FImage Result = FDofRun(20.0f).Run(Color, [](int X, int) { return X < 48 ? 400.0 : 4000.0; });
	for (int X = 0; X < 48; ++X)
	{
		ASSERT_EQ(Color.At(X, 24), Result.At(X, 24)) << X;
	}
}

TEST(DiaphragmDOF, ABlurredThingBeforeASharpOneCoversItsEdge)
{
	const FImage Color = FImage::Make(96, 48, [](int X, int) { return Grey(X < 48 ? 0.0 : 1.0); });
	const FImage Result = FDofRun(12.0f).Run(Color, [](int X, int) { return X < 48 ? 400.0 : 200.0; });
	EXPECT_GT(Result.At(44, 24)[0], 0.1);
	EXPECT_EQ(0.0, Result.At(30, 24)[0]);
	EXPECT_NEAR(1.0, Result.At(70, 24)[0], 1e-3);
}

TEST(DiaphragmDOF, AConstantStaysConstant)
{
	const FImage Flat(75, 41, Grey(0.75));
	const FImage Result = FDofRun(24.0f).Run(Flat, [](int X, int Y) { return 150.0 + 13 * X + 5 * Y; });
	EXPECT_LT(MaxDifference(Flat, Result), 1e-6);
}

TEST(DiaphragmDOF, BlurGrowsWithTheDistanceFromTheFocus)
{
	double Before = 1.0;
	for (const double Depth : {500.0, 600.0, 900.0, 2000.0})
	{
		const double Peak = FDofRun(24.0f).Run(MakePoint(), Depth).At(48, 48)[0];
		EXPECT_LT(Peak, Before) << Depth;
		Before = Peak;
	}
}

TEST(DiaphragmDOF, IsTheSameInAPaddedTexture)
{
	const auto Depth = [](int X, int Y)
	{
		return 150.0 + 11 * X + 7 * Y;
	};
	FDofRun Padded(20.0f);
	Padded.Padding = FIntPoint(14, 6);
	const FImage Noise = FImage::Noise(61, 37);
	ExpectSameBits(FDofRun(20.0f).Run(Noise, Depth), Padded.Run(Noise, Depth));
}

TEST(DiaphragmDOF, SmallAndOddSizesGiveTheConstant)
{
	for (const auto& [Width, Height] : {std::pair(1, 1), {1, 17}, {17, 1}, {2, 2}, {31, 3}})
	{
		const FImage Flat(Width, Height, Grey(0.5));
		EXPECT_LT(MaxDifference(Flat, FDofRun(30.0f).Run(Flat, 4000.0)), 1e-6) << Width << "x" << Height;
	}
}

TEST(DiaphragmDOF, NaNStaysWithinItsDisc)
{
	FImage Color(96, 64, Grey(0.5));
	Color.At(48, 32) = {NaN, NaN, NaN, 1};
	const FImage Result = FDofRun(16.0f).Run(Color, 800.0); // radius 8
	EXPECT_TRUE(std::isnan(Result.At(50, 34)[0]));
	EXPECT_FALSE(std::isnan(Result.At(64, 32)[0]));
}

TEST(DiaphragmDOF, WithoutFocusOrApertureThereIsNoPass)
{
	FFinalPostProcessSettings Settings = MakeLens();
	EXPECT_TRUE(DiaphragmDOF::IsEnabled(Settings));
	Settings.DepthOfFieldFocalDistance = 0.0f;
	EXPECT_FALSE(DiaphragmDOF::IsEnabled(Settings));
	FDofRun Off(0.0f);
	const FImage Noise = FImage::Noise(31, 17);
	ExpectSameBits(Noise, Off.Run(Noise, 4000.0));
}
