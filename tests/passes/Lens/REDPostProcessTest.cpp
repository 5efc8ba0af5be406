// The RED post process pass by pass against the article's formulas in double, the chain, both forms, hazards.
#include <gmock/gmock.h>

#include "REDPostProcessTestUtils.h"

#include "RenderGraphCompiled.h"

using namespace Drydock;

using namespace PassTest;
using PassReference::CeilHalf;
using PassReference::MaxDifference;
using PassReference::SumOf;

namespace
{

FTexel Combine(
	const FTexel& Color, const FTexel& Blurred, EREDPostProcessPass Pass, const FREDPostProcessParameters& Parameters)
{
	return RunPass(FImage(4, 4, Color), Pass, Parameters, FImage(2, 2, Blurred)).At(1, 2);
}

FImage RunChain(const FImage& Image, const FREDPostProcessParameters& Parameters,
	EArithmetic Arithmetic = EArithmetic::Double, EPixelFormat Format = PF_A32B32G32R32F)
{
	FPassRun Run(Image, Arithmetic, Format);
	return Run.Execute(AddREDPostProcessPasses(Run.GraphBuilder, Run.View, Run.Input, Parameters));
}

/** Names of the passes that the chain adds. */
std::vector<std::string> ListPasses(const FREDPostProcessParameters& Parameters)
{
	FPassRun Run(FImage(16, 8), EArithmetic::Native);
	TRefCountPtr<IPooledRenderTarget> Extracted;
	Run.GraphBuilder.QueueTextureExtraction(
		AddREDPostProcessPasses(Run.GraphBuilder, Run.View, Run.Input, Parameters).Texture, &Extracted);
	const Drydock::FRDGCompiledGraph Graph = Run.GraphBuilder.Compile();
	Run.GraphBuilder.Execute();
	std::vector<std::string> Names;
	for (const auto& Pass : Graph.Passes)
	{
		if (!Pass.bIsSentinel)
		{
			Names.push_back(Pass.Name.substr(0, Pass.Name.find(' ')));
		}
	}
	return Names;
}

double Luma(const FTexel& Color)
{
	return 0.299 * Color[0] + 0.587 * Color[1] + 0.114 * Color[2];
}

double Screen(double A, double B)
{
	return 1 - (1 - A) * (1 - B);
}

void ExpectNear(const FTexel& Expected, const FTexel& Color, double Tolerance = 1e-6)
{
	for (int Channel = 0; Channel < 4; ++Channel)
	{
		EXPECT_NEAR(Expected[Channel], Color[Channel], Tolerance) << Channel;
	}
}

FREDPostProcessParameters MakeNeutral()
{
	FREDPostProcessParameters Parameters;
	Parameters.DiffusionFilterIntensity = 0.0f;
	return Parameters;
}

} // namespace

TEST(REDPostProcess, DownSampleIsATwoByTwoMeanWhereSizesAreEven)
{
	const FImage Image = FImage::Noise(16, 10);
	const FImage Expected = FImage::Make(8, 5,
		[&](int X, int Y)
		{
			return (Image.At(2 * X, 2 * Y) + Image.At(2 * X + 1, 2 * Y) + Image.At(2 * X, 2 * Y + 1) +
					   Image.At(2 * X + 1, 2 * Y + 1)) *
				   0.25;
		});
	EXPECT_LE(MaxDifference(Expected, RunPass(Image, EREDPostProcessPass::DownSample), 4), 1e-6);
}

TEST(REDPostProcess, DownSampleOfOddSizesTakesFourTapsHalfATexelOff)
{
	const FImage Image = FImage::Noise(7, 5);
	const FImage Expected = FImage::Make(4, 3,
		[&](int X, int Y)
		{
			FTexel Sum{0, 0, 0, 0};
			for (int Corner = 0; Corner < 4; ++Corner)
			{
				Sum = Sum + PassReference::SampleInRect(Image, {0, 0, 7, 5},
								(X + 0.5) * 7 / 4 + (Corner & 1 ? 0.5 : -0.5),
								(Y + 0.5) * 5 / 3 + (Corner & 2 ? 0.5 : -0.5), true) *
								0.25;
			}
			return Sum;
		});
	// A coordinate may round to the other 1/256 in x and in y.
	EXPECT_LE(MaxDifference(Expected, RunPass(Image, EREDPostProcessPass::DownSample), 4), 2.0 / 256 + 1e-6);
}

TEST(REDPostProcess, DiffusionFilterExtractsByLuma)
{
	FREDPostProcessParameters Parameters;
	Parameters.LuminancePow = 2.0f;
	Parameters.LuminanceThreshold = 0.25f;
	const FTexel Color{0.5, 1, 0.25, 0.5};
	const double Mask = Luma(Color) * Luma(Color) - 0.25;
	ExpectNear({0.5 * Mask, Mask, 0.25 * Mask, 1},
		RunPass(FImage(2, 2, Color), EREDPostProcessPass::DiffusionFilter, Parameters).At(0, 0));
}

TEST(REDPostProcess, ExtractOfNegativeLumaIsBlack)
{
	FREDPostProcessParameters Parameters;
	Parameters.LuminancePow = 0.5f;
	EXPECT_EQ((FTexel{0, 0, 0, 1}),
		RunPass(FImage(2, 2, {-1, -1, -1, 1}), EREDPostProcessPass::DiffusionFilter, Parameters).At(0, 0));
}

TEST(REDPostProcess, LumaBelowZeroCountsAsZeroInTheExtract)
{
	// Where a luma of 0 extracts something the power of a negative one, which is NaN and saturates to 0, would not.
	const FTexel Negative{1, -2, 0, 1}; // luma -0.875
	FREDPostProcessParameters Parameters;
	Parameters.LuminancePow = 0.0f; // 0 to the power 0 is 1
	ExpectNear(Negative, RunPass(FImage(2, 2, Negative), EREDPostProcessPass::DiffusionFilter, Parameters).At(0, 0));
	Parameters.LuminancePow = 2.0f;
	Parameters.LuminanceThreshold = -0.25f;
	ExpectNear(
		{0.25, -0.5, 0, 1}, RunPass(FImage(2, 2, Negative), EREDPostProcessPass::DiffusionFilter, Parameters).At(0, 0));
	Parameters.bAsPrinted = true;
	ExpectNear(
		{0, 0, 0, 1}, RunPass(FImage(2, 2, Negative), EREDPostProcessPass::DiffusionFilter, Parameters).At(0, 0));
}

TEST(REDPostProcess, ExtractWeighsByZeroToOne)
{
	for (const bool bAsPrinted : {false, true})
	{
		FREDPostProcessParameters Parameters;
		Parameters.bAsPrinted = bAsPrinted;
		Parameters.LuminanceThreshold = 0.5f;
		const auto Extract = [&](double Grey)
		{
			return RunPass(FImage(2, 2, {Grey, Grey, Grey, 1}), EREDPostProcessPass::DiffusionFilter, Parameters)
				.At(0, 0)[0];
		};
		EXPECT_EQ(0, Extract(0.25));              // luma below the threshold takes nothing away
		EXPECT_NEAR(0.1875, Extract(0.75), 1e-6); // 0.75 * (0.75 - 0.5)
		EXPECT_NEAR(4, Extract(4), 1e-6);         // and no luma multiplies: 4, not 14
	}
}

TEST(REDPostProcess, DiffusionFilterCombinesByScreenAndPower)
{
	FREDPostProcessParameters Parameters;
	Parameters.DiffusionFilterIntensity = 0.5f;
	Parameters.DiffusionFilterPower = 2.0f;
	const auto Expected = [](double A, double B)
	{
		return std::pow(Screen(A, B * 0.5), 2);
	};
	ExpectNear({Expected(0.5, 0.25), Expected(0.25, 1), Expected(0, 0.5), 0.75},
		Combine({0.5, 0.25, 0, 0.75}, {0.25, 1, 0.5, 1}, EREDPostProcessPass::DiffusionFilter2, Parameters));
}

TEST(REDPostProcess, MaxTakesTheBrighterOfTheTwo)
{
	FREDPostProcessParameters Parameters;
	Parameters.DiffusionFilterBlend = EDiffusionFilterBlend::Max;
	ExpectNear(
		{0.5, 1, 5, 1}, Combine({0.5, 0.25, 5, 1}, {0.25, 1, 3, 1}, EREDPostProcessPass::DiffusionFilter2, Parameters));
}

TEST(REDPostProcess, CorrectedScreenKeepsLightAboveOne)
{
	// Red: 4 = 1 + 3, 2 = 1 + 1: screen(1, 1) + 3 + 1. Green: screen(0.5, 1) + 2. Blue: the negative counts as 0.
	ExpectNear({5, 3, 0.5, 1},
		Combine({4, 0.5, -2, 1}, {2, 3, 0.5, 1}, EREDPostProcessPass::DiffusionFilter2, FREDPostProcessParameters()));
}

TEST(REDPostProcess, PrintedScreenOfLightAboveOneIsNegativeThenNaN)
{
	FREDPostProcessParameters Parameters;
	Parameters.bAsPrinted = true;
	// 1 - (1 - 4)(1 - 2) = -2; to the power 1.5 that is no number.
	Parameters.DiffusionFilterPower = 1.5f;
	EXPECT_TRUE(std::isnan(Combine({4, 4, 4, 1}, {2, 2, 2, 1}, EREDPostProcessPass::DiffusionFilter2, Parameters)[0]));
	Parameters.GlowIntensity = 1.0f;
	EXPECT_NEAR(-2, Combine({4, 4, 4, 1}, {2, 2, 2, 1}, EREDPostProcessPass::Glow, Parameters)[0], 1e-6);
}

TEST(REDPostProcess, PrintedPowerOfANegativeScreenIsNaNForEveryPower)
{
	for (const EArithmetic Arithmetic : {EArithmetic::Float32, EArithmetic::Double})
	{
		for (const float Power : {0.0f, 0.5f, 1.0f, 2.0f, 3.0f})
		{
			FREDPostProcessParameters Parameters;
			Parameters.bAsPrinted = true;
			Parameters.DiffusionFilterPower = Power;
			const FImage Result = RunPass(FImage(4, 4, {4, 0.5, 4, 1}), EREDPostProcessPass::DiffusionFilter2,
				Parameters, FImage(2, 2, {2, 0.5, 2, 1}), Arithmetic);
			EXPECT_TRUE(std::isnan(Result.At(1, 2)[0])) << Power;
			EXPECT_FALSE(std::isnan(Result.At(1, 2)[1])) << Power; // its screen is positive
		}
	}
}

TEST(REDPostProcess, PrintedLastNodeExtractsFromTheBlur)
{
	// From the article: mask = saturate(pow(luma, LuminancePow) - LuminanceThreshold), screen, pow.
	FREDPostProcessParameters Parameters;
	Parameters.bAsPrinted = true;
	Parameters.LuminancePow = 2.0f;
	Parameters.LuminanceThreshold = 0.25f;
	Parameters.DiffusionFilterPower = 1.5f;
	Parameters.DiffusionFilterIntensity = 0.75f;
	const FTexel Color{0.5, 0.25, 0.75, 0.5}, Blurred{0.75, 1, 0.5, 1};
	const double Mask = std::clamp(Luma(Blurred) * Luma(Blurred) - 0.25, 0.0, 1.0);
	const auto Expected = [&](int Channel)
	{
		return std::pow(Screen(Color[Channel], Blurred[Channel] * Mask * 0.75), 1.5);
	};
	ExpectNear({Expected(0), Expected(1), Expected(2), 1},
		Combine(Color, Blurred, EREDPostProcessPass::DiffusionFilter2, Parameters));
	Parameters.LuminanceThreshold = 2.0f; // above every luma to that power: the picture alone
	EXPECT_NEAR(
		std::pow(0.5, 1.5), Combine(Color, Blurred, EREDPostProcessPass::DiffusionFilter2, Parameters)[0], 1e-6);
}

TEST(REDPostProcess, PrintedChainHeedsLuminancePowAndThreshold)
{
	const FImage Image = FImage::Noise(32, 16, 0.25);
	const auto Run = [&](float Pow, float Threshold)
	{
		FREDPostProcessParameters Parameters;
		Parameters.bAsPrinted = true;
		Parameters.LuminancePow = Pow;
		Parameters.LuminanceThreshold = Threshold;
		return RunChain(Image, Parameters);
	};
	EXPECT_GT(MaxDifference(Run(1, 0), Run(2, 0), 3), 0.01);
	EXPECT_GT(MaxDifference(Run(1, 0), Run(1, 0.25f), 3), 0.01);
}

TEST(REDPostProcess, BothFormsGiveTheSameBitsBetweenZeroAndOne)
{
	const FImage Noise = FImage::Noise(16, 8), Blurred = FImage::Noise(8, 4, 1.0, 2);
	const FImage Image = FImage::Make(16, 8,
		[&](int X, int Y)
		{
			const FTexel Texel = Noise.At(X, Y);
			return FTexel{Texel[0], Texel[1], Texel[2], 1}; // the printed last node writes alpha 1
		});
	for (const EREDPostProcessPass Pass :
		{EREDPostProcessPass::DiffusionFilter2, EREDPostProcessPass::SoftFocus, EREDPostProcessPass::Glow})
	{
		FREDPostProcessParameters Parameters;
		Parameters.LuminancePow = 0.0f; // the printed last node then extracts all
		Parameters.DiffusionFilterPower = 1.5f;
		Parameters.GlowIntensity = 0.75f;
		const FImage Corrected = RunPass(Image, Pass, Parameters, Blurred);
		Parameters.bAsPrinted = true;
		EXPECT_EQ(Corrected.Texels, RunPass(Image, Pass, Parameters, Blurred).Texels);
	}
}

TEST(REDPostProcess, SepiaIsTintedLuma)
{
	FREDPostProcessParameters Parameters;
	Parameters.DiffusionFilterIntensity = 0.0f;
	Parameters.Sepia = 0.25f;
	const FTexel Color{0.5, 0.25, 1, 1};
	const double Grey = Luma(Color);
	ExpectNear({0.75 * 0.5 + 0.25 * Grey, 0.75 * 0.25 + 0.25 * Grey * 0.82, 0.75 + 0.25 * Grey * 0.6, 1},
		Combine(Color, {0, 0, 0, 0}, EREDPostProcessPass::DiffusionFilter2, Parameters));
}

TEST(REDPostProcess, SoftFocusMixesThenDesaturates)
{
	FREDPostProcessParameters Parameters;
	Parameters.SoftFocusBlend = 0.5f;
	Parameters.SoftFocusSaturation = 0.25f;
	const FTexel Mixed{0.5, 1, 0.25, 1}; // halfway between the two
	const double Grey = Luma(Mixed);
	ExpectNear({Grey + 0.25 * (0.5 - Grey), Grey + 0.25 * (1 - Grey), Grey + 0.25 * (0.25 - Grey), 0.5},
		Combine({1, 1, 0.25, 0.5}, {0, 1, 0.25, 1}, EREDPostProcessPass::SoftFocus, Parameters));
}

TEST(REDPostProcess, GlowIsAScreenWithTheScaledBlur)
{
	FREDPostProcessParameters Parameters;
	Parameters.GlowIntensity = 0.5f;
	ExpectNear({Screen(0.5, 0.25), Screen(0.25, 0.5), 3 + 0.5, 1},
		Combine({0.5, 0.25, 3, 1}, {0.5, 1, 3, 1}, EREDPostProcessPass::Glow, Parameters)); // blue: 1 + 2 + (1.5 - 1)
}

TEST(REDPostProcess, NeutralParametersBuildNothing)
{
	EXPECT_THAT(ListPasses(MakeNeutral()), testing::IsEmpty());
	const FImage Image = FImage::Noise(5, 3);
	EXPECT_EQ(Image.Texels, RunChain(Image, MakeNeutral()).Texels);
}

TEST(REDPostProcess, DefaultSettingsAreNeutral)
{
	EXPECT_THAT(ListPasses(FREDPostProcessParameters::FromSettings(FFinalPostProcessSettings())), testing::IsEmpty());
}

TEST(REDPostProcess, ChainOfTheDiffusionFilter)
{
	EXPECT_THAT(ListPasses(FREDPostProcessParameters()), testing::ElementsAre("RED.DownSample", "RED.DiffusionFilter",
															 "RED.BlurH", "RED.BlurV", "RED.DiffusionFilter2"));
}

TEST(REDPostProcess, AsPrintedNoExtractComesBeforeTheBlur)
{
	FREDPostProcessParameters Parameters;
	Parameters.bAsPrinted = true;
	EXPECT_THAT(ListPasses(Parameters),
		testing::ElementsAre("RED.DownSample", "RED.BlurH", "RED.BlurV", "RED.DiffusionFilter2"));
}

TEST(REDPostProcess, SoftFocusAndGlowShareOneBlur)
{
	FREDPostProcessParameters Parameters = MakeNeutral();
	Parameters.SoftFocusBlend = 0.5f;
	Parameters.GlowIntensity = 0.5f;
	EXPECT_THAT(ListPasses(Parameters),
		testing::ElementsAre("RED.DownSample", "RED.BlurH", "RED.BlurV", "RED.SoftFocus", "RED.Glow"));
}

TEST(REDPostProcess, AllEffectsBeginFromOneDownsampledPicture)
{
	FREDPostProcessParameters Parameters;
	Parameters.SoftFocusBlend = 0.5f;
	Parameters.GlowIntensity = 0.5f;
	EXPECT_THAT(
		ListPasses(Parameters), testing::ElementsAre("RED.DownSample", "RED.DiffusionFilter", "RED.BlurH", "RED.BlurV",
									"RED.DiffusionFilter2", "RED.BlurH", "RED.BlurV", "RED.SoftFocus", "RED.Glow"));

	const FImage Image = FImage::Noise(33, 17, 2.0);
	const auto Blur = [&](bool bExtract)
	{
		FImage Small = RunPass(Image, EREDPostProcessPass::DownSample);
		Small = bExtract ? RunPass(Small, EREDPostProcessPass::DiffusionFilter) : Small;
		return RunPass(RunPass(Small, EREDPostProcessPass::BlurH), EREDPostProcessPass::BlurV);
	};
	FImage Expected = RunPass(Image, EREDPostProcessPass::DiffusionFilter2, Parameters, Blur(true));
	Expected = RunPass(Expected, EREDPostProcessPass::SoftFocus, Parameters, Blur(false));
	Expected = RunPass(Expected, EREDPostProcessPass::Glow, Parameters, Blur(false));
	EXPECT_EQ(Expected.Texels, RunChain(Image, Parameters).Texels);
}

TEST(REDPostProcess, GlowWithAThresholdExtractsBeforeItsBlur)
{
	FREDPostProcessParameters Parameters = MakeNeutral();
	Parameters.SoftFocusBlend = 0.5f;
	Parameters.GlowIntensity = 0.5f;
	Parameters.GlowLuminanceThreshold = 0.25f;
	EXPECT_THAT(
		ListPasses(Parameters), testing::ElementsAre("RED.DownSample", "RED.BlurH", "RED.BlurV", "RED.SoftFocus",
									"RED.DiffusionFilter", "RED.BlurH", "RED.BlurV", "RED.Glow"));
	Parameters.SoftFocusBlend = 0.0f;
	// A grey of 0.75 has as much above the threshold as 0.75 * (0.75 - 0.25); of a grey of 0.25 nothing glows.
	EXPECT_NEAR(Screen(0.75, 0.375 * 0.5), RunChain(FImage(9, 7, {0.75, 0.75, 0.75, 1}), Parameters).At(4, 3)[1], 1e-6);
	EXPECT_NEAR(0.25, RunChain(FImage(9, 7, {0.25, 0.25, 0.25, 1}), Parameters).At(4, 3)[1], 1e-6);
}

TEST(REDPostProcess, GlowThresholdBeginsWhereNothingIsTakenAway)
{
	// So a volume that brings a threshold begins with the picture without: at -1 the extract changes nothing.
	FREDPostProcessParameters Parameters = MakeNeutral();
	Parameters.GlowIntensity = 1.0f;
	const FImage Image = FImage::Noise(32, 16, 2.0);
	const FImage Without = RunChain(Image, Parameters);
	EXPECT_FALSE(Parameters.WantsGlowExtract());
	Parameters.GlowLuminanceThreshold = -0.999f;
	EXPECT_TRUE(Parameters.WantsGlowExtract());
	EXPECT_LE(MaxDifference(Without, RunChain(Image, Parameters), 4), 0.002);
	FFinalPostProcessSettings Settings;
	EXPECT_EQ(-1.0f, FREDPostProcessParameters::FromSettings(Settings).GlowLuminanceThreshold);
	Settings.GlowLuminanceThreshold = 0.5f;
	EXPECT_EQ(0.5f, FREDPostProcessParameters::FromSettings(Settings).GlowLuminanceThreshold);
}

TEST(REDPostProcess, QuarterResolutionDownsamplesTwice)
{
	FREDPostProcessParameters Parameters = MakeNeutral();
	Parameters.SoftFocusBlend = 1.0f;
	Parameters.bQuarterResolution = true;
	EXPECT_THAT(ListPasses(Parameters),
		testing::ElementsAre("RED.DownSample", "RED.DownSample", "RED.BlurH", "RED.BlurV", "RED.SoftFocus"));

	// A point of light ends up in one pixel of quarter size with a sixteenth of it, and so on in the seven taps.
	FImage Point(64, 64, {0, 0, 0, 1});
	Point.At(33, 33) = {16, 16, 16, 1};
	const FImage Result = RunChain(Point, Parameters, EArithmetic::Exact);
	const double Middle = 0.3990 / 0.9998, Next = 0.2420 / 0.9998;
	// Stretched bilinearly: pixel 33 lies an eighth of a quarter-size texel before the middle of texel 8.
	const double Row = Middle * 0.875 + Next * 0.125;
	EXPECT_NEAR(Row * Row, Result.At(33, 33)[0], 1e-5);
}

TEST(REDPostProcess, QuarterResolutionIsAConsoleVariable)
{
	EXPECT_FALSE(FREDPostProcessParameters::FromSettings(FFinalPostProcessSettings()).bQuarterResolution);
	const FScopedConsoleVariable Quarter(TEXT("r.RED.QuarterResolution"), 1);
	EXPECT_TRUE(FREDPostProcessParameters::FromSettings(FFinalPostProcessSettings()).bQuarterResolution);
}

TEST(REDPostProcess, ChainOnAConstantIsTheFormulaOfTheConstant)
{
	// Extract: luma 0.5, so 0.5 * 0.5 = 0.25 is blurred and screened with 0.5.
	const FImage Result = RunChain(FImage(9, 7, {0.5, 0.5, 0.5, 1}), FREDPostProcessParameters());
	EXPECT_LE(MaxDifference(FImage(9, 7, {0.625, 0.625, 0.625, 1}), Result, 4), 1e-6);
}

TEST(REDPostProcess, ChainNeverDarkensAndNeverMakesNaN)
{
	FREDPostProcessParameters Parameters;
	Parameters.GlowIntensity = 1.0f;
	const FImage Image = FImage::Noise(33, 17, 60000.0);
	const FImage Result = RunChain(Image, Parameters, EArithmetic::Float32);
	for (size_t Index = 0; Index < Image.Texels.size(); ++Index)
	{
		EXPECT_GE(Result.Texels[Index][1], Image.Texels[Index][1]);
	}
}

TEST(REDPostProcess, OffsetRectEqualsTheCroppedPicture)
{
	FREDPostProcessParameters Parameters;
	Parameters.SoftFocusBlend = 0.5f;
	Parameters.GlowIntensity = 0.5f;
	const FImage Image = FImage::Noise(32, 16, 2.0);
	const FImage Cropped = RunChain(Image, Parameters, EArithmetic::Native);
	FPassRun Run(Image, {8, 4, 40, 20}, FIntPoint(64, 32), EArithmetic::Native, PF_A32B32G32R32F);
	const FScreenPassTexture Output = AddREDPostProcessPasses(Run.GraphBuilder, Run.View, Run.Input, Parameters);
	EXPECT_EQ(FIntRect(8, 4, 40, 20), Output.ViewRect);
	EXPECT_EQ(Cropped.Texels, Run.Execute(Output).Texels);
}

TEST(REDPostProcess, EverySizeRuns)
{
	FREDPostProcessParameters Parameters;
	Parameters.GlowIntensity = 0.5f;
	for (const auto& [Width, Height] : {std::pair(1, 1), {1, 2}, {3, 1}, {641, 3}})
	{
		const FImage Result = RunChain(FImage(Width, Height, {0.25, 0.25, 0.25, 1}), Parameters);
		EXPECT_EQ(Width, Result.Width);
		// Extract 0.0625, screened: 0.296875; then with half of the blur 0.25: 1 - 0.703125 * 0.875.
		EXPECT_NEAR(0.384765625, Result.At(0, 0)[1], 1e-6) << Width << "x" << Height;
	}
}

TEST(REDPostProcess, NaNStaysWithinTheBlur)
{
	FImage Image(64, 64, {0.25, 0.25, 0.25, 1});
	Image.At(32, 32) = {NaN, 0.25, 0.25, 1};
	const FImage Result = RunChain(Image, FREDPostProcessParameters(), EArithmetic::Float32);
	const FImage Clean =
		RunChain(FImage(64, 64, {0.25, 0.25, 0.25, 1}), FREDPostProcessParameters(), EArithmetic::Float32);
	EXPECT_EQ(Clean.At(8, 8), Result.At(8, 8)); // three texels of half size and the taps around: below 16
	EXPECT_EQ(Clean.At(63, 32), Result.At(63, 32));
}

TEST(REDPostProcess, OverrideOutputIsWrittenByTheLastPass)
{
	FPassRun Run(FImage::Noise(8, 8), EArithmetic::Native);
	FREDPostProcessParameters Parameters;
	Parameters.GlowIntensity = 0.5f;
	const FScreenPassRenderTarget Override = FScreenPassRenderTarget::CreateFromInput(
		Run.GraphBuilder, Run.Input, ERenderTargetLoadAction::ENoAction, TEXT("Override"));
	const FScreenPassTexture Output =
		AddREDPostProcessPasses(Run.GraphBuilder, Run.View, Run.Input, Parameters, Override);
	EXPECT_EQ(Override.Texture, Output.Texture);
	Run.Execute(Output);
}

TEST(REDPostProcess, InsertionVariableIsClamped)
{
	EXPECT_EQ(EREDPostProcessInsertion::BeforeTranslucency, GetREDPostProcessInsertion());
	const FScopedConsoleVariable Two(TEXT("r.REDPostprocessAfterTranslucency"), 2);
	EXPECT_EQ(EREDPostProcessInsertion::AfterBloom, GetREDPostProcessInsertion());
	const FScopedConsoleVariable Seven(TEXT("r.REDPostprocessAfterTranslucency"), 7);
	EXPECT_EQ(EREDPostProcessInsertion::AfterBloom, GetREDPostProcessInsertion());
}
