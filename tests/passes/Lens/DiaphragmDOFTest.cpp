// Depth of field: discs of points, what is in focus, what covers what, hazards.
#include "DiaphragmDOFTestUtils.h"

using namespace PassTest;
using DiaphragmDOF::FBokehModel;
using DiaphragmDOF::FPhysicalCocModel;
using PassReference::FRect;
using PassReference::MaxDifference;
using PassReference::SumOf;

namespace
{

struct FDofRun
{
	FPhysicalCocModel Model;
	FBokehModel Bokeh;
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
		return Pass.Execute(DiaphragmDOF::AddPasses(Pass.GraphBuilder, Pass.View, Textures, Pass.Input, Model, Bokeh));
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

/** A bright spot on an even background, each with the radius that its depth gives it. */
struct FSpot
{
	double Radius = 0;           // pixels; negative before the focus
	double BackgroundRadius = 0; // likewise
	int X = 0, Y = 0;            // its first pixel
	int Size = 0;                // 0: one pixel, 1: two by two, else a disc of this radius
	double Brightness = 1;

	bool Covers(int PixelX, int PixelY) const
	{
		const int Right = PixelX - X, Down = PixelY - Y;
		return Size > 1 ? Right * Right + Down * Down <= Size * Size
						: Right >= 0 && Down >= 0 && Right <= Size && Down <= Size;
	}

	/** What the picture holds above its background, as a part of what was put in. */
	double MeasureLight() const
	{
		constexpr double Background = 0.25;
		// d = F / (1 - r / r(infinity)) gives the radius r.
		constexpr double InfinityRadius = 24.0;
		const auto Depth = [](double Radius)
		{
			return 400.0 / (1.0 - Radius / InfinityRadius);
		};
		const FImage Picture = FImage::Make(
			128, 128, [&](int PixelX, int PixelY) { return Grey(Covers(PixelX, PixelY) ? Brightness : Background); });
		const FImage Result = FDofRun(static_cast<float>(InfinityRadius))
								  .Run(Picture, [&](int PixelX, int PixelY)
									  { return Depth(Covers(PixelX, PixelY) ? Radius : BackgroundRadius); });
		const double Floor = 128 * 128 * Background;
		return (SumOf(Result, 0) - Floor) / (SumOf(Picture, 0) - Floor);
	}
};

std::ostream& operator<<(std::ostream& Stream, const FSpot& Spot)
{
	return Stream << "radius " << Spot.Radius << " on " << Spot.BackgroundRadius << " at " << Spot.X << "," << Spot.Y
				  << ", size " << Spot.Size << ", brightness " << Spot.Brightness;
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

TEST(DiaphragmDOF, ASpotKeepsItsLight)
{
	// Whatever its size, place and depth; the background lies at the spot's depth, in focus or farther away.
	std::mt19937 Random(20261122);
	const auto Draw = [&](int Least, int Most)
	{
		return std::uniform_int_distribution<int>(Least, Most)(Random);
	};
	for (const double SpotRadius : {-20.0, -16.0, -11.0, -6.0, -4.0, -2.5, -1.5, -0.8, 1.5, 4.0, 8.0, 16.0})
	{
		for (const double BackgroundRadius : {SpotRadius, 0.0, SpotRadius < 0 ? SpotRadius / 2 : SpotRadius + 4, 18.0})
		{
			const FSpot Spot{SpotRadius, BackgroundRadius, Draw(56, 72), Draw(56, 72), Draw(0, 3), 50.0 + Draw(0, 100)};
			// Over what is out of focus at another depth, bokehs of two sizes only nearly tile a pixel.
			const bool bEven = BackgroundRadius == SpotRadius || BackgroundRadius == 0.0;
			EXPECT_NEAR(1.0, Spot.MeasureLight(), bEven ? 0.01 : 0.02) << Spot;
		}
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

TEST(DiaphragmDOF, APointHasTheFormOfTheOpening)
{
	struct FCase
	{
		float Fstop, MinFstop;
		int Blades;
	};
	for (const FCase& Case : {FCase{4.0f, 0.0f, 5}, {4.0f, 0.0f, 4}, {4.0f, 0.0f, 6}, {4.0f, 1.2f, 5}, {4.0f, 2.5f, 7}})
	{
		constexpr double Radius = 16.0;
		// The sides of a large circle are straight.
		const FOpening Opening(Case.Blades, Case.MinFstop > 0 ? Case.Fstop / Case.MinFstop : 1e5);
		const double Second = Opening.Mean([](double Square, double) { return Square; }) / FOpening::Pi;
		const auto Corners = [&](double Square, double Angle)
		{
			return Square * std::cos(Case.Blades * Angle);
		};
		const double Form = Opening.Mean(Corners) / FOpening::Pi;
		for (const bool bBehind : {false, true})
		{
			// At half the focal distance the radius is that at infinity, at twice half of it.
			FDofRun Dof(static_cast<float>(bBehind ? 2 * Radius : Radius));
			Dof.Bokeh = MakeBokeh(Case.Fstop, Case.MinFstop, Case.Blades);
			const FImage Result = Dof.Run(MakePoint(), bBehind ? 800.0 : 200.0);
			double Light = 0, Squares = 0, Forms = 0;
			for (int Y = 0; Y < Result.Height; ++Y)
			{
				for (int X = 0; X < Result.Width; ++X)
				{
					// Behind the focus a corner points up, before it down.
					const double Right = X - 48.5, Down = (bBehind ? -1 : 1) * (Y - 48.5), Value = Result.At(X, Y)[0];
					const double Square = Right * Right + Down * Down;
					Light += Value;
					Squares += Value * Square;
					Forms += Value * Corners(Square, std::atan2(Right, Down));
				}
			}
			// The point's own size and the way back from half size: see MeasureRadius.
			EXPECT_NEAR(Second, (Squares / Light - 1.0) / (Radius * Radius), 0.02 * Second) << Case.Blades << bBehind;
			EXPECT_NEAR(Form, Forms / Light / (Radius * Radius), 0.01 + 0.1 * Form) << Case.Blades << bBehind;
			EXPECT_NEAR(4.0, Light, 0.02) << Case.Blades << bBehind;
		}
	}
}
