// FLIP against figures of its authors' program: FLIP.h of github.com/NVlabs/flip (commit of 2025, g++ 12), evaluated
// at 67.02 pixels to a degree, without HDR, of the pairs that this test makes. That program computes in float, and its
// matrices have fewer digits: a difference of 1e-4 is allowed.
#include <gtest/gtest.h>

#include "Picture/ImageFlip.h"
#include "Picture/ImageMetrics.h"

#include <array>
#include <cmath>
#include <functional>

using namespace Drydock;

namespace
{

constexpr int Width = 96;
constexpr int Height = 64;

using FColor = std::array<double, 3>;
using FPicture = std::function<FColor(int X, int Y)>;

FImage Draw(const FPicture& Picture)
{
	FImage Image{Width, Height, 3, {}};
	for (int Index = 0; Index < Width * Height; ++Index)
	{
		const FColor Color = Picture(Index % Width, Index / Width);
		Image.Values.insert(Image.Values.end(), Color.begin(), Color.end());
	}
	return Image;
}

FColor Grey(double Value)
{
	return {Value, Value, Value};
}

double Noise(int X, int Y, int Channel)
{
	unsigned Bits = static_cast<unsigned>(X) * 73856093u ^ static_cast<unsigned>(Y) * 19349663u ^
					static_cast<unsigned>(Channel) * 83492791u;
	Bits ^= Bits >> 13;
	Bits *= 0x5bd1e995u;
	Bits ^= Bits >> 15;
	return (Bits & 255) / 255.0;
}

FPicture MakeNoise(int Channel)
{
	return [Channel](int X, int Y)
	{
		return FColor{Noise(X, Y, Channel), Noise(X, Y, Channel + 1), Noise(X, Y, Channel + 2)};
	};
}

FPicture MakeStripes(int Shift)
{
	return [Shift](int X, int)
	{
		return Grey((X + Shift) / 8 % 2 == 1 ? 0.8 : 0.2);
	};
}

FPicture MakeRamp(double Blue)
{
	return [Blue](int X, int Y)
	{
		return FColor{X / 95.0, Y / 63.0, Blue};
	};
}

struct FPublished
{
	const char* Name;
	FPicture A;
	FPicture B;
	double Mean;
	double At4832;
	double At5030;
};

} // namespace

TEST(ImageFlip, IsWhatTheAuthorsProgramGives)
{
	const FPublished Published[] = {
		{"black against white", [](int, int) { return Grey(0); }, [](int, int) { return Grey(1); }, 0.967325, 0.967388,
			0.967388},
		{"blue against green",
			[](int, int) {
				return FColor{0, 0, 1};
			},
			[](int, int) {
				return FColor{0, 1, 0};
			},
			1.0, 1.0, 1.0},
		{"ramp", MakeRamp(0.25), MakeRamp(0.35), 0.233435, 0.238821, 0.236643},
		{"stripes", MakeStripes(0), MakeStripes(2), 0.483114, 0.778423, 0.181385},
		{"one white pixel", [](int, int) { return Grey(0.3); },
			[](int X, int Y) { return Grey(X == 48 && Y == 32 ? 1.0 : 0.3); }, 0.001135, 0.553661, 0.071294},
		{"noise", MakeNoise(0), MakeNoise(3), 0.447418, 0.759887, 0.410595},
	};
	for (const FPublished& Pair : Published)
	{
		const std::vector<double> Flip = ComputeFlip(Draw(Pair.A), Draw(Pair.B), EImageEncoding::Display);
		EXPECT_NEAR(Pair.Mean, GetMeanFlip(Flip), 1e-4) << Pair.Name;
		EXPECT_NEAR(Pair.At4832, Flip[32 * Width + 48], 1e-4) << Pair.Name;
		EXPECT_NEAR(Pair.At5030, Flip[30 * Width + 50], 1e-4) << Pair.Name;
	}
}

TEST(ImageFlip, NothingDiffersOfEqualPicturesAndTheOrderDoesNotMatter)
{
	const FImage A = Draw(MakeNoise(0));
	const FImage B = Draw(MakeNoise(3));
	EXPECT_EQ(0.0, GetMeanFlip(ComputeFlip(A, A, EImageEncoding::Display)));
	EXPECT_EQ(ComputeFlip(A, B, EImageEncoding::Display), ComputeFlip(B, A, EImageEncoding::Display));
}

TEST(ImageFlip, LinearLightIsThatOfTheDisplay)
{
	const FImage A = Draw(MakeRamp(0.25));
	FImage Light = A;
	for (double& Value : Light.Values)
	{
		Value = Value <= 0.04045 ? Value / 12.92 : std::pow((Value + 0.055) / 1.055, 2.4);
	}
	const FImage B = Draw(MakeStripes(0));
	FImage LightB = B;
	for (double& Value : LightB.Values)
	{
		Value = Value <= 0.04045 ? Value / 12.92 : std::pow((Value + 0.055) / 1.055, 2.4);
	}
	EXPECT_EQ(ComputeFlip(A, B, EImageEncoding::Display), ComputeFlip(Light, LightB, EImageEncoding::Linear));
	LightB.Values[0] = std::nan("");
	LightB.Values[1] = -3.0;
	for (const double Value : ComputeFlip(Light, LightB, EImageEncoding::Linear))
	{
		EXPECT_TRUE(Value >= 0.0 && Value <= 1.0);
	}
}

TEST(ImageFlip, IsAMetricOfErrorsAndHasAMap)
{
	const FImage A = Draw(MakeNoise(0));
	const FImage B = Draw(MakeNoise(3));
	FImageErrorOptions Options;
	Options.Encoding = EImageEncoding::Display;
	const FImageError Error = CompareImages(A, B, Options);
	EXPECT_NEAR(0.447418, GetMetric(Error, "flip"), 1e-4);
	EXPECT_EQ(0.0, GetMetric(CompareImages(A, A, Options), "flip"));
	EXPECT_FALSE(IsHigherBetter("flip"));
	const FImage Map = MakeFlipMap(A, A, EImageEncoding::Display);
	double Black[3];
	GetHeatColor(0.0, Black);
	EXPECT_EQ(Black[2], Map.Get(5, 5, 2));
}
