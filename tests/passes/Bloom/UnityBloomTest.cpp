// The Unity-style bloom against the article's formulas in double, hand-computed pixels, properties, sizes and hazards.
#include <gmock/gmock.h>

#include "PassTestUtils.h"

#include "Bloom/UnityBloom.h"
#include "Screen/LimitErrors.h"

#include "RenderGraphCompiled.h"

using namespace Drydock;

using namespace PassTest;
using Drydock::FRDGCompiledGraph;
using PassReference::CeilHalf;
using PassReference::MaxDifference;
using PassReference::SumOf;

namespace
{

/** One pass alone on an image, into a target like the image. */
FImage RunPass(const FImage& Image, FUnityBloomPassInputs Inputs, EArithmetic Arithmetic = EArithmetic::Float32)
{
	FPassRun Run(Image, Arithmetic);
	Inputs.Source = Run.Input;
	return Run.Execute(AddUnityBloomPass(Run.GraphBuilder, Run.View, Inputs));
}

FImage Extract(const FImage& Image, float Threshold, EArithmetic Arithmetic = EArithmetic::Float32)
{
	FUnityBloomPassInputs Inputs;
	Inputs.Pass = EUnityBloomPass::Extract;
	Inputs.Threshold = Threshold;
	return RunPass(Image, Inputs, Arithmetic);
}

FImage Blur(const FImage& Image, EUnityBloomPass Pass, float Spread, EArithmetic Arithmetic = EArithmetic::Exact)
{
	FUnityBloomPassInputs Inputs;
	Inputs.Pass = Pass;
	Inputs.Spread = Spread;
	return RunPass(Image, Inputs, Arithmetic);
}

FImage BlurVertically(const FImage& Image, float Spread, EArithmetic Arithmetic = EArithmetic::Exact)
{
	return Blur(Image, EUnityBloomPass::GaussianBlurVertical, Spread, Arithmetic);
}

FImage RunBloom(const FImage& Image, FUnityBloomInputs Inputs = {}, EArithmetic Arithmetic = EArithmetic::Float32)
{
	FPassRun Run(Image, Arithmetic);
	Inputs.SceneColor = Run.Input;
	return Run.Execute(AddUnityBloomPasses(Run.GraphBuilder, Run.View, Inputs));
}

/** What the graph of the whole effect comes to. */
FRDGCompiledGraph CompileBloom(const FImage& Image, FUnityBloomInputs Inputs)
{
	FPassRun Run(Image, EArithmetic::Native);
	Inputs.SceneColor = Run.Input;
	const FScreenPassTexture Output = AddUnityBloomPasses(Run.GraphBuilder, Run.View, Inputs);
	TRefCountPtr<IPooledRenderTarget> Extracted;
	Run.GraphBuilder.QueueTextureExtraction(Output.Texture, &Extracted);
	const FRDGCompiledGraph Graph = Run.GraphBuilder.Compile();
	Run.GraphBuilder.Execute();
	return Graph;
}

/** A black image with one texel lit. */
FImage Impulse(int Width, int Height, int X, int Y, double Light)
{
	FImage Image(Width, Height, {0, 0, 0, 1});
	Image.At(X, Y) = {Light, Light, Light, 1};
	return Image;
}

FImage Transpose(const FImage& Image)
{
	return FImage::Make(Image.Height, Image.Width, [&](int X, int Y) { return Image.At(Y, X); });
}

FTexel SampleAt(const FImage& Image, double U, double V, bool bSnap)
{
	return PassReference::SampleInRect(
		Image, {0, 0, Image.Width, Image.Height}, U * Image.Width, V * Image.Height, bSnap);
}

/** The whole effect from its formulas. The weights of the article sum to 1. */
FImage Expected(const FImage& Image, const FUnityBloomInputs& Inputs, bool bSnap)
{
	const auto Stretch = [](int Index, int Size)
	{
		return (Index + 0.5) / Size;
	};
	FImage Bloom = FImage::Make(CeilHalf(Image.Width), CeilHalf(Image.Height), // for a divisor of 2
		[&](int X, int Y)
		{
			const FTexel Color =
				SampleAt(Image, Stretch(X, CeilHalf(Image.Width)), Stretch(Y, CeilHalf(Image.Height)), bSnap);
			const double Luma = 0.2125 * Color[0] + 0.7154 * Color[1] + 0.0721 * Color[2];
			return Color * std::clamp(Luma - Inputs.Threshold, 0.0, 1.0);
		});
	for (int Iteration = 0; Iteration < Inputs.Iterations; ++Iteration)
	{
		const double Spread = 1 + Iteration * static_cast<double>(Inputs.Spread);
		for (const bool bHorizontal : {false, true})
		{
			Bloom = FImage::Make(Bloom.Width, Bloom.Height,
				[&](int X, int Y)
				{
					const auto Tap = [&](double Distance)
					{
						return PassReference::SampleInRect(Bloom, {0, 0, Bloom.Width, Bloom.Height},
							X + 0.5 + (bHorizontal ? Distance : 0), Y + 0.5 + (bHorizontal ? 0 : Distance), bSnap);
					};
					return Tap(0) * 0.4026 + (Tap(Spread) + Tap(-Spread)) * 0.2442 +
						   (Tap(2 * Spread) + Tap(-2 * Spread)) * 0.0545;
				});
		}
	}
	return FImage::Make(Image.Width, Image.Height,
		[&](int X, int Y)
		{
			FTexel Sum = Image.At(X, Y) +
						 SampleAt(Bloom, Stretch(X, Image.Width), Stretch(Y, Image.Height), bSnap) * Inputs.Intensity;
			Sum[3] = Image.At(X, Y)[3];
			return Sum;
		});
}

class UnityBloomReference : public testing::TestWithParam<EArithmetic>
{
};

} // namespace

TEST_P(UnityBloomReference, WholeEffectAtEverySize)
{
	for (const auto& [Width, Height] : {std::pair(64, 36), {65, 37}, {1, 1}, {1, 9}, {7, 1}, {5, 3}})
	{
		const FImage Image = FImage::Noise(Width, Height, 4.0);
		FUnityBloomInputs Inputs;
		Inputs.Intensity = 0.5f;
		const FImage Result = RunBloom(Image, Inputs, GetParam());
		// Values to 4, each tap's slope to 4 a texel: a coordinate that rounds to the other 1/256 moves a tap by 4/256,
		// in two directions, three iterations and the extract's product. Native: eight stores in half, 2^-11 each.
		const double Tolerance =
			(IsSnapped(GetParam()) ? 0.1 : 1e-4) + (GetParam() == EArithmetic::Native ? 8 * 8 * std::exp2(-11) : 0);
		EXPECT_LE(MaxDifference(Expected(Image, Inputs, IsSnapped(GetParam())), Result, 4), Tolerance)
			<< Width << "x" << Height;
	}
}

INSTANTIATE_TEST_SUITE_P(Arithmetic, UnityBloomReference, testing::ValuesIn(AllArithmetic), FArithmeticName());

TEST(UnityBloom, ExtractMultipliesByWhatLuminanceIsAboveTheThreshold)
{
	const FImage Image = FImage::Make(3, 1,
		[](int X, int) {
			return X == 0 ? FTexel{1, 1, 1, 1} : X == 1 ? FTexel{0, 1, 0, 1} : FTexel{4, 4, 4, 1};
		});
	const FImage Result = Extract(Image, 0.6f);
	EXPECT_NEAR(0.4, Result.At(0, 0)[0], 1e-6);    // L 1: 1 * 0.4
	EXPECT_NEAR(0.1154, Result.At(1, 0)[1], 1e-6); // L 0.7154
	EXPECT_EQ(4, Result.At(2, 0)[2]);              // L 4: the factor stops at 1
}

TEST(UnityBloom, ExtractIsBlackBelowTheThresholdAndWithoutAlpha)
{
	EXPECT_EQ(FImage(4, 4, {0, 0, 0, 0}).Texels, Extract(FImage(4, 4, {0.5, 0.5, 0.5, 1}), 0.6f).Texels);
}

TEST(UnityBloom, ThresholdMinusOneLetsAllOfABrightPixelPass)
{
	EXPECT_EQ(FImage(2, 2, {0.25, 0.25, 0.25, 0}).Texels, Extract(FImage(2, 2, {0.25, 0.25, 0.25, 1}), -1.0f).Texels);
}

TEST(UnityBloom, SoftKneeBeginsBelowTheThresholdAndMeetsTheLineAboveIt)
{
	// A threshold of 1/2 and a knee of half of it: grey x gives x * w(x), w 0 up to 1/4, (x - 1/4)^2 up to 3/4, then
	// x - 1/2.
	const FImage Image = FImage::Make(65, 1,
		[](int X, int)
		{
			const double Grey = X / 64.0;
			return FTexel{Grey, Grey, Grey, 1};
		});
	FUnityBloomPassInputs Inputs;
	Inputs.Threshold = 0.5f;
	Inputs.SoftKnee = 0.5f;
	const FImage Result = RunPass(Image, Inputs);
	for (int X = 0; X <= 64; ++X)
	{
		const double Grey = X / 64.0, FromKnee = std::clamp(Grey - 0.25, 0.0, 0.5);
		const double Weight = std::clamp(std::max(FromKnee * FromKnee, Grey - 0.5), 0.0, 1.0);
		EXPECT_NEAR(Grey * Weight, Result.At(X, 0)[1], 1e-5) << X; // the formula's 1e-5 in the divisor
		EXPECT_EQ(0.0, Result.At(X, 0)[3]);
	}
}

TEST(UnityBloom, SoftKneeOfNothingIsTheSharpThresholdBitForBit)
{
	const FImage Image = FImage::Noise(40, 30, 2.0);
	for (const float Threshold : {-1.0f, 0.0f, 0.6f})
	{
		FUnityBloomPassInputs Inputs;
		Inputs.Threshold = Threshold;
		const FImage Sharp = RunPass(Image, Inputs);
		Inputs.SoftKnee = -1.0f;
		EXPECT_EQ(Sharp.Texels, RunPass(Image, Inputs).Texels);
		// No jump: a knee of a millionth.
		Inputs.SoftKnee = 1e-6f;
		EXPECT_LE(MaxDifference(Sharp, RunPass(Image, Inputs), 4), 1e-5);
		// A threshold of 0 and below has no part to begin in.
		Inputs.SoftKnee = 1.0f;
		EXPECT_EQ(Threshold <= 0.0f, Sharp.Texels == RunPass(Image, Inputs).Texels) << Threshold;
	}
}

TEST(UnityBloom, SoftKneeComesFromTheSettingsAndAsPrintedHasNone)
{
	FFinalPostProcessSettings Settings;
	Settings.UnityBloomSoftKnee = 0.25f;
	EXPECT_EQ(0.25f, FUnityBloomInputs::FromSettings(Settings, {}).SoftKnee);

	const FImage Image = FImage::Noise(16, 16, 1.0);
	FUnityBloomInputs Inputs;
	Inputs.bAsPrinted = true;
	const FImage Printed = RunBloom(Image, Inputs, EArithmetic::Native);
	Inputs.SoftKnee = 1.0f;
	EXPECT_EQ(Printed.Texels, RunBloom(Image, Inputs, EArithmetic::Native).Texels);
	Inputs.bAsPrinted = false;
	const FImage Soft = RunBloom(Image, Inputs, EArithmetic::Native);
	Inputs.SoftKnee = 0.0f;
	EXPECT_GT(SumOf(Soft, 0), SumOf(RunBloom(Image, Inputs, EArithmetic::Native), 0));
}

TEST(UnityBloom, AsPrintedAlphaIsExtractedBlurredAndAdded)
{
	// The lesson multiplies and adds whole fixed4: 0.5 of alpha, a weight of 1 - 0.6. 8 bits hold 0.2 as 51/255.
	FUnityBloomPassInputs Inputs;
	Inputs.bAsPrinted = true;
	const FImage Image(4, 4, {1, 1, 1, 0.5});
	EXPECT_NEAR(0.2, RunPass(Image, Inputs).At(1, 1)[3], 1e-6);

	FUnityBloomInputs Whole;
	Whole.bAsPrinted = true;
	EXPECT_NEAR(0.7, RunBloom(Image, Whole, EArithmetic::Native).At(1, 1)[3], 0.5 / 255);
	Whole.bAsPrinted = false;
	EXPECT_EQ(0.5, RunBloom(Image, Whole, EArithmetic::Native).At(1, 1)[3]);
}

TEST(UnityBloom, BlurHasTheArticlesFiveWeights)
{
	const FImage Result = BlurVertically(Impulse(9, 9, 4, 4, 1), 1.0f, EArithmetic::Double);
	const double Weights[] = {0.0545, 0.2442, 0.4026, 0.2442, 0.0545};
	for (int Tap = 0; Tap < 5; ++Tap)
	{
		EXPECT_NEAR(Weights[Tap], Result.At(4, 2 + Tap)[0], 1e-6) << Tap;
	}
	EXPECT_EQ(0, Result.At(4, 1)[0]);
	EXPECT_EQ(0, Result.At(3, 4)[0]);
}

TEST(UnityBloom, SpreadMovesTheTapsBetweenTexels)
{
	// Taps at 1.6 and 3.2 texels: each lights its two neighbours by the distance to the other one.
	const FImage Result = BlurVertically(Impulse(1, 11, 0, 5, 1), 1.6f);
	EXPECT_NEAR(0.4 * 0.2442, Result.At(0, 6)[0], 1e-5);
	EXPECT_NEAR(0.6 * 0.2442, Result.At(0, 7)[0], 1e-5);
	EXPECT_NEAR(0.8 * 0.0545, Result.At(0, 8)[0], 1e-5);
	EXPECT_NEAR(0.2 * 0.0545, Result.At(0, 9)[0], 1e-5);
}

TEST(UnityBloom, HorizontalBlurIsTheVerticalOneTransposed)
{
	const FImage Image = FImage::Noise(17, 17, 2.0);
	const FImage Vertical = BlurVertically(Image, 1.5f, EArithmetic::Float32);
	EXPECT_EQ(Transpose(Vertical).Texels,
		Blur(Transpose(Image), EUnityBloomPass::GaussianBlurHorizontal, 1.5f, EArithmetic::Float32).Texels);
}

TEST(UnityBloom, BlurKeepsTheLightOfAnImpulse)
{
	EXPECT_NEAR(8, SumOf(BlurVertically(Impulse(5, 33, 2, 16, 8), 2.2f), 1), 1e-5);
}

TEST(UnityBloom, ConstantStaysConstantToTheEdge)
{
	const FImage Result = BlurVertically(FImage(5, 7, {0.75, 0.5, 3, 1}), 2.2f);
	EXPECT_LE(MaxDifference(FImage(5, 7, {0.75, 0.5, 3, 1}), Result, 4), 1e-6);
}

TEST(UnityBloom, DarkPictureIsUnchangedBitForBit)
{
	const FImage Image = FImage::Noise(33, 17, 0.5); // luminance to 0.5, threshold 0.6
	EXPECT_EQ(Image.Texels, RunBloom(Image, {}, EArithmetic::Native).Texels);
}

TEST(UnityBloom, IntensityZeroIsTheIdentityBitForBit)
{
	const FImage Image = FImage::Noise(33, 17, 8.0);
	FUnityBloomInputs Inputs;
	Inputs.Intensity = 0.0f;
	EXPECT_EQ(Image.Texels, RunBloom(Image, Inputs, EArithmetic::Native).Texels);
}

TEST(UnityBloom, NoIterationsAddTheExtractUnblurred)
{
	// 2 * (2 - 0.5) clamped to 2 * 1, added to 2.
	FUnityBloomInputs Inputs;
	Inputs.Iterations = 0;
	Inputs.Threshold = 0.5f;
	EXPECT_EQ(FImage(8, 6, {4, 4, 4, 1}).Texels, RunBloom(FImage(8, 6, {2, 2, 2, 1}), Inputs).Texels);
}

TEST(UnityBloom, GrowsWithIntensityInEveryPixel)
{
	const FImage Image = Impulse(31, 21, 15, 10, 50);
	FUnityBloomInputs Weak, Strong;
	Weak.Intensity = 0.5f;
	Strong.Intensity = 0.75f;
	const FImage A = RunBloom(Image, Weak), B = RunBloom(Image, Strong);
	for (size_t Index = 0; Index < A.Texels.size(); ++Index)
	{
		EXPECT_LE(A.Texels[Index][0], B.Texels[Index][0]);
	}
	EXPECT_LT(SumOf(A, 0), SumOf(B, 0));
}

TEST(UnityBloom, CentroidStaysOnTheLightAtOddSizes)
{
	const FImage Image = Impulse(61, 47, 30, 23, 100); // the exact middle
	const FImage Result = RunBloom(Image, {}, EArithmetic::Exact);
	double Sum = 0, MomentX = 0, MomentY = 0;
	for (int Y = 0; Y < Result.Height; ++Y)
	{
		for (int X = 0; X < Result.Width; ++X)
		{
			const double Light = Result.At(X, Y)[0];
			Sum += Light;
			MomentX += Light * (X + 0.5);
			MomentY += Light * (Y + 0.5);
		}
	}
	EXPECT_NEAR(30.5, MomentX / Sum, 0.01);
	EXPECT_NEAR(23.5, MomentY / Sum, 0.01);
}

TEST(UnityBloom, OffsetRectEqualsTheCroppedPicture)
{
	const FImage Image = FImage::Noise(32, 18, 4.0);
	const FImage Cropped = RunBloom(Image, {}, EArithmetic::Native);
	FPassRun Run(Image, {10, 6, 42, 24}, FIntPoint(64, 64), EArithmetic::Native);
	FUnityBloomInputs Inputs;
	Inputs.SceneColor = Run.Input;
	EXPECT_EQ(Cropped.Texels, Run.Execute(AddUnityBloomPasses(Run.GraphBuilder, Run.View, Inputs)).Texels);
}

TEST(UnityBloom, ResultHasTheRectOfTheScene)
{
	FPassRun Run(FImage(17, 11), {3, 2, 20, 13}, FIntPoint(32, 24), EArithmetic::Native);
	FUnityBloomInputs Inputs;
	Inputs.SceneColor = Run.Input;
	const FScreenPassTexture Output = AddUnityBloomPasses(Run.GraphBuilder, Run.View, Inputs);
	EXPECT_EQ(FIntRect(3, 2, 20, 13), Output.ViewRect);
	Run.Execute(Output);
}

TEST(UnityBloom, OverrideOutputIsWrittenByTheComposite)
{
	FPassRun Run(FImage::Noise(8, 8), EArithmetic::Native);
	FUnityBloomInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.OverrideOutput = FScreenPassRenderTarget::CreateFromInput(
		Run.GraphBuilder, Run.Input, ERenderTargetLoadAction::ENoAction, TEXT("Override"));
	const FScreenPassTexture Output = AddUnityBloomPasses(Run.GraphBuilder, Run.View, Inputs);
	EXPECT_EQ(Inputs.OverrideOutput.Texture, Output.Texture);
	Run.Execute(Output);
}

TEST(UnityBloom, AsPrintedTemporariesCutTheLightAtOne)
{
	// 100 extracted is 100; an 8-bit target holds 1 of it.
	FUnityBloomInputs Inputs;
	Inputs.bAsPrinted = true;
	const FImage Image(16, 16, {100, 100, 100, 1});
	EXPECT_EQ(101, RunBloom(Image, Inputs, EArithmetic::Native).At(8, 8)[0]);
	Inputs.bAsPrinted = false;
	EXPECT_EQ(200, RunBloom(Image, Inputs, EArithmetic::Native).At(8, 8)[0]);
}

TEST(UnityBloom, AsPrintedLosesWhatIsBelowHalfAnEightBitStep)
{
	// The extract is 0.5 * (0.5 - 0.498) = 0.001; a step of 8 bit is 1/255 = 0.0039, one of half at 0.5 is 0.0005.
	FUnityBloomInputs Inputs;
	Inputs.Threshold = 0.498f;
	const FImage Image(16, 16, {0.5, 0.5, 0.5, 1});
	EXPECT_NEAR(0.501, RunBloom(Image, Inputs, EArithmetic::Native).At(8, 8)[0], 0.0003);
	Inputs.bAsPrinted = true;
	EXPECT_EQ(0.5, RunBloom(Image, Inputs, EArithmetic::Native).At(8, 8)[0]);
}

TEST(UnityBloom, SmallTargetIsCeilDividedAndAsPrintedTruncated)
{
	FUnityBloomInputs Inputs;
	Inputs.DownSample = 3;
	EXPECT_THAT(CompileBloom(FImage(13, 7), Inputs).Passes[1].Name, testing::HasSubstr("UnityBloom.Extract 5x3"));
	Inputs.bAsPrinted = true;
	EXPECT_THAT(CompileBloom(FImage(13, 7), Inputs).Passes[1].Name, testing::HasSubstr("UnityBloom.Extract 4x2"));
}

TEST(UnityBloom, DivisorsBelowOneAndBeyondTheSizeAreSafe)
{
	for (const int32 DownSample : {-3, 0, 100})
	{
		FUnityBloomInputs Inputs;
		Inputs.DownSample = DownSample;
		const FImage Result = RunBloom(FImage(5, 3, {2, 2, 2, 1}), Inputs);
		EXPECT_LE(MaxDifference(FImage(5, 3, {4, 4, 4, 1}), Result, 4), 1e-5) << DownSample;
	}
}

TEST(UnityBloom, NoMoreRoundsAreMadeThanHaveAnEffectAndARemarkSaysSo)
{
	const FImage Image = Impulse(16, 9, 5, 4, 8);
	FUnityBloomInputs Inputs;
	Inputs.Iterations = 64;
	const FImage Most = RunBloom(Image, Inputs);
	Inputs.Iterations = std::numeric_limits<int32>::max();
	EXPECT_EQ(0.0, MaxDifference(Most, RunBloom(Image, Inputs)));

	FPassRun Run(Image, EArithmetic::Native);
	Inputs.SceneColor = Run.Input;
	AddUnityBloomPasses(Run.GraphBuilder, Run.View, Inputs);
	const std::vector<FDiagnostic> Notes = GetGraphNotes(Run.GraphBuilder);
	Run.GraphBuilder.Discard();
	ASSERT_EQ(1u, Notes.size());
	EXPECT_EQ(WarnLimited, Notes[0].Code);
	EXPECT_NE(std::string::npos, Notes[0].Message.find("UnityBloomIterations is 2147483647; 64 rounds"))
		<< Notes[0].Message;
}

TEST(UnityBloom, NaNStaysWithinItsFootprint)
{
	FImage Image(64, 64, {0.25, 0.25, 0.25, 1});
	Image.At(32, 32) = {NaN, 1, 1, 1};
	const FImage Result = RunBloom(Image);
	EXPECT_TRUE(std::isnan(Result.At(32, 32)[0]));
	// Reach at half size: 2 * (1 + 1.6 + 2.2) texels and one for each bilinear tap: below 16, 32 at full size.
	EXPECT_EQ(0.25, Result.At(0, 32)[0]);
	EXPECT_EQ(0.25, Result.At(63, 0)[0]);
}

TEST(UnityBloom, LargestHalfStaysFinite)
{
	FUnityBloomInputs Inputs;
	Inputs.Intensity = 0.0f;
	const FImage Image(8, 8, {65504, 65504, 65504, 1});
	EXPECT_EQ(Image.Texels, RunBloom(Image, Inputs, EArithmetic::Native).Texels);
}

TEST(UnityBloom, NegativeLightGivesNoBloom)
{
	const FImage Image(8, 8, {-1, -2, -0.5, 1});
	EXPECT_EQ(Image.Texels, RunBloom(Image).Texels);
}

TEST(UnityBloom, TemporariesAreTakenFromThePoolAgain)
{
	// Seven small textures are declared (the extract, three times two blurs); two live at any time: the one that is
	// read and the one that is written.
	const FRDGCompiledGraph Graph = CompileBloom(FImage(256, 256), {});
	EXPECT_GE(Graph.Memory.WithoutAliasingBytes, 3 * Graph.Memory.TransientPeakBytes);
}

TEST(UnityBloom, PassesAreFoundByName)
{
	EXPECT_EQ(EUnityBloomPass::GaussianBlurVertical, *Drydock::FindUnityBloomPass(TEXT("GaussianBlurVertical")));
	EXPECT_EQ(EUnityBloomPass::Composite, *Drydock::FindUnityBloomPass(TEXT("COMPOSITE")));
	EXPECT_FALSE(Drydock::FindUnityBloomPass(TEXT("Blur")).IsSet());
}

TEST(UnityBloom, AsPrintedFollowsTheTonemapper)
{
	EXPECT_FALSE(IsUnityBloomAfterTonemap());
	const FScopedConsoleVariable AsPrinted(TEXT("r.UnityBloom.AsPrinted"), 1);
	EXPECT_TRUE(IsUnityBloomAfterTonemap());
}

TEST(UnityBloom, InsertionVariableChoosesThePlace)
{
	const FScopedConsoleVariable Insertion(TEXT("r.UnityBloom.Insertion"), 1);
	EXPECT_TRUE(IsUnityBloomAfterTonemap());
}
