// Downsampling against the double reference, its properties, sizes, rects and hazards.
#include "PassTestUtils.h"

#include "Screen/PostProcessDownsample.h"

using namespace PassTest;
using PassReference::CeilHalf;
using PassReference::MaxDifference;

namespace
{

FScreenPassTexture AddPass(FPassRun& Run, EDownsampleQuality Quality, EPixelFormat Format = PF_Unknown)
{
	FDownsamplePassInputs Inputs;
	Inputs.Name = TEXT("Downsample");
	Inputs.SceneColor = Run.Input;
	Inputs.Quality = Quality;
	Inputs.FormatOverride = Format;
	return AddDownsamplePass(Run.GraphBuilder, Run.View, Inputs);
}

FImage Downsample(const FImage& Image, EDownsampleQuality Quality, EArithmetic Arithmetic = EArithmetic::Native,
	bool bCompute = false)
{
	FPassRun Run(Image, Arithmetic);
	Run.View.bUseComputePasses = bCompute;
	return Run.Execute(AddPass(Run, Quality));
}

FImage Expected(const FImage& Image, EDownsampleQuality Quality, bool bSnap)
{
	return PassReference::Downsample(Image, {0, 0, Image.Width, Image.Height},
		{0, 0, CeilHalf(Image.Width), CeilHalf(Image.Height)}, Quality == EDownsampleQuality::High, bSnap);
}

/** Values are in 0..1, so a coordinate that is off by D texels in x and y changes a tap by at most 2 D.
 *  Exact: coordinates from float parameters, a few 2^-24 of the size. Snapped: where sizes are odd, a coordinate may
 * round to the other 1/256. Native: half rounding (2^-12) as well. */
double Tolerance(const FImage& Image, EArithmetic Arithmetic)
{
	if (!IsSnapped(Arithmetic))
	{
		return 2 * 4 * std::max(Image.Width, Image.Height) * std::exp2(-24) + 1e-7;
	}
	const bool bExactPositions = Image.Width % 2 == 0 && Image.Height % 2 == 0;
	return (bExactPositions ? 1e-6 : 2.0 / 256) + (Arithmetic == EArithmetic::Native ? std::exp2(-12) : 0);
}

class DownsampleReference : public testing::TestWithParam<EArithmetic>
{
};

} // namespace

TEST_P(DownsampleReference, EverySizeAndQuality)
{
	for (const auto& [Width, Height] :
		{std::pair(64, 36), {65, 37}, {641, 359}, {1, 1}, {1, 7}, {9, 1}, {2, 2}, {5, 3}, {3, 64}})
	{
		for (const EDownsampleQuality Quality : {EDownsampleQuality::Low, EDownsampleQuality::High})
		{
			const FImage Image = FImage::Noise(Width, Height);
			const FImage Result = Downsample(Image, Quality, GetParam());
			EXPECT_LE(
				MaxDifference(Expected(Image, Quality, IsSnapped(GetParam())), Result, 4), Tolerance(Image, GetParam()))
				<< Width << "x" << Height << " quality " << static_cast<int>(Quality);
		}
	}
}

INSTANTIATE_TEST_SUITE_P(Arithmetic, DownsampleReference, testing::ValuesIn(AllArithmetic), FArithmeticName());

TEST(Downsample, ComputeAndPixelShaderGiveTheSameBits)
{
	const FImage Image = FImage::Noise(65, 37);
	for (const EDownsampleQuality Quality : {EDownsampleQuality::Low, EDownsampleQuality::High})
	{
		EXPECT_EQ(Downsample(Image, Quality, EArithmetic::Float32, false).Texels,
			Downsample(Image, Quality, EArithmetic::Float32, true).Texels);
	}
}

TEST(Downsample, ForceRasterWinsOverThePreferenceForCompute)
{
	FPassRun Run(FImage::Noise(4, 4), EArithmetic::Native);
	Run.View.bUseComputePasses = true;
	FDownsamplePassInputs Inputs;
	Inputs.Name = TEXT("Downsample");
	Inputs.SceneColor = Run.Input;
	Inputs.Flags = EDownsampleFlags::ForceRaster;
	const FScreenPassTexture Output = AddDownsamplePass(Run.GraphBuilder, Run.View, Inputs);
	EXPECT_TRUE(EnumHasAnyFlags(Output.Texture->Desc.Flags, TexCreate_RenderTargetable));
	Run.Execute(Output);
}

TEST(Downsample, ConstantStaysConstantToTheEdgeOfAnOddRect)
{
	const FRect Rect{3, 2, 20, 13};
	for (const EDownsampleQuality Quality : {EDownsampleQuality::Low, EDownsampleQuality::High})
	{
		FPassRun Run(FImage(17, 11, {0.75, 0.5, 3, 1}), Rect, FIntPoint(32, 24), EArithmetic::Native);
		const FImage Result = Run.Execute(AddPass(Run, Quality));
		EXPECT_EQ(8, Result.Width);
		EXPECT_EQ(6, Result.Height);
		EXPECT_EQ(0, MaxDifference(FImage(8, 6, {0.75, 0.5, 3, 1}), Result, 4));
	}
}

TEST(Downsample, OffsetRectEqualsTheCroppedImage)
{
	const FImage Image = FImage::Noise(32, 18);
	for (const EDownsampleQuality Quality : {EDownsampleQuality::Low, EDownsampleQuality::High})
	{
		const FImage Cropped = Downsample(Image, Quality);
		FPassRun Run(Image, {10, 6, 42, 24}, FIntPoint(64, 40), EArithmetic::Native);
		EXPECT_EQ(Cropped.Texels, Run.Execute(AddPass(Run, Quality)).Texels);
	}
}

TEST(Downsample, RectIsCeilDivided)
{
	FPassRun Run(FImage(17, 11), {3, 2, 20, 13}, FIntPoint(33, 23), EArithmetic::Native);
	const FScreenPassTexture Output = AddPass(Run, EDownsampleQuality::Low);
	EXPECT_EQ(FIntRect(2, 1, 10, 7), Output.ViewRect);
	EXPECT_EQ(FIntPoint(17, 12), Output.Texture->Desc.Extent);
	Run.Execute(Output);
}

TEST(Downsample, OnePixelRectAtAnOddPositionStaysOnePixel)
{
	FPassRun Run(FImage(1, 1, {0.5, 0.25, 0.125, 1}), {5, 3, 6, 4}, FIntPoint(8, 8), EArithmetic::Native);
	EXPECT_EQ(
		0, MaxDifference(FImage(1, 1, {0.5, 0.25, 0.125, 1}), Run.Execute(AddPass(Run, EDownsampleQuality::High)), 4));
}

TEST(Downsample, LowQualityIsATwoByTwoBox)
{
	FImage Image(16, 16);
	Image.At(7, 4) = {4, 4, 4, 4};
	FImage Box(8, 8);
	Box.At(3, 2) = {1, 1, 1, 1};
	EXPECT_EQ(Box.Texels, Downsample(Image, EDownsampleQuality::Low).Texels);
}

TEST(Downsample, HighQualityIsAFourByFourBox)
{
	FImage Image(16, 16);
	Image.At(7, 4) = {16, 16, 16, 16};
	FImage Box(8, 8);
	for (const auto& [X, Y] : {std::pair(3, 1), {4, 1}, {3, 2}, {4, 2}})
	{
		Box.At(X, Y) = {1, 1, 1, 1};
	}
	EXPECT_EQ(Box.Texels, Downsample(Image, EDownsampleQuality::High).Texels);
}

TEST(Downsample, HighQualityCutsNegativesOffLowKeepsThem)
{
	const FImage Image(4, 4, {-1, 2, -0.5, -1});
	EXPECT_EQ(FImage(2, 2, {-1, 2, -0.5, -1}).Texels, Downsample(Image, EDownsampleQuality::Low).Texels);
	EXPECT_EQ(FImage(2, 2, {0, 2, 0, -1}).Texels, Downsample(Image, EDownsampleQuality::High).Texels);
}

TEST(Downsample, HighQualityTurnsNaNIntoBlackWhereItReaches)
{
	FImage Image(16, 16, {1, 1, 1, 1});
	Image.At(7, 4) = {NaN, 1, 1, 1};
	FImage Result(8, 8, {1, 1, 1, 1});
	for (const auto& [X, Y] : {std::pair(3, 1), {4, 1}, {3, 2}, {4, 2}})
	{
		Result.At(X, Y)[0] = 0;
	}
	EXPECT_EQ(Result.Texels, Downsample(Image, EDownsampleQuality::High).Texels);
}

TEST(Downsample, LowQualityKeepsNaNInItsBox)
{
	FImage Image(16, 16, {1, 1, 1, 1});
	Image.At(7, 4) = {NaN, 1, 1, 1};
	FImage Result = Downsample(Image, EDownsampleQuality::Low);
	EXPECT_TRUE(std::isnan(Result.At(3, 2)[0]));
	Result.At(3, 2) = {1, 1, 1, 1};
	EXPECT_EQ(FImage(8, 8, {1, 1, 1, 1}).Texels, Result.Texels);
}

TEST(Downsample, InfinityStaysWithinItsBox)
{
	FImage Image(16, 16, {1, 1, 1, 1});
	Image.At(7, 4) = {Infinity, 1, 1, 1};
	FImage Result(8, 8, {1, 1, 1, 1});
	Result.At(3, 2)[0] = Infinity;
	EXPECT_EQ(Result.Texels, Downsample(Image, EDownsampleQuality::Low).Texels);
}

TEST(Downsample, LargestHalfDoesNotOverflow)
{
	EXPECT_EQ(FImage(3, 2, {65504, 65504, 65504, 1}).Texels,
		Downsample(FImage(6, 4, {65504, 65504, 65504, 1}), EDownsampleQuality::High).Texels);
}

TEST(Downsample, SmallFloatTargetHasNoSignAndNoAlpha)
{
	FPassRun Run(FImage(4, 4, {-1, 2, 70000, 0.5}), EArithmetic::Native, PF_A32B32G32R32F);
	const FImage Result = Run.Execute(AddPass(Run, EDownsampleQuality::Low, PF_FloatRGB));
	EXPECT_EQ(0, Result.At(0, 0)[0]);
	EXPECT_EQ(2, Result.At(0, 0)[1]);
	EXPECT_EQ(64512, Result.At(0, 0)[2]);
}

TEST(Downsample, QualityVariablesClamp)
{
	const FScopedConsoleVariable Quality(TEXT("r.PostProcessing.DownsampleQuality"), 7);
	EXPECT_EQ(EDownsampleQuality::High, GetDownsampleQuality());
	const FScopedConsoleVariable ChainQuality(TEXT("r.PostProcessing.DownsampleChainQuality"), -2);
	EXPECT_EQ(EDownsampleQuality::Low, GetDownsampleChainQuality());
}

TEST(DownsampleChain, SizesOfTheUsualFrames)
{
	const std::pair<FIntPoint, std::vector<FIntPoint>> Frames[] = {
		{{960, 540}, {{960, 540}, {480, 270}, {240, 135}, {120, 68}, {60, 34}, {30, 17}}},
		{{640, 360}, {{640, 360}, {320, 180}, {160, 90}, {80, 45}, {40, 23}, {20, 12}}},
		{{1, 3}, {{1, 3}, {1, 2}, {1, 1}, {1, 1}, {1, 1}, {1, 1}}},
	};
	for (const auto& [First, Sizes] : Frames)
	{
		FPassRun Run(FImage(1, 1), EArithmetic::Native);
		FTextureDownsampleChain Chain;
		Chain.Init(Run.GraphBuilder, Run.View, Run.AddInput(FImage(First.X, First.Y), PF_FloatRGB, TEXT("Half")),
			EDownsampleQuality::High);
		ASSERT_EQ(6u, Chain.GetLevelCount());
		for (uint32 Level = 0; Level < 6; ++Level)
		{
			EXPECT_EQ(Sizes[Level], Chain.GetTexture(Level).Texture->Desc.Extent) << Level;
			EXPECT_EQ(PF_FloatRGB, Chain.GetTexture(Level).Texture->Desc.Format);
		}
		Run.Execute(Chain.GetLastTexture());
	}
}

TEST(DownsampleChain, KeepsTheMeanOfAnImageWhoseSizesHalveEvenly)
{
	// The light lies away from the edges, where clamped taps would weigh it twice.
	const FImage Noise = FImage::Noise(32, 32);
	const FImage Image = FImage::Make(64, 64,
		[&](int X, int Y) {
			return X >= 16 && X < 48 && Y >= 16 && Y < 48 ? Noise.At(X - 16, Y - 16) : FTexel{0, 0, 0, 0};
		});
	FPassRun Run(Image, EArithmetic::Exact);
	FTextureDownsampleChain Chain;
	Chain.Init(Run.GraphBuilder, Run.View, Run.Input, EDownsampleQuality::High, TEXT("Chain"), 3);
	const FImage Last = Run.Execute(Chain.GetLastTexture());
	EXPECT_NEAR(PassReference::SumOf(Image, 1), PassReference::SumOf(Last, 1) * 16, 1e-3);
}
