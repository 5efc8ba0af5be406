// The native kernels of blurs and downsamples against the shaders that they stand for: the same stored bits for drawn
// pictures, sizes, rects, formats, parameters, lane widths, and pictures full of hazards; and that they do the work.
#include "NativeTestUtils.h"

#include "Blur/DualKawaseBlurPass.h"
#include "Blur/FourTapBlur.h"
#include "Blur/PostProcessWeightedSampleSum.h"
#include "NativeFallback.h"
#include "Screen/PostProcessDownsample.h"

using namespace Drydock;
using namespace PassTest;

namespace
{

struct FGaussian
{
	float Radius = 5.0f;
	int Address = 0; // black, mirror, clamp
	bool bCompute = false;
	bool bAdditive = false;
	FLinearColor Tint = FLinearColor(1.0f, 0.5f, -0.25f, 0.75f);
};

FImage Blur(const FPlace& Place, const FGaussian& Gaussian)
{
	FPassRun Run(Place.Image, Place.Rect, Place.Extent, EArithmetic::Native, Place.Format);
	Run.View.bUseComputePasses = Gaussian.bCompute;
	FGaussianBlurInputs Inputs;
	Inputs.NameX = TEXT("BlurX");
	Inputs.NameY = TEXT("BlurY");
	Inputs.Filter = Run.Input;
	Inputs.KernelSizePercent = 200.0f * Gaussian.Radius / Run.Input.ViewRect.Width();
	Inputs.TintColor = Gaussian.Tint;
	Inputs.UseMirrorAddressMode = Gaussian.Address == 1;
	Inputs.UseClampAddressMode = Gaussian.Address == 2;
	if (Gaussian.bAdditive)
	{
		const int Width = (Place.Rect.Width() + 1) / 2;
		const int Height = (Place.Rect.Height() + 1) / 2;
		Inputs.Additive = Run.AddInput(FImage::Noise(Width, Height), {3, 2, Width + 3, Height + 2},
			FIntPoint(Width + 5, Height + 4), Place.Format, TEXT("Additive"));
	}
	return Run.Execute(AddGaussianBlurPass(Run.GraphBuilder, Run.View, Inputs));
}

FImage BlurKawase(const FPlace& Place, float Offset, int Levels, bool bAsPrinted = false)
{
	FPassRun Run(Place.Image, Place.Rect, Place.Extent, EArithmetic::Native, Place.Format);
	FDualKawaseBlurInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.Offset = Offset;
	Inputs.PassNum = Levels;
	Inputs.bAsPrinted = bAsPrinted;
	return Run.Execute(AddDualKawaseBlurPass(Run.GraphBuilder, Run.View, Inputs));
}

FImage Halve(const FPlace& Place, EDownsampleQuality Quality, bool bCompute)
{
	FPassRun Run(Place.Image, Place.Rect, Place.Extent, EArithmetic::Native, Place.Format);
	Run.View.bUseComputePasses = bCompute;
	FDownsamplePassInputs Inputs;
	Inputs.Name = TEXT("Downsample");
	Inputs.SceneColor = Run.Input;
	Inputs.Quality = Quality;
	return Run.Execute(AddDownsamplePass(Run.GraphBuilder, Run.View, Inputs));
}

FImage BlurByPyramid(const FPlace& Place)
{
	FPassRun Run(Place.Image, Place.Rect, Place.Extent, EArithmetic::Native, Place.Format);
	return Run.Execute(AddPyramidBlurPasses(Run.GraphBuilder, Run.View, Run.Input, 3.0));
}

FPlace FillTexture(int Width, int Height)
{
	return {FImage::Noise(Width, Height), {0, 0, Width, Height}, FIntPoint(Width, Height), PF_FloatRGBA};
}

} // namespace

TEST(TapSum, GaussianHasTheShadersBits)
{
	std::mt19937 Random(18);
	for (int Case = 0; Case < 60; ++Case)
	{
		const FPlace Place = DrawPlace(Random);
		FGaussian Gaussian;
		Gaussian.Radius = std::uniform_real_distribution<float>(0.1f, 34.0f)(Random);
		Gaussian.Address = Case % 3;
		Gaussian.bCompute = Case % 4 == 3;
		Gaussian.bAdditive = Case % 5 < 2;
		ExpectSameBits([&] { return Blur(Place, Gaussian); }, "case " + std::to_string(Case) + ", " + Describe(Place) +
																  ", radius " + std::to_string(Gaussian.Radius) +
																  ", address " + std::to_string(Gaussian.Address));
	}
}

TEST(TapSum, DualKawaseHasTheShadersBits)
{
	std::mt19937 Random(5);
	for (int Case = 0; Case < 40; ++Case)
	{
		const FPlace Place = DrawPlace(Random);
		const float Offset = Case % 2 == 0 ? 1.0f : std::uniform_real_distribution<float>(0.0f, 3.0f)(Random);
		const int Levels = 1 + Case % 4;
		ExpectSameBits([&] { return BlurKawase(Place, Offset, Levels); },
			"case " + std::to_string(Case) + ", " + Describe(Place) + ", offset " + std::to_string(Offset) +
				", levels " + std::to_string(Levels));
	}
}

TEST(TapSum, DownsampleHasTheShadersBits)
{
	std::mt19937 Random(3);
	for (int Case = 0; Case < 40; ++Case)
	{
		const FPlace Place = DrawPlace(Random);
		const EDownsampleQuality Quality = Case % 2 == 0 ? EDownsampleQuality::Low : EDownsampleQuality::High;
		ExpectSameBits([&] { return Halve(Place, Quality, Case % 3 == 0); },
			"case " + std::to_string(Case) + ", " + Describe(Place) + ", quality " + std::to_string(Case % 2));
	}
}

// Several tiles and several chunks of one: most of their rows are read where they lie in the texture. An odd width is
// halved in stretches, whose weights drift.
TEST(TapSum, WidePicturesHaveTheShadersBits)
{
	for (const EPixelFormat Format : {PF_A32B32G32R32F, PF_FloatRGBA, PF_R32_FLOAT, PF_G16R16, PF_FloatR11G11B10})
	{
		FPlace Place = FillTexture(1101, 37);
		Place.Format = Format;
		const std::string What = "format " + std::to_string(static_cast<int>(Format));
		ExpectSameBits([&] { return BlurKawase(Place, 1.0f, 2); }, "Kawase, " + What);
		ExpectSameBits([&] { return BlurKawase(Place, 1.3f, 2); }, "Kawase of another offset, " + What);
		ExpectSameBits([&] { return BlurByPyramid(Place); }, "pyramid, " + What);
		ExpectSameBits([&] { return Halve(Place, EDownsampleQuality::Low, false); }, "low, " + What);
		ExpectSameBits([&] { return Halve(Place, EDownsampleQuality::High, true); }, "high, " + What);
		ExpectSameBits([&] { return Blur(Place, {.bAdditive = true}); }, "Gaussian on half the size, " + What);
	}
}

TEST(TapSum, NegativeZerosKeepTheirSignAtClampedEdges)
{
	for (const auto& [Width, Height] : {std::pair(1, 1), {7, 5}, {33, 2}})
	{
		const FPlace Place = {FImage(Width, Height, {-0.0, -0.0, -0.0, -0.0}), {2, 1, Width + 2, Height + 1},
			FIntPoint(Width + 3, Height + 3), PF_FloatRGBA};
		ExpectSameBits([&] { return BlurKawase(Place, 1.0f, 1); }, "Kawase, " + Describe(Place));
		ExpectSameBits([&] { return Halve(Place, EDownsampleQuality::Low, false); }, "low, " + Describe(Place));
		ExpectSameBits([&] { return Halve(Place, EDownsampleQuality::High, false); }, "high, " + Describe(Place));
	}
}

TEST(TapSum, WholePicturesOfAnySizeAreNotLeftToTheShader)
{
	const uint64_t Before = GetNativeFallbacks();
	for (const auto& [Width, Height] : {std::pair(640, 360), {641, 359}, {53, 47}, {1, 1}})
	{
		const FPlace Place = FillTexture(Width, Height);
		for (const float Radius : {3.0f, 20.0f})
		{
			FGaussian Gaussian;
			Gaussian.Radius = Radius;
			Gaussian.bAdditive = true;
			Blur(Place, Gaussian);
		}
		BlurKawase(Place, 1.0f, 3);
		Halve(Place, EDownsampleQuality::Low, false);
		Halve(Place, EDownsampleQuality::High, false);
	}
	EXPECT_EQ(Before, GetNativeFallbacks());
}

TEST(TapSum, WhatItDoesNotKnowIsLeftToTheShader)
{
	const FPlace Place = FillTexture(40, 30);
	const uint64_t Before = GetNativeFallbacks();
	ExpectSameBits([&] { return BlurKawase(Place, 1.0f, 2, true); }, "as printed: points");
	EXPECT_LT(Before, GetNativeFallbacks());
	const uint64_t BeforeUnsnapped = GetNativeFallbacks();
	FPassRun Run(Place.Image, EArithmetic::Native);
	const FScopedConsoleVariable SampleBits(TEXT("r.Drydock.SampleBits"), 0);
	FDownsamplePassInputs Inputs;
	Inputs.Name = TEXT("Downsample");
	Inputs.SceneColor = Run.Input;
	Run.Execute(AddDownsamplePass(Run.GraphBuilder, Run.View, Inputs));
	EXPECT_LT(BeforeUnsnapped, GetNativeFallbacks());
}
