// The general sum of Gaussians: tints, stages, clamp addressing; and that the bloom is one case of it.
#include "PassTestUtils.h"

#include "Bloom/PostProcessGaussianBloom.h"
#include "Blur/GaussianSum.h"

using namespace Drydock;

using namespace PassTest;
using PassReference::MaxDifference;
using PassReference::SumOf;

namespace
{

/** Two stages, white tints. */
FGaussianSumInputs MakeStages(float Coarse, float Fine)
{
	FGaussianSumInputs Inputs;
	Inputs.Stages = {{TEXT("CoarseX"), TEXT("CoarseY"), Coarse, FLinearColor(1, 1, 1, 1)},
		{TEXT("FineX"), TEXT("FineY"), Fine, FLinearColor(1, 1, 1, 1)}};
	Inputs.StageCount = 2;
	return Inputs;
}

FScreenPassTexture AddBlur(FPassRun& Run, FGaussianSumInputs Inputs, EPixelFormat Format = PF_A32B32G32R32F)
{
	Inputs.TintScale = GetNormalizingTintScale(Inputs);
	return AddTextureGaussianSumPasses(Run.GraphBuilder, Run.View, Run.Input, Format, TEXT("Blur"), Inputs);
}

FImage Blur(const FImage& Image, const FGaussianSumInputs& Inputs)
{
	FPassRun Run(Image, EArithmetic::Float32, PF_A32B32G32R32F);
	return Run.Execute(AddBlur(Run, Inputs));
}

} // namespace

TEST(GaussianSum, TintScaleIsOneOverTheSumOfWhatRuns)
{
	FGaussianSumInputs Inputs = MakeStages(8, 2);
	Inputs.Stages[0].Tint = FLinearColor(0.25f, 0.5f, 1, 1);
	Inputs.Stages[1].Tint = FLinearColor(0.25f, 1.5f, 1, 1);
	EXPECT_EQ(FLinearColor(2, 0.5f, 0.5f, 0.5f), GetNormalizingTintScale(Inputs));
	Inputs.StageCount = 1; // the coarse one
	EXPECT_EQ(FLinearColor(4, 2, 1, 1), GetNormalizingTintScale(Inputs));
}

TEST(GaussianSum, StagesOfNoSizeDoNotCountForTheTintScale)
{
	FGaussianSumInputs Inputs = MakeStages(0, 2);
	Inputs.Stages[1].Tint = FLinearColor(0.25f, 0.25f, 0.25f, 0.25f);
	EXPECT_EQ(FLinearColor(4, 4, 4, 4), GetNormalizingTintScale(Inputs));
}

TEST(GaussianSum, ChannelWithoutTintStaysDark)
{
	FGaussianSumInputs Inputs = MakeStages(8, 2);
	Inputs.Stages[0].Tint = Inputs.Stages[1].Tint = FLinearColor(1, 0, 1, 1);
	EXPECT_EQ(FLinearColor(0.5f, 0, 0.5f, 0.5f), GetNormalizingTintScale(Inputs));
	EXPECT_EQ(0, Blur(FImage(16, 16, {1, 1, 1, 1}), Inputs).At(4, 4)[1]);
}

TEST(GaussianSum, ConstantStaysConstantToTheEdgeWithClampAddressing)
{
	FGaussianSumInputs Inputs = MakeStages(64, 20);
	Inputs.bClampAddressing = true;
	for (const auto& [Width, Height] : {std::pair(64, 36), {65, 37}, {1, 1}, {1, 9}, {31, 2}})
	{
		const FImage Result = Blur(FImage(Width, Height, {0.75, 0.5, 3, 1}), Inputs);
		EXPECT_LE(MaxDifference(FImage(Result.Width, Result.Height, {0.75, 0.5, 3, 1}), Result, 4), 4e-6)
			<< Width << "x" << Height;
	}
}

TEST(GaussianSum, BorderAddressingDarkensTheEdge)
{
	const FImage Result = Blur(FImage(64, 36, {1, 1, 1, 1}), MakeStages(64, 20));
	EXPECT_LT(Result.At(0, 0)[0], 0.75);
}

TEST(GaussianSum, ClampedRectEqualsTheCroppedImage)
{
	FGaussianSumInputs Inputs = MakeStages(64, 20);
	Inputs.bClampAddressing = true;
	const FImage Image = FImage::Noise(32, 16);
	const FImage Cropped = Blur(Image, Inputs);
	FPassRun Run(Image, {8, 4, 40, 20}, FIntPoint(64, 32), EArithmetic::Float32, PF_A32B32G32R32F);
	// Sizes are a percentage of the rect's width, which is the crop's.
	EXPECT_LE(MaxDifference(Cropped, Run.Execute(AddBlur(Run, Inputs)), 4), 1e-6);
}

TEST(GaussianSum, ResultHasHalfTheResolution)
{
	FPassRun Run(FImage(17, 11), {3, 2, 20, 13}, FIntPoint(33, 23), EArithmetic::Native);
	const FScreenPassTexture Output = AddBlur(Run, MakeStages(8, 2), PF_R16F);
	EXPECT_EQ(FIntRect(2, 1, 10, 7), Output.ViewRect);
	EXPECT_EQ(PF_R16F, Output.Texture->Desc.Format);
	Run.Execute(Output);
}

TEST(GaussianSum, NoStageGivesNoTexture)
{
	FPassRun Run(FImage(8, 8), EArithmetic::Native);
	EXPECT_FALSE(AddBlur(Run, MakeStages(0, 0)).IsValid());
	Run.GraphBuilder.Execute();
}

TEST(GaussianSum, LightOfAnImpulseIsKept)
{
	FImage Image(128, 128, {0, 0, 0, 0});
	Image.At(64, 64) = {64, 64, 64, 64};
	EXPECT_NEAR(64.0 / 4, SumOf(Blur(Image, MakeStages(20, 10)), 0), 1e-3); // half resolution: a quarter of the texels
}

TEST(GaussianSum, BloomIsOneCaseOfIt)
{
	const FImage Image = FImage::Noise(96, 54);
	const auto RunChain = [&](const std::function<FScreenPassTexture(FPassRun&, const FTextureDownsampleChain&)>& Add)
	{
		FPassRun Run(Image, EArithmetic::Native, PF_FloatRGB);
		FTextureDownsampleChain Chain;
		Chain.Init(Run.GraphBuilder, Run.View, Run.Input, EDownsampleQuality::High);
		return Run.Execute(Add(Run, Chain));
	};
	const FImage Bloom = RunChain([](FPassRun& Run, const FTextureDownsampleChain& Chain)
		{ return AddGaussianBloomPasses(Run.GraphBuilder, Run.View, &Chain); });
	const FImage General = RunChain(
		[](FPassRun& Run, const FTextureDownsampleChain& Chain)
		{
			FGaussianSumInputs Inputs;
			const float Sizes[] = {64, 30, 10, 2, 1, 0.3f};
			const float Tints[] = {0.061f, 0.066f, 0.066f, 0.1176f, 0.138f, 0.3465f};
			for (int32 Stage = 0; Stage < 6; ++Stage)
			{
				Inputs.Stages.Add(
					{TEXT("X"), TEXT("Y"), Sizes[Stage], FLinearColor(Tints[Stage], Tints[Stage], Tints[Stage], 1)});
			}
			Inputs.StageCount = 6;
			Inputs.SizeScale = 4;
			Inputs.TintScale = FLinearColor(0.675f / 6, 0.675f / 6, 0.675f / 6, 0.675f / 6);
			return AddGaussianSumPasses(Run.GraphBuilder, Run.View, Chain, Inputs);
		});
	EXPECT_EQ(Bloom.Texels, General.Texels);
}
