// Every blur of standard deviation s: its width as measured, its constants, its costs; the exact one against direct
// convolution written out here.
#include <gtest/gtest.h>

#include "Picture/ImageMetrics.h"
#include "Study/BlurAlgorithms.h"
#include "Study/BlurExact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace Drydock;

namespace
{

FImage MakeImage(int Width, int Height, double (*Value)(int X, int Y, int Channel))
{
	FImage Image{Width, Height, 4, {}};
	for (int Y = 0; Y < Height; ++Y)
	{
		for (int X = 0; X < Width; ++X)
		{
			for (int Channel = 0; Channel < 4; ++Channel)
			{
				Image.Values.push_back(Value(X, Y, Channel));
			}
		}
	}
	return Image;
}

FImage MakeNoise(int Width, int Height)
{
	return MakeImage(Width, Height,
		[](int X, int Y, int Channel)
		{
			return static_cast<double>((X * 7919u + Y * 104729u + static_cast<unsigned>(Channel) * 1299709u) % 1009u) /
				   1009.0;
		});
}

/** Two-dimensional, all texels that weigh anything, clamped to the edge. */
double Convolve(const FImage& Image, int X, int Y, int Channel, double Sigma)
{
	const int Reach = static_cast<int>(10.0 * Sigma) + 1;
	double Sum = 0.0;
	double Weights = 0.0;
	for (int DY = -Reach; DY <= Reach; ++DY)
	{
		for (int DX = -Reach; DX <= Reach; ++DX)
		{
			const double Weight = std::exp(-(DX * DX + DY * DY) / (2.0 * Sigma * Sigma));
			Sum += Weight *
				   Image.Get(std::clamp(X + DX, 0, Image.Width - 1), std::clamp(Y + DY, 0, Image.Height - 1), Channel);
			Weights += Weight;
		}
	}
	return Sum / Weights;
}

class BlurAlgorithm : public testing::TestWithParam<std::string>
{
};

std::vector<std::string> GetNames()
{
	std::vector<std::string> Names;
	for (const FBlurAlgorithm& Algorithm : GetBlurAlgorithms())
	{
		Names.push_back(Algorithm.Name);
	}
	return Names;
}

} // namespace

TEST(BlurExact, IsTheDirectConvolutionToTheEdge)
{
	const FImage Image = MakeNoise(23, 17);
	for (const double Sigma : {0.7, 2.0, 6.0})
	{
		const FImage Blurred = BlurExact(Image, Sigma);
		for (const auto& [X, Y] : {std::pair(0, 0), std::pair(22, 5), std::pair(11, 8), std::pair(3, 16)})
		{
			EXPECT_NEAR(Convolve(Image, X, Y, 1, Sigma), Blurred.Get(X, Y, 1), 1e-13) << Sigma << " " << X << " " << Y;
		}
	}
}

TEST(BlurExact, SpreadsAStepAsTheErrorFunctionDoes)
{
	// Between two texels the discrete sum is the integral to 1e-15 at this width.
	const FImage Step = MakeImage(400, 1, [](int X, int, int) { return X < 200 ? 0.0 : 1.0; });
	const FImage Blurred = BlurExact(Step, 10.0);
	EXPECT_NEAR(0.5, (Blurred.Get(199, 0, 0) + Blurred.Get(200, 0, 0)) / 2.0, 1e-14);
	EXPECT_NEAR(1.0, Blurred.Get(300, 0, 0), 1e-14);
}

INSTANTIATE_TEST_SUITE_P(
	All, BlurAlgorithm, testing::ValuesIn(GetNames()), [](const auto& Info) { return Info.param; });

TEST_P(BlurAlgorithm, HasTheWantedWidthAsMeasured)
{
	for (const double Sigma : {4.0, 7.5})
	{
		const FBlur Blur(GetParam(), Sigma);
		EXPECT_NEAR(1.0, Blur.GetMeasuredSigma() / Sigma, 2.5e-3) << Sigma;
		EXPECT_TRUE(Blur.IsMatched());
	}
}

TEST_P(BlurAlgorithm, DampsAWaveAsAGaussianDoes)
{
	// A wave of 40 pixels keeps exp(-2 pi^2 4^2 / 40^2) of its height; all filters of that variance agree for long
	// waves.
	const FImage Wave =
		MakeImage(160, 16, [](int X, int, int) { return 0.5 + 0.5 * std::cos(2.0 * std::numbers::pi * X / 40.0); });
	const double Gain = std::exp(-2.0 * std::numbers::pi * std::numbers::pi * 16.0 / 1600.0);
	const FImage Blurred = FBlur(GetParam(), 4.0).Run(Wave).Image;
	for (int X = 60; X < 100; ++X)
	{
		EXPECT_NEAR(0.5 + 0.5 * Gain * std::cos(2.0 * std::numbers::pi * X / 40.0), Blurred.Get(X, 8, 0), 0.012) << X;
	}
}

TEST_P(BlurAlgorithm, KeepsAConstant)
{
	const FImage Constant = MakeImage(37, 29, [](int, int, int Channel) { return 0.25 * (Channel + 1); });
	EXPECT_LE(
		CompareImages(FBlur(GetParam(), 4.0).Run(Constant).Image, Constant, {EImageEncoding::Linear, 3}).Max, 2e-6);
}

TEST_P(BlurAlgorithm, StatesWhatItCosts)
{
	const FBlurRun Run = FBlur(GetParam(), 4.0).Run(MakeNoise(64, 64));
	EXPECT_GT(Run.TapsPerPixel, 0.0);
	EXPECT_GT(Run.BytesPerPixel, 16.0);
	EXPECT_GT(Run.NumPasses, 0);
}

TEST(BlurAlgorithms, TapsAreThoseOfTheDefinition)
{
	// No side is a multiple of a thread group's. At 4 pixels a Gaussian reaches 12: 25 taps, in two passes or a square.
	const FImage Image = MakeNoise(100, 52);
	const double NumPixels = 100.0 * 52.0;
	const double Half = 50.0 * 26.0;
	const double Quarter = 25.0 * 13.0;
	const auto GetTaps = [&](const char* Algorithm)
	{
		return FBlur(Algorithm, 4.0).Run(Image).TapsPerPixel;
	};
	EXPECT_DOUBLE_EQ(50.0, GetTaps("Separable"));
	EXPECT_DOUBLE_EQ(625.0, GetTaps("Direct"));
	EXPECT_DOUBLE_EQ(625.0, GetDirectTaps(4.0));
	// Two levels: 5 taps for each texel on the way down, 8 on the way up.
	EXPECT_DOUBLE_EQ((5.0 * (Half + Quarter) + 8.0 * (NumPixels + Half)) / NumPixels, GetTaps("DualKawase"));
	// Four taps down, one up; between them a Gaussian of sqrt(16 - 3/2) / 2 = 1.9 texels, which reaches 8. Two texels
	// before the half and one after it.
	const double Low = (50.0 + 3.0) * (26.0 + 3.0);
	EXPECT_DOUBLE_EQ((4.0 * Low + 2.0 * 17.0 * Low + NumPixels) / NumPixels, GetTaps("Pyramid"));
	// Variances 0.5, 2.5, 6.5, 12.5 of the passes add up to 16 in the fourth.
	EXPECT_DOUBLE_EQ(16.0, GetTaps("Kawase"));
	// One tap to halve and one to double. The Gaussian of 2 texels has the radius 2 sqrt(2 * 16.7) = 11.56: two texels
	// a tap from -11 to 11, which is 12, on half the columns for the rows; then for the columns.
	EXPECT_DOUBLE_EQ((Half + 12.0 * Half / 2.0 + 12.0 * Half + NumPixels) / NumPixels, GetTaps("GaussianSum"));
	// 100 + 2 * 20 and 52 + 2 * 20 texels need 256 x 128; two reads for each of log2 N steps, there and back.
	EXPECT_DOUBLE_EQ(4.0 * (8.0 + 7.0) * 256.0 * 128.0 / NumPixels, GetTaps("FFT"));
	// 9.2 deviations: 37 texels, and one; along both axes.
	EXPECT_DOUBLE_EQ(2.0 * (2.0 * 38.0 + 1.0), GetTaps("Exact"));
}

TEST(BlurAlgorithms, SeparableMovesFourTexelsOfItsFormatPerPixel)
{
	FBlurArithmetic Half;
	Half.Storage = "float16";
	const FBlurRun Run = FBlur("Kawase", std::sqrt(0.5), Half).Run(MakeNoise(64, 64));
	EXPECT_DOUBLE_EQ(16.0, Run.BytesPerPixel); // one pass: 8 bytes in, 8 out
}

/** Four doubles a pixel, along two axes there and back. */
TEST(BlurAlgorithms, ExactMovesDoubles)
{
	EXPECT_DOUBLE_EQ(128.0, FBlur("Exact", 2.0).Run(MakeNoise(16, 16)).BytesPerPixel);
}

TEST(BlurAlgorithms, CoarserStorageIsFurtherFromTheExactBlur)
{
	const FImage Image = MakeNoise(64, 64);
	const FImage Exact = BlurExact(Image, 3.0);
	double Last = 0.0;
	for (const char* Storage : {"float32", "float16", "8bit"})
	{
		FBlurArithmetic Arithmetic;
		Arithmetic.Storage = Storage;
		const double Rms =
			CompareImages(FBlur("Pyramid", 3.0, Arithmetic).Run(Image).Image, Exact, {EImageEncoding::Linear, 3}).Rms;
		EXPECT_GT(Rms, Last) << Storage;
		Last = Rms;
	}
}

TEST(BlurAlgorithms, HalfResolutionKeepsTheWidth)
{
	FBlurArithmetic Half;
	Half.ResolutionLevels = 1;
	EXPECT_NEAR(6.0, FBlur("Separable", 6.0, Half).GetMeasuredSigma(), 0.02);
}

TEST(BlurAlgorithms, EngineBlurCannotBeNarrow)
{
	// Halving and stretching back is wider than a pixel already.
	EXPECT_FALSE(FBlur("GaussianSum", 0.6).IsMatched());
}

TEST(BlurAlgorithms, UnknownNameIsNone)
{
	EXPECT_EQ(nullptr, FindBlurAlgorithm("Gauss"));
	EXPECT_EQ(nullptr, FindBlurAlgorithm("Boxes"));
	EXPECT_NE(nullptr, FindBlurAlgorithm("Exact"));
}
