// Each filter of the spatial upscale against its formula as a direct sum in double.
#include "PassTestUtils.h"

#include "Screen/PostProcessUpscale.h"

#include <functional>

using namespace PassTest;
using PassReference::MaxDifference;

namespace
{

FImage Upscale(
	const FImage& Image, int Width, int Height, EUpscaleMethod Method, EArithmetic Arithmetic = EArithmetic::Exact)
{
	FPassRun Run(Image, Arithmetic, PF_A32B32G32R32F);
	return Run.Execute(AddUpscalePass(Run.GraphBuilder, Run.View, {{}, Run.Input, FIntPoint(Width, Height), Method}));
}

/** Weight of a texel at (DX, DY) from the position; over -2..3 texels around it, normalised. */
using FWeight = std::function<double(double DX, double DY)>;

FImage Convolve(const FImage& Image, int Width, int Height, const FWeight& Weight)
{
	return FImage::Make(Width, Height,
		[&](int X, int Y)
		{
			const double U = (X + 0.5) * Image.Width / Width, V = (Y + 0.5) * Image.Height / Height;
			FTexel Sum{0, 0, 0, 0};
			double Total = 0;
			for (int J = -2; J <= 3; ++J)
			{
				for (int I = -2; I <= 3; ++I)
				{
					const int TexelX = static_cast<int>(std::floor(U - 0.5)) + I;
					const int TexelY = static_cast<int>(std::floor(V - 0.5)) + J;
					const double W = Weight(TexelX + 0.5 - U, TexelY + 0.5 - V);
					Sum = Sum +
						  Image.At(std::clamp(TexelX, 0, Image.Width - 1), std::clamp(TexelY, 0, Image.Height - 1)) * W;
					Total += W;
				}
			}
			Sum = Sum * (1 / Total);
			return FTexel{std::max(Sum[0], 0.0), std::max(Sum[1], 0.0), std::max(Sum[2], 0.0), Sum[3]};
		});
}

double CatmullRom(double X)
{
	X = std::abs(X);
	return X < 1 ? 1 - 2.5 * X * X + 1.5 * X * X * X : X < 2 ? 2 - 4 * X + 2.5 * X * X - 0.5 * X * X * X : 0;
}

double Lanczos(double X)
{
	const auto Sinc = [](double A)
	{
		return A == 0 ? 1 : std::sin(M_PI * A) / (M_PI * A);
	};
	return std::abs(X) < 3 ? Sinc(X) * Sinc(X / 3) : 0;
}

class AnyUpscale : public testing::TestWithParam<EUpscaleMethod>
{
};

} // namespace

TEST_P(AnyUpscale, AFlatPictureStaysFlat)
{
	const FImage Result = Upscale(FImage(5, 4, {0.5, 0.25, 0.75, 1}), 13, 9, GetParam(), EArithmetic::Float32);
	EXPECT_LE(MaxDifference(FImage(13, 9, {0.5, 0.25, 0.75, 1}), Result), 1e-6);
}

TEST_P(AnyUpscale, ReadsNothingOutsideTheRect)
{
	// Snapped: a coordinate at the rect's edge reads none of what is beside it, which is NaN.
	const FImage Image = FImage::Noise(7, 5), Expected = Upscale(Image, 17, 11, GetParam(), EArithmetic::Float32);
	FPassRun Run(Image, {4, 3, 11, 8}, FIntPoint(20, 20), EArithmetic::Float32, PF_A32B32G32R32F);
	const FImage Result =
		Run.Execute(AddUpscalePass(Run.GraphBuilder, Run.View, {{}, Run.Input, FIntPoint(17, 11), GetParam()}));
	EXPECT_LE(MaxDifference(Expected, Result), 4.0 / 256);
}

TEST_P(AnyUpscale, OneTexelFillsAnything)
{
	EXPECT_LE(
		MaxDifference(FImage(3, 2, {0.5, 0.5, 0.5, 1}), Upscale(FImage(1, 1, {0.5, 0.5, 0.5, 1}), 3, 2, GetParam())),
		1e-6);
	EXPECT_EQ(1, Upscale(FImage::Noise(9, 9), 1, 1, GetParam()).Width);
}

TEST_P(AnyUpscale, IsNotNegative)
{
	FImage Image(8, 8, {0, 0, 0, 1});
	Image.At(3, 3) = {1, 1, 1, 1};
	for (const FTexel& Texel : Upscale(Image, 21, 21, GetParam()).Texels)
	{
		EXPECT_GE(Texel[0], 0);
	}
}

INSTANTIATE_TEST_SUITE_P(Methods, AnyUpscale,
	testing::Values(EUpscaleMethod::Nearest, EUpscaleMethod::Bilinear, EUpscaleMethod::Directional,
		EUpscaleMethod::CatmullRom, EUpscaleMethod::Lanczos, EUpscaleMethod::Gaussian),
	[](const testing::TestParamInfo<EUpscaleMethod>& Info)
	{ return "Quality" + std::to_string(static_cast<int>(Info.param)); });

TEST(Upscale, NearestRepeatsTexels)
{
	const FImage Image = FImage::Noise(6, 5);
	EXPECT_EQ(0, MaxDifference(FImage::Make(18, 15, [&](int X, int Y) { return Image.At(X / 3, Y / 3); }),
					 Upscale(Image, 18, 15, EUpscaleMethod::Nearest)));
}

TEST(Upscale, Bilinear)
{
	const FImage Image = FImage::Noise(6, 5);
	EXPECT_LE(MaxDifference(FImage::Make(13, 11,
								[&](int X, int Y) {
									return PassReference::SampleInRect(
										Image, {0, 0, 6, 5}, (X + 0.5) * 6 / 13, (Y + 0.5) * 5 / 11, false);
								}),
				  Upscale(Image, 13, 11, EUpscaleMethod::Bilinear)),
		1e-6);
}

TEST(Upscale, CatmullRomWithoutItsCorners)
{
	const auto Weight = [](double X, double Y)
	{
		return std::abs(X) >= 1 && std::abs(Y) >= 1 ? 0.0 : CatmullRom(X) * CatmullRom(Y);
	};
	const FImage Image = FImage::Noise(9, 7);
	EXPECT_LE(MaxDifference(Convolve(Image, 23, 16, Weight), Upscale(Image, 23, 16, EUpscaleMethod::CatmullRom)), 1e-5);
}

TEST(Upscale, CatmullRomAtTheSameSizeIsThePicture)
{
	const FImage Image = FImage::Noise(9, 7);
	EXPECT_LE(MaxDifference(Image, Upscale(Image, 9, 7, EUpscaleMethod::CatmullRom, EArithmetic::Float32)), 1e-6);
}

TEST(Upscale, LanczosOfThreeLobes)
{
	const FImage Image = FImage::Noise(9, 7);
	EXPECT_LE(MaxDifference(Convolve(Image, 23, 16, [](double X, double Y) { return Lanczos(X) * Lanczos(Y); }),
				  Upscale(Image, 23, 16, EUpscaleMethod::Lanczos)),
		1e-5);
}

TEST(Upscale, GaussianLessAWiderOne)
{
	// Without sharpening: sigma 1/2 alone.
	const FScopedConsoleVariable Softness(TEXT("r.Upscale.Softness"), 0);
	const FImage Image = FImage::Noise(9, 7);
	EXPECT_LE(MaxDifference(Convolve(Image, 23, 16, [](double X, double Y) { return std::exp(-2 * (X * X + Y * Y)); }),
				  Upscale(Image, 23, 16, EUpscaleMethod::Gaussian)),
		1e-5);
}

TEST(Upscale, DirectionalKeepsAStraightEdgeStraight)
{
	const FImage Edge = FImage::Make(12, 8, [](int, int Y) { return FTexel{Y >= 4 ? 1.0 : 0.0, 0, 0, 1}; });
	const FImage Result = Upscale(Edge, 36, 24, EUpscaleMethod::Directional);
	for (int X = 1; X < 36; ++X)
	{
		EXPECT_NEAR(Result.At(0, 12)[0], Result.At(X, 12)[0], 1e-9);
	}
}

TEST(Upscale, TwiceAsManyTexelsAveragedBilinearlyAreTheirMean)
{
	const FImage Image = FImage::Noise(8, 6);
	EXPECT_LE(MaxDifference(FImage::Make(4, 3,
								[&](int X, int Y)
								{
									return (Image.At(2 * X, 2 * Y) + Image.At(2 * X + 1, 2 * Y) +
											   Image.At(2 * X, 2 * Y + 1) + Image.At(2 * X + 1, 2 * Y + 1)) *
										   0.25;
								}),
				  Upscale(Image, 4, 3, EUpscaleMethod::Bilinear)),
		1e-6);
}
