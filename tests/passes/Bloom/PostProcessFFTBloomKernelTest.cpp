// The kernel of convolution bloom: its size in the picture, and what is kept of it from frame to frame.
#include "FFTBloomTestUtils.h"

using namespace PassTest;
using PassReference::SumOf;

TEST(FFTBloomKernel, IsResizedToItsPartOfTheView)
{
	// 20 x 20 texels on 10 x 10 pixels: pairs of texels become one; 0.25 of the light reaches each quarter.
	FImage Kernel(20, 20, {1, 1, 1, 1});
	Kernel.At(0, 0) = {1000, 1000, 1000, 1};
	const FImage Picture = MakeImpulse(40, 40);
	const FTestKernel Pixels(Kernel);
	FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	Settings.BloomConvolutionSize = 0.25f;
	const FImage Bloom = MakeBloom(Picture, Settings).Bloom;
	int NumLit = 0;
	for (const FTexel& Texel : Bloom.Texels)
	{
		NumLit += Texel[0] > 1e-5 ? 1 : 0;
	}
	// From 5 left of the source to 5 right of it.
	EXPECT_EQ(11 * 11, NumLit);
}

TEST(FFTBloomKernel, SmallOnesAreDownsampledFirst)
{
	const FImage Picture = MakeImpulse(40, 40), Kernel = MakeGreyKernel(33);
	const FTestKernel Pixels(Kernel);
	FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	Settings.BloomConvolutionSize = 0.2f;
	// 33, 17, 9: at most twice the 8 pixels.
	const FBloom Result = MakeBloom(Picture, Settings);
	EXPECT_EQ(2, std::count_if(Result.Passes.begin(), Result.Passes.end(),
					 [](const std::string& Pass) { return Pass.find("DownsampleKernel") != std::string::npos; }));
	EXPECT_NEAR(1.0 / 3, SumOf(Result.Bloom, 0), 1e-6);
}

TEST(FFTBloomCache, TheSecondFrameMakesNoKernel)
{
	const FImage Picture = FImage::Noise(33, 17), Kernel = MakeAsymmetricKernel(5, 5);
	const FTestKernel Pixels(Kernel);
	const FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	FSceneViewState State(1);
	const FBloom First = MakeBloom(Picture, Settings, EArithmetic::Native, &State);
	const FBloom Second = MakeBloom(Picture, Settings, EArithmetic::Native, &State);
	EXPECT_TRUE(Contains(First.Passes, "FFTBloom.FindKernelCenter"));
	EXPECT_TRUE(Contains(First.Passes, "FFTBloom.ResizeKernel"));
	EXPECT_FALSE(Contains(Second.Passes, "FFTBloom.FindKernelCenter"));
	EXPECT_FALSE(Contains(Second.Passes, "FFTBloom.ResizeKernel"));
	EXPECT_TRUE(Contains(Second.Passes, "FFTBloom.Multiply"));
	EXPECT_EQ(First.Bloom.Texels, Second.Bloom.Texels);
	EXPECT_EQ(First.SceneColor, Second.SceneColor);
}

TEST(FFTBloomCache, WhatTheKernelDependsOnMakesItAnew)
{
	const FImage Picture = FImage::Noise(33, 17), Kernel = MakeAsymmetricKernel(5, 5);
	const FTestKernel Pixels(Kernel);
	FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	FSceneViewState State(1);
	const auto MakesKernel = [&](const FImage& Of)
	{
		return Contains(MakeBloom(Of, Settings, EArithmetic::Native, &State).Passes, "FFTBloom.FindKernelCenter");
	};
	EXPECT_TRUE(MakesKernel(Picture));
	Settings.BloomConvolutionScatterDispersion = 0.5f;
	EXPECT_FALSE(MakesKernel(Picture)) << "the energies are split each frame";
	Settings.BloomConvolutionSize *= 0.5f;
	EXPECT_TRUE(MakesKernel(Picture));
	Settings.BloomConvolutionCenterUV = FVector2D(0.4, 0.5);
	EXPECT_TRUE(MakesKernel(Picture));
	EXPECT_TRUE(MakesKernel(FImage::Noise(34, 17))) << "another resolution";
	Settings.BloomConvolutionTexture = Drydock::FindOrAddTexture("Builtin/Star");
	EXPECT_TRUE(MakesKernel(FImage::Noise(34, 17)));
	EXPECT_FALSE(MakesKernel(FImage::Noise(34, 17)));
}

TEST(FFTBloomCache, CanBeSwitchedOff)
{
	const FScopedConsoleVariable Cache(TEXT("r.Bloom.CacheKernel"), 0.0f);
	const FImage Picture = FImage::Noise(33, 17), Kernel = MakeAsymmetricKernel(5, 5);
	const FTestKernel Pixels(Kernel);
	FSceneViewState State(1);
	const FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	MakeBloom(Picture, Settings, EArithmetic::Native, &State);
	const FBloom Second = MakeBloom(Picture, Settings, EArithmetic::Native, &State);
	EXPECT_TRUE(Contains(Second.Passes, "FFTBloom.FindKernelCenter"));
}

TEST(FFTBloomCache, AGraphThatNeverRanLeavesNone)
{
	const FImage Picture = FImage::Noise(33, 17), Kernel = MakeAsymmetricKernel(5, 5);
	const FTestKernel Pixels(Kernel);
	FSceneViewState State(1);
	const FFinalPostProcessSettings Settings = MakeSettings(Picture, Kernel);
	{
		FPassRun Run(Picture, EArithmetic::Native, PF_A32B32G32R32F);
		Run.View.FinalPostProcessSettings = Settings;
		Run.View.State = &State;
		AddFFTBloomPass(Run.GraphBuilder, Run.View, {Run.Input, {}, {}});
		Run.GraphBuilder.Discard();
	}
	EXPECT_TRUE(
		Contains(MakeBloom(Picture, Settings, EArithmetic::Native, &State).Passes, "FFTBloom.FindKernelCenter"));
}
