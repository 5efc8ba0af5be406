// The sum of Gaussians: weights of a flat field, stages of each quality, tints, skipped stages, and the whole chain
// against direct sums.
#include "PassTestUtils.h"

#include "Bloom/PostProcessGaussianBloom.h"
#include "Blur/PostProcessWeightedSampleSum.h"

using namespace Drydock;

using namespace PassTest;
using PassReference::EAddress;
using PassReference::MaxDifference;

namespace
{

constexpr double DefaultTints[] = {0.3465, 0.138, 0.1176, 0.066, 0.066, 0.061};

FScreenPassTexture AddBloom(FPassRun& Run)
{
	FTextureDownsampleChain Chain;
	Chain.Init(Run.GraphBuilder, Run.View, Run.Input, EDownsampleQuality::High);
	return AddGaussianBloomPasses(Run.GraphBuilder, Run.View, &Chain);
}

/** Sizes so small that every blur is a copy: what is left is downsampling, tints and the sum. */
void MakeBlursCopies(FPassRun& Run)
{
	FFinalPostProcessSettings& Settings = Run.View.FinalPostProcessSettings;
	Settings.Bloom1Size = Settings.Bloom2Size = Settings.Bloom3Size = Settings.Bloom4Size = Settings.Bloom5Size =
		Settings.Bloom6Size = 1e-6f;
}

double FlatField(int Quality, double Intensity)
{
	const FScopedConsoleVariable QualityVariable(TEXT("r.BloomQuality"), static_cast<float>(Quality));
	FPassRun Run(FImage(64, 64, {1, 1, 1, 1}), EArithmetic::Float32, PF_A32B32G32R32F);
	MakeBlursCopies(Run);
	Run.View.FinalPostProcessSettings.BloomIntensity = static_cast<float>(Intensity);
	const FImage Result = Run.Execute(AddBloom(Run));
	return Result.At(Result.Width / 2, Result.Height / 2)[1];
}

double SumOfTints(int First)
{
	double Sum = 0;
	for (int Index = First; Index < 6; ++Index)
	{
		Sum += DefaultTints[Index];
	}
	return Sum;
}

} // namespace

TEST(GaussianBloom, FlatFieldGivesTheEnginesWeight)
{
	EXPECT_NEAR(0.08945, FlatField(5, 0.675), 1e-5);
	EXPECT_NEAR(SumOfTints(0) / 6 * 2, FlatField(5, 2), 1e-6);
}

TEST(GaussianBloom, LowQualityDropsTheNarrowStages)
{
	EXPECT_NEAR(SumOfTints(1) * 0.675 / 6, FlatField(4, 0.675), 1e-6);
	EXPECT_NEAR(SumOfTints(2) * 0.675 / 6, FlatField(3, 0.675), 1e-6);
	EXPECT_NEAR(SumOfTints(3) * 0.675 / 6, FlatField(2, 0.675), 1e-6);
	EXPECT_NEAR(SumOfTints(3) * 0.675 / 6, FlatField(1, 0.675), 1e-6);
}

TEST(GaussianBloom, StageCounts)
{
	EXPECT_EQ(0u, GetBloomStageCount(EBloomQuality::Disabled));
	EXPECT_EQ(3u, GetBloomStageCount(EBloomQuality::Q1));
	EXPECT_EQ(3u, GetBloomStageCount(EBloomQuality::Q2));
	EXPECT_EQ(4u, GetBloomStageCount(EBloomQuality::Q3));
	EXPECT_EQ(5u, GetBloomStageCount(EBloomQuality::Q4));
	EXPECT_EQ(6u, GetBloomStageCount(EBloomQuality::Q5));
}

TEST(GaussianBloom, QualityVariableClamps)
{
	const FScopedConsoleVariable Quality(TEXT("r.BloomQuality"), 99);
	EXPECT_EQ(EBloomQuality::Q5, GetBloomQuality());
	const FScopedConsoleVariable Negative(TEXT("r.BloomQuality"), -1);
	EXPECT_EQ(EBloomQuality::Disabled, GetBloomQuality());
}

TEST(GaussianBloom, DisabledQualityGivesNothing)
{
	const FScopedConsoleVariable Quality(TEXT("r.BloomQuality"), 0);
	FPassRun Run(FImage(32, 32), EArithmetic::Native);
	EXPECT_FALSE(AddBloom(Run).IsValid());
	Run.Execute(Run.Input);
}

TEST(GaussianBloom, StageOfNoSizeIsLeftOut)
{
	FPassRun Run(FImage(64, 64, {1, 1, 1, 1}), EArithmetic::Float32, PF_A32B32G32R32F);
	MakeBlursCopies(Run);
	Run.View.FinalPostProcessSettings.Bloom1Size = 0;
	const FScreenPassTexture Bloom = AddBloom(Run);
	EXPECT_EQ(FIntPoint(32, 32), Bloom.Texture->Desc.Extent);
	EXPECT_NEAR(SumOfTints(1) * 0.675 / 6, Run.Execute(Bloom).At(16, 16)[0], 1e-6);
}

TEST(GaussianBloom, EachTintColoursItsStage)
{
	FPassRun Run(FImage(64, 64, {1, 1, 1, 1}), EArithmetic::Float32, PF_A32B32G32R32F);
	MakeBlursCopies(Run);
	FFinalPostProcessSettings& Settings = Run.View.FinalPostProcessSettings;
	Settings.BloomIntensity = 6;
	Settings.Bloom1Tint = FLinearColor(0.5f, 0, 0);
	Settings.Bloom2Tint = FLinearColor(0, 0.25f, 0);
	Settings.Bloom3Tint = FLinearColor(0, 0, 0.125f);
	Settings.Bloom4Tint = Settings.Bloom5Tint = Settings.Bloom6Tint = FLinearColor(0, 0, 0);
	const FTexel Middle = Run.Execute(AddBloom(Run)).At(32, 32);
	EXPECT_NEAR(0.5, Middle[0], 1e-6);
	EXPECT_NEAR(0.25, Middle[1], 1e-6);
	EXPECT_NEAR(0.125, Middle[2], 1e-6);
}

TEST(GaussianBloom, WholeChainEqualsTheDirectSum)
{
	// Even sizes down to 2x2, default settings at double precision.
	const FImage Image = FImage::Noise(64, 64, 1, 7);
	FPassRun Run(Image, EArithmetic::Exact);
	const FImage Result = Run.Execute(AddBloom(Run));

	std::vector<FImage> Levels{Image};
	for (int Level = 1; Level < 6; ++Level)
	{
		const FImage& Last = Levels.back();
		const int Size = Last.Width / 2;
		Levels.push_back(
			PassReference::Downsample(Last, {0, 0, Last.Width, Last.Height}, {0, 0, Size, Size}, true, false));
	}
	const double Sizes[] = {0.3, 1, 2, 10, 30, 64};
	FImage Sum;
	for (int Level = 5; Level >= 0; --Level)
	{
		const FImage& Source = Levels[Level];
		const double Radius = Source.Width * Sizes[Level] * 4 / 200;
		const double Clamped = std::clamp(Radius, 1e-5, 31.0);
		const int Reach = static_cast<int>(std::ceil(Clamped));
		const FImage Blurred = Radius >= 7 ? PassReference::FastGaussianBlur(Source, Clamped, Reach, EAddress::Border)
										   : PassReference::GaussianBlur(Source, Clamped, Reach, EAddress::Border);
		Sum = FImage::Make(Source.Width, Source.Height,
			[&](int X, int Y)
			{
				const FTexel Own = Blurred.At(X, Y) * (DefaultTints[Level] * 0.675 / 6);
				return Sum.Width ? Own + PassReference::SampleInRect(
											 Sum, {0, 0, Sum.Width, Sum.Height}, (X + 0.5) / 2, (Y + 0.5) / 2, false)
								 : Own;
			});
	}
	// Float parameters: weights to 2^-24, coordinates to a few 2^-24 of 64 texels.
	EXPECT_LE(MaxDifference(Sum, Result), 2e-5);
}

TEST(GaussianBloom, BlackIsBlackAndEverySizeRuns)
{
	for (const auto& [Width, Height] : {std::pair(1, 1), {1, 33}, {33, 1}, {321, 180}})
	{
		FPassRun Run(FImage(Width, Height, {0, 0, 0, 0}), EArithmetic::Native, PF_FloatRGB);
		const FImage Result = Run.Execute(AddBloom(Run));
		EXPECT_EQ(0, MaxDifference(FImage(Width, Height), Result)) << Width << "x" << Height;
	}
}

TEST(GaussianBloom, SmallFloatFormatStaysNearTheExactSum)
{
	// R11G11B10 rounds after each of 5 downsamples and 12 blur passes: at most half of 1/64 each, blue half of 1/32.
	const FImage Image = FImage::Noise(64, 36);
	const auto Bloom = [&Image](EArithmetic Arithmetic)
	{
		FPassRun Run(Image, Arithmetic, PF_FloatRGB);
		return Run.Execute(AddBloom(Run));
	};
	const FImage Exact = Bloom(EArithmetic::Exact), Stored = Bloom(EArithmetic::Native);
	for (size_t Index = 0; Index < Exact.Texels.size(); ++Index)
	{
		EXPECT_NEAR(Exact.Texels[Index][0], Stored.Texels[Index][0], Exact.Texels[Index][0] * 17 / 128 + 1e-6);
		EXPECT_NEAR(Exact.Texels[Index][2], Stored.Texels[Index][2], Exact.Texels[Index][2] * 17 / 64 + 1e-6);
	}
}
