// The corrected dual Kawase blur against the double reference, its properties, sizes, rects, targets and hazards.
#include "PassTestUtils.h"

#include "DualKawaseBlurReference.h"

#include "Blur/DualKawaseBlurErrors.h"
#include "Blur/DualKawaseBlurPass.h"
#include "Blur/DualKawaseBlurWidth.h"
#include "RenderGraphNotes.h"

using namespace Drydock;

using namespace PassTest;
using DualKawaseReference::FMoments;
using DualKawaseReference::GetMoments;
using DualKawaseReference::Impulse;
using DualKawaseReference::MeasureBlock;
using PassReference::Crop;
using PassReference::MaxDifference;
using PassReference::SumOf;

namespace
{

FScreenPassTexture AddPass(FPassRun& Run, int Levels, double Offset, const FScreenPassRenderTarget& Override = {})
{
	FDualKawaseBlurInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.PassNum = Levels;
	Inputs.Offset = static_cast<float>(Offset);
	Inputs.OverrideOutput = Override;
	return AddDualKawaseBlurPass(Run.GraphBuilder, Run.View, Inputs);
}

FImage Blur(const FImage& Image, int Levels, double Offset, EArithmetic Arithmetic = EArithmetic::Native,
	EPixelFormat Format = PF_FloatRGBA)
{
	FPassRun Run(Image, Arithmetic, Format);
	return Run.Execute(AddPass(Run, Levels, Offset));
}

/** Values are in 0..1. Exact: coordinates from float parameters miss the taps by a few 2^-24 of the size, twice per
 * level. Native: each of the 2 passes of a level rounds to half, 2^-12. */
double Tolerance(const FImage& Image, int Levels, EArithmetic Arithmetic)
{
	const double Rounding = Arithmetic == EArithmetic::Native ? std::exp2(-12) : 1e-6;
	return 2 * Levels *
		   (Rounding + (IsSnapped(Arithmetic) ? 0 : 8 * std::max(Image.Width, Image.Height) * std::exp2(-24)));
}

std::vector<int> GetNoteCodes(const FPassRun& Run)
{
	std::vector<int> Codes;
	for (const Drydock::FDiagnostic& Note : Drydock::GetGraphNotes(Run.GraphBuilder))
	{
		Codes.push_back(Note.Code);
	}
	return Codes;
}

/** An external texture full of 7, to write into. */
FScreenPassRenderTarget AddTarget(FPassRun& Run, FIntPoint Extent, const FIntRect& Rect, EPixelFormat Format,
	ETextureCreateFlags Flags, ERenderTargetLoadAction LoadAction)
{
	const FRDGTextureDesc Desc = FRDGTextureDesc::Create2D(Extent, Format, FClearValueBinding::Black, Flags);
	const FTextureRHIRef Texture = new FRHITexture(Desc, TEXT("Target"));
	for (int Y = 0; Y < Extent.Y; ++Y)
	{
		for (int X = 0; X < Extent.X; ++X)
		{
			Texture->WriteTexelDouble(X, Y, FVector4(7, 7, 7, 7));
		}
	}
	return FScreenPassRenderTarget(
		Run.GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, TEXT("Target"))), Rect, LoadAction);
}

FImage ExecuteWhole(FPassRun& Run, FRDGTextureRef Texture)
{
	return Run.Execute(FScreenPassTexture(Texture));
}

class DualKawaseReferenceTest : public testing::TestWithParam<EArithmetic>
{
};

} // namespace

TEST_P(DualKawaseReferenceTest, EverySizeLevelAndOffset)
{
	for (const auto& [Width, Height] : {std::pair(64, 36), {65, 37}, {127, 31}, {3, 3}, {4, 100}, {9, 5}, {17, 64}})
	{
		const FImage Image = FImage::Noise(Width, Height);
		for (const auto& [Levels, Offset] : {std::pair(1, 1.0), {1, 0.3}, {2, 1.0}, {3, 1.37}, {4, 2.5}, {3, 0.0}})
		{
			const int Run = Drydock::GetDualKawaseLevelSizes(FIntPoint(Width, Height), Levels).Num() - 1;
			EXPECT_LE(MaxDifference(
						  DualKawaseReference::Blur(Image, Run, Offset), Blur(Image, Levels, Offset, GetParam()), 4),
				Tolerance(Image, Levels, GetParam()))
				<< Width << "x" << Height << ", " << Levels << " levels, offset " << Offset;
		}
	}
}

INSTANTIATE_TEST_SUITE_P(Arithmetic, DualKawaseReferenceTest, testing::ValuesIn(AllArithmetic), FArithmeticName());

TEST(DualKawase, EightLevels)
{
	const FImage Image = FImage::Noise(521, 389);
	EXPECT_LE(
		MaxDifference(DualKawaseReference::Blur(Image, 8, 1.0), Blur(Image, 8, 1.0, EArithmetic::Float32), 4), 1e-5);
}

TEST(DualKawase, CentroidOfAnImpulseStaysAtOffsetOne)
{
	for (const auto& [Width, Height] : {std::pair(256, 224), {255, 221}, {251, 229}})
	{
		for (const auto& [X, Y] :
			{std::pair(Width / 2, Height / 2), {Width / 2 + 1, Height / 2}, {Width / 2 + 3, Height / 2 + 5}})
		{
			for (int Levels = 1; Drydock::GetDualKawaseReach(Levels, 1.0) < Height / 2 - 5; ++Levels)
			{
				const FMoments Moments = GetMoments(Blur(Impulse(Width, Height, X, Y, 32768), Levels, 1.0), X, Y);
				EXPECT_NEAR(0, Moments.X / Moments.Sum, 0.01) << Width << "x" << Height << ", " << Levels << " levels";
				EXPECT_NEAR(0, Moments.Y / Moments.Sum, 0.01) << Width << "x" << Height << ", " << Levels << " levels";
			}
		}
	}
}

TEST(DualKawase, MeanCentroidOverABlockStaysAtOtherOffsets)
{
	for (const auto& [Levels, Offset] : {std::pair(1, 0.4), {1, 1.9}, {2, 0.75}, {2, 1.5}})
	{
		const auto Run = [Levels = Levels, Offset = Offset](const FImage& Image)
		{
			return Blur(Image, Levels, Offset, EArithmetic::Float32);
		};
		const FMoments Moments = MeasureBlock(61, 59, 1 << Levels, Run);
		EXPECT_NEAR(0, Moments.X / Moments.Sum, 0.01) << Levels << " levels, offset " << Offset;
		EXPECT_NEAR(0, Moments.Y / Moments.Sum, 0.01) << Levels << " levels, offset " << Offset;
	}
}

TEST(DualKawase, MeasuredWidthIsTheClosedForm)
{
	for (const auto& [Levels, Offset] : {std::pair(1, 1.0), {2, 1.0}, {2, 0.6}, {2, 1.3}})
	{
		const auto Run = [Levels = Levels, Offset = Offset](const FImage& Image)
		{
			return Blur(Image, Levels, Offset, EArithmetic::Float32);
		};
		const FMoments Moments = MeasureBlock(64, 61, 1 << Levels, Run);
		const double Variance = Drydock::GetDualKawaseVariance(Levels, Offset);
		EXPECT_NEAR(1, Moments.XX / Moments.Sum / Variance, 1e-5) << Levels << " levels, offset " << Offset;
		EXPECT_NEAR(1, Moments.YY / Moments.Sum / Variance, 1e-5) << Levels << " levels, offset " << Offset;
	}
}

TEST(DualKawase, MeasuredWidthIsTheWantedOne)
{
	for (const double Wanted : {1.3, 2.0, 3.7})
	{
		const Drydock::FDualKawaseSetting Setting = Drydock::MatchDualKawaseWidth(Wanted).Setting;
		const auto Run = [&Setting](const FImage& Image)
		{
			return Blur(Image, Setting.PassNum, Setting.Offset, EArithmetic::Float32);
		};
		const FMoments Moments = MeasureBlock(64, 64, 1 << Setting.PassNum, Run);
		EXPECT_NEAR(Wanted, std::sqrt(Moments.XX / Moments.Sum), 0.0025 * Wanted);
	}
}

TEST(DualKawase, MeasuredWidthGrowsWithLevelsAndOffset)
{
	const auto Measure = [](int Levels, double Offset)
	{
		const FMoments Moments =
			GetMoments(Blur(Impulse(128, 128, 64, 64), Levels, Offset, EArithmetic::Float32), 64, 64);
		return Moments.XX / Moments.Sum;
	};
	EXPECT_LT(Measure(1, 1.0), Measure(2, 1.0));
	EXPECT_LT(Measure(2, 1.0), Measure(3, 1.0));
	EXPECT_LT(Measure(2, 0.5), Measure(2, 1.0));
	EXPECT_LT(Measure(2, 1.0), Measure(2, 2.0));
}

TEST(DualKawase, ConstantStaysBitForBitInFormatsOfUpToSixteenBits)
{
	for (const EPixelFormat Format : {PF_FloatRGBA, PF_FloatR11G11B10, PF_B8G8R8A8, PF_A16B16G16R16})
	{
		const FImage Constant(37, 23, {0.7, 0.123, 0.999, 1});
		FPassRun Run(Constant, EArithmetic::Native, Format);
		TRefCountPtr<IPooledRenderTarget> Input;
		Run.GraphBuilder.QueueTextureExtraction(Run.Input.Texture, &Input);
		const FImage Result = Run.Execute(AddPass(Run, 4, 0.77));
		EXPECT_EQ(ReadTexture(Input->GetRHI()).Texels, Result.Texels) << GetPixelFormatString(Format);
	}
}

TEST(DualKawase, ConstantStaysWithinAMillionthInFloat)
{
	const FImage Constant(37, 23, {0.7, 0.123, 3.999, 1});
	EXPECT_LE(MaxDifference(Constant, Blur(Constant, 4, 0.77, EArithmetic::Float32), 4), 4e-6);
}

TEST(DualKawase, SumIsKeptAtWholeOffsets)
{
	// The light lies further from the edges than the blur reaches: 3 * 3 * (2^2 - 1) = 27 pixels at offset 2.
	const FImage Noise = FImage::Noise(16, 16);
	const FImage Image = FImage::Make(78, 75,
		[&](int X, int Y) {
			return X >= 31 && X < 47 && Y >= 29 && Y < 45 ? Noise.At(X - 31, Y - 29) : FTexel{0, 0, 0, 0};
		});
	for (const double Offset : {0.0, 1.0, 2.0})
	{
		EXPECT_NEAR(1, SumOf(Blur(Image, 2, Offset, EArithmetic::Float32), 0) / SumOf(Image, 0), 1e-5) << Offset;
	}
}

TEST(DualKawase, SumIsKeptAsTheMeanOverPositionsAtOtherOffsets)
{
	const auto Run = [](const FImage& Image)
	{
		return Blur(Image, 2, 1.4, EArithmetic::Float32);
	};
	EXPECT_NEAR(16, MeasureBlock(64, 64, 4, Run).Sum, 1e-4);
}

TEST(DualKawase, RampStaysARampAwayFromTheBorders)
{
	const FImage Ramp = FImage::Make(97, 83, [](int X, int Y) { return FTexel{X / 8.0, Y / 8.0, 0, 1}; });
	const int Reach = Drydock::GetDualKawaseReach(2, 1.3);
	const PassReference::FRect Inside{Reach, Reach, 97 - Reach, 83 - Reach};
	ASSERT_GT(Inside.Height(), 10);
	EXPECT_LE(MaxDifference(Crop(Ramp, Inside), Crop(Blur(Ramp, 2, 1.3, EArithmetic::Float32), Inside)), 1e-5);
}

TEST(DualKawase, TransposedImageGivesTheTransposedResult)
{
	const auto Transpose = [](const FImage& Image)
	{
		return FImage::Make(Image.Height, Image.Width, [&](int X, int Y) { return Image.At(Y, X); });
	};
	const FImage Image = FImage::Noise(45, 33);
	EXPECT_LE(MaxDifference(Transpose(Blur(Image, 3, 1.2, EArithmetic::Float32)),
				  Blur(Transpose(Image), 3, 1.2, EArithmetic::Float32)),
		1e-6);
}

TEST(DualKawase, MirroredImageGivesTheMirroredResultWhereSizesHalveEvenly)
{
	const auto Mirror = [](const FImage& Image)
	{
		return FImage::Make(Image.Width, Image.Height, [&](int X, int Y) { return Image.At(Image.Width - 1 - X, Y); });
	};
	const FImage Image = FImage::Noise(48, 40);
	EXPECT_LE(MaxDifference(
				  Mirror(Blur(Image, 3, 0.8, EArithmetic::Float32)), Blur(Mirror(Image), 3, 0.8, EArithmetic::Float32)),
		1e-6);
}

TEST(DualKawase, ResultHasTheInputsExtentRectAndFormat)
{
	FPassRun Run(FImage::Noise(30, 20), {5, 3, 35, 23}, FIntPoint(64, 48), EArithmetic::Native, PF_FloatR11G11B10);
	const FScreenPassTexture Output = AddPass(Run, 2, 1.0);
	EXPECT_EQ(FIntRect(5, 3, 35, 23), Output.ViewRect);
	EXPECT_EQ(FIntPoint(64, 48), Output.Texture->Desc.Extent);
	EXPECT_EQ(PF_FloatR11G11B10, Output.Texture->Desc.Format);
	Run.Execute(Output);
}

TEST(DualKawase, LevelsHaveTheirCeilDividedSizeAndTheInputsFormat)
{
	FPassRun Run(FImage::Noise(37, 23), {5, 3, 42, 26}, FIntPoint(64, 48), EArithmetic::Native, PF_FloatR11G11B10);
	const FScreenPassTexture Output = AddPass(Run, 2, 1.0);
	TRefCountPtr<IPooledRenderTarget> Extracted;
	Run.GraphBuilder.QueueTextureExtraction(Output.Texture, &Extracted);
	std::map<std::string, FIntPoint> Extents;
	for (const Drydock::FRDGResourceDescription& Resource : Run.GraphBuilder.Compile().Resources)
	{
		if (Resource.Name.starts_with("DualKawase"))
		{
			EXPECT_EQ(PF_FloatR11G11B10, Resource.Format) << Resource.Name;
			Extents[Resource.Name] = FIntPoint(Resource.Extent.X, Resource.Extent.Y);
		}
	}
	EXPECT_EQ((std::map<std::string, FIntPoint>{{"DualKawaseDown1", {19, 12}}, {"DualKawaseDown2", {10, 6}},
				  {"DualKawaseUp2", {19, 12}}, {"DualKawaseUp1", {64, 48}}}),
		Extents);
	Run.GraphBuilder.Execute();
}

TEST(DualKawase, OffsetRectGivesTheBitsOfTheCroppedImage)
{
	const FImage Image = FImage::Noise(53, 31, 100);
	for (const double Offset : {1.0, 0.7, 1.0 + 1.0 / 512, 2.3})
	{
		const FImage Cropped = Blur(Image, 3, Offset);
		FPassRun Run(Image, {11, 7, 64, 38}, FIntPoint(127, 65), EArithmetic::Native);
		EXPECT_EQ(Cropped.Texels, Run.Execute(AddPass(Run, 3, Offset)).Texels) << Offset;
	}
}

TEST(DualKawase, NothingOutsideTheRectIsReadOrWritten)
{
	// What lies around the input's rect is NaN, around the output's 7.
	const FImage Image = FImage::Noise(29, 21);
	const FImage Expected = Blur(Image, 2, 1.5);
	FPassRun Run(Image, {4, 6, 33, 27}, FIntPoint(48, 40), EArithmetic::Native);
	const FScreenPassRenderTarget Target = AddTarget(Run, FIntPoint(48, 40), FIntRect(4, 6, 33, 27), PF_FloatRGBA,
		TexCreate_UAV | TexCreate_ShaderResource, ERenderTargetLoadAction::ELoad);
	EXPECT_EQ(Target.Texture, AddPass(Run, 2, 1.5, Target).Texture);
	const FImage Whole = ExecuteWhole(Run, Target.Texture);
	EXPECT_EQ(Expected.Texels, Crop(Whole, {4, 6, 33, 27}).Texels);
	for (int Y = 0; Y < 40; ++Y)
	{
		for (int X = 0; X < 48; ++X)
		{
			if (X < 4 || X >= 33 || Y < 6 || Y >= 27)
			{
				EXPECT_EQ(7, Whole.At(X, Y)[0]) << X << ", " << Y;
			}
		}
	}
}

TEST(DualKawase, OverrideOutputThatComputeCannotWriteIsDrawnTo)
{
	const FImage Image = FImage::Noise(29, 21);
	const FImage Expected = Blur(Image, 2, 1.0);
	FPassRun Run(Image, EArithmetic::Native);
	const FScreenPassRenderTarget Target = AddTarget(Run, FIntPoint(40, 30), FIntRect(8, 9, 37, 30), PF_FloatRGBA,
		TexCreate_RenderTargetable, ERenderTargetLoadAction::ELoad);
	const FScreenPassTexture Output = AddPass(Run, 2, 1.0, Target);
	EXPECT_EQ(Target.Texture, Output.Texture);
	EXPECT_EQ(Target.ViewRect, Output.ViewRect);
	const FImage Whole = ExecuteWhole(Run, Target.Texture);
	EXPECT_EQ(Expected.Texels, Crop(Whole, {8, 9, 37, 30}).Texels);
	EXPECT_EQ(7, Whole.At(7, 9)[0]);
}

TEST(DualKawase, OverrideOutputToBeClearedIsCleared)
{
	const FImage Image = FImage::Noise(29, 21);
	const FImage Expected = Blur(Image, 2, 1.0);
	FPassRun Run(Image, EArithmetic::Native);
	const FScreenPassRenderTarget Target = AddTarget(Run, FIntPoint(40, 30), FIntRect(8, 9, 37, 30), PF_FloatRGBA,
		TexCreate_RenderTargetable | TexCreate_UAV, ERenderTargetLoadAction::EClear);
	AddPass(Run, 2, 1.0, Target);
	const FImage Whole = ExecuteWhole(Run, Target.Texture);
	EXPECT_EQ(Expected.Texels, Crop(Whole, {8, 9, 37, 30}).Texels);
	EXPECT_EQ(0, Whole.At(7, 9)[0]);
}

TEST(DualKawase, OverrideOutputOfAnotherSizeIsScaledTo)
{
	const FImage Ramp = FImage::Make(64, 64, [](int X, int Y) { return FTexel{(X + 0.5) / 64, (Y + 0.5) / 64, 0, 1}; });
	FPassRun Run(Ramp, EArithmetic::Float32);
	const FScreenPassRenderTarget Target = AddTarget(Run, FIntPoint(96, 48), FIntRect(0, 0, 96, 48), PF_FloatRGBA,
		TexCreate_UAV | TexCreate_ShaderResource, ERenderTargetLoadAction::ENoAction);
	const FImage Result = Run.Execute(AddPass(Run, 1, 1.0, Target));
	// Within half a grid step of the coarse level: 1/512 of 1/32.
	EXPECT_NEAR(48.5 / 96, Result.At(48, 24)[0], 1e-4);
	EXPECT_NEAR(24.5 / 48, Result.At(48, 24)[1], 1e-4);
}

TEST(DualKawase, TinyImageStaysAsItIs)
{
	for (const auto& [Width, Height] : {std::pair(1, 1), {2, 2}, {1, 40}, {40, 2}})
	{
		FPassRun Run(FImage::Noise(Width, Height), EArithmetic::Native);
		const FScreenPassTexture Output = AddPass(Run, 3, 1.0);
		EXPECT_EQ(Run.Input, Output);
		EXPECT_EQ(std::vector<int>{Drydock::DualKawaseNoteLevels}, GetNoteCodes(Run));
		Run.Execute(Output);
	}
}

TEST(DualKawase, TinyImageIsCopiedToTheOverrideOutput)
{
	const FImage Image = FImage::Noise(2, 5);
	FPassRun Run(Image, EArithmetic::Native);
	const FScreenPassRenderTarget Target = AddTarget(Run, FIntPoint(4, 8), FIntRect(1, 2, 3, 7), PF_FloatRGBA,
		TexCreate_UAV | TexCreate_ShaderResource, ERenderTargetLoadAction::ELoad);
	EXPECT_EQ(Image.Texels, Run.Execute(AddPass(Run, 3, 1.0, Target)).Texels);
}

TEST(DualKawase, NaNSpreadsOverTheReachAndNoFurther)
{
	FImage Image(64, 64, {1, 1, 1, 1});
	Image.At(31, 33)[0] = NaN;
	const FImage Result = Blur(Image, 2, 1.0);
	const int Reach = Drydock::GetDualKawaseReach(2, 1.0); // 18
	EXPECT_TRUE(std::isnan(Result.At(31, 33)[0]));
	for (int Y = 0; Y < 64; ++Y)
	{
		for (int X = 0; X < 64; ++X)
		{
			EXPECT_EQ(1, Result.At(X, Y)[1]);
			if (std::abs(X - 31) > Reach || std::abs(Y - 33) > Reach)
			{
				EXPECT_EQ(1, Result.At(X, Y)[0]) << X << ", " << Y;
			}
		}
	}
}

TEST(DualKawase, InfinityStaysInfiniteAndMakesNoNaN)
{
	FImage Image(64, 64, {1, 1, 1, 1});
	Image.At(31, 33)[0] = Infinity;
	const FImage Result = Blur(Image, 2, 1.0);
	EXPECT_EQ(Infinity, Result.At(31, 33)[0]);
	for (const FTexel& Texel : Result.Texels)
	{
		EXPECT_TRUE(Texel[0] == 1 || Texel[0] == Infinity) << Texel[0];
	}
}

TEST(DualKawase, LargestHalfDoesNotOverflow)
{
	const FImage Bright(33, 17, {65504, 65504, 65504, 1});
	EXPECT_EQ(Bright.Texels, Blur(Bright, 3, 1.3).Texels);
}

TEST(DualKawase, NegativesPassOn)
{
	const FImage Negative(33, 17, {-2, -0.5, 0, -1});
	EXPECT_EQ(Negative.Texels, Blur(Negative, 3, 1.3).Texels);
}

TEST(DualKawase, PassNumIsHeldWithinNoneAndEight)
{
	const FImage Image = FImage::Noise(20, 20);
	EXPECT_EQ(Image.Texels, Blur(Image, 0, 1.0).Texels);
	EXPECT_EQ(Image.Texels, Blur(Image, -1, 1.0).Texels);
	FPassRun Run(FImage::Noise(600, 600), EArithmetic::Native);
	const FScreenPassTexture Output = AddPass(Run, 99, 1.0);
	EXPECT_STREQ("DualKawaseUp1", Output.Texture->Name);
	EXPECT_EQ("the blur has at most 8 of 99 levels; it is narrower than wanted",
		Drydock::GetGraphNotes(Run.GraphBuilder).at(0).Message);
	Run.Execute(Output);
}

TEST(DualKawase, RemarksOnWhatIsNotAsWanted)
{
	FPassRun Run(FImage::Noise(33, 16), EArithmetic::Native);
	const FScreenPassTexture Output = AddPass(Run, 4, 2.5);
	EXPECT_EQ((std::vector<int>{
				  Drydock::DualKawaseNoteLevels, Drydock::DualKawaseNoteBlocky, Drydock::DualKawaseNotePrintedLoss}),
		GetNoteCodes(Run));
	const std::vector<Drydock::FDiagnostic> Notes = Drydock::GetGraphNotes(Run.GraphBuilder);
	EXPECT_EQ("a picture of 33x16 pixels has room for 3 of 4 levels; it is narrower than wanted", Notes[0].Message);
	EXPECT_EQ(
		"as the article prints it, halving 33x16 and doubling it again 4 times would lose 1 column and 0 rows: the "
		"result is 32x16, and what follows stretches or crops it",
		Notes[2].Message);
	EXPECT_EQ(Drydock::ESeverity::Note, Notes[2].Severity);
	Run.Execute(Output);
}

TEST(DualKawase, NoRemarkWhereAllIsWell)
{
	FPassRun Run(FImage::Noise(64, 32), EArithmetic::Native);
	const FScreenPassTexture Output = AddPass(Run, 3, 1.0);
	EXPECT_EQ(std::vector<int>{}, GetNoteCodes(Run));
	Run.Execute(Output);
}
