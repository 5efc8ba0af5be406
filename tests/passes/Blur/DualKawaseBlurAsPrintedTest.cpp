// The dual Kawase blur as the article prints it: its sizes, its taps, its faults.
#include "PassTestUtils.h"

#include "DualKawaseBlurReference.h"

#include "Blur/DualKawaseBlurErrors.h"
#include "Blur/DualKawaseBlurPass.h"
#include "RenderGraphNotes.h"

using namespace Drydock;

using namespace PassTest;
using DualKawaseReference::FTap;
using DualKawaseReference::GetMoments;
using DualKawaseReference::Impulse;
using PassReference::MaxDifference;

namespace
{

FScreenPassTexture AddPass(FPassRun& Run, int Levels, float Offset = 1.0f)
{
	FDualKawaseBlurInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.PassNum = Levels;
	Inputs.Offset = Offset;
	Inputs.bAsPrinted = true;
	return AddDualKawaseBlurPass(Run.GraphBuilder, Run.View, Inputs);
}

FImage Blur(const FImage& Image, int Levels, float Offset = 1.0f)
{
	FPassRun Run(Image, EArithmetic::Float32);
	return Run.Execute(AddPass(Run, Levels, Offset));
}

/** One pass: the input stretched over the output; taps in half pixels of the output, nearest texel, wrapping around. */
FImage AverageNearest(const FImage& In, int Width, int Height, double Offset, const std::vector<FTap>& Taps)
{
	const auto Wrap = [](double Coordinate, int Size)
	{
		const int Texel = static_cast<int>(std::floor(std::floor(Coordinate * 256 + 0.5) / 256));
		return ((Texel % Size) + Size) % Size;
	};
	return FImage::Make(Width, Height,
		[&](int X, int Y)
		{
			FTexel Color{0, 0, 0, 0};
			double Sum = 0;
			for (const FTap& Tap : Taps)
			{
				const double U = (X + 0.5 + Tap.X * 0.5 * Offset) * In.Width / Width;
				const double V = (Y + 0.5 + Tap.Y * 0.5 * Offset) * In.Height / Height;
				Color = Color + In.At(Wrap(U, In.Width), Wrap(V, In.Height)) * Tap.Weight;
				Sum += Tap.Weight;
			}
			return Color * (1 / Sum);
		});
}

const std::vector<FTap> DownTaps = {{0, 0, 4}, {-1, -1, 1}, {1, -1, 1}, {-1, 1, 1}, {1, 1, 1}};
const std::vector<FTap> UpTaps = {
	{-2, 0, 1}, {2, 0, 1}, {0, -2, 1}, {0, 2, 1}, {-1, -1, 2}, {1, -1, 2}, {-1, 1, 2}, {1, 1, 2}};

} // namespace

TEST(DualKawaseAsPrinted, TwoLevelsOfAnEvenImage)
{
	// An offset that leaves no tap on a border between texels, where a last bit would decide.
	const FImage Image = FImage::Noise(32, 24);
	FImage Expected = AverageNearest(Image, 32, 24, 0.9, DownTaps);
	Expected = AverageNearest(Expected, 16, 12, 0.9, DownTaps);
	Expected = AverageNearest(Expected, 16, 12, 0.9, UpTaps);
	Expected = AverageNearest(Expected, 32, 24, 0.9, UpTaps);
	EXPECT_LE(MaxDifference(Expected, Blur(Image, 2, 0.9f), 4), 1e-6);
}

TEST(DualKawaseAsPrinted, OddSizesLoseColumnsAndRows)
{
	FPassRun Run(FImage::Noise(43, 11), EArithmetic::Native);
	const FScreenPassTexture Output = AddPass(Run, 2);
	EXPECT_EQ(FIntRect(0, 0, 40, 8), Output.ViewRect);
	EXPECT_EQ(FIntPoint(40, 8), Output.Texture->Desc.Extent);
	const std::vector<Drydock::FDiagnostic> Notes = Drydock::GetGraphNotes(Run.GraphBuilder);
	ASSERT_EQ(1u, Notes.size());
	EXPECT_EQ(Drydock::ESeverity::Warning, Notes[0].Severity);
	EXPECT_EQ(Drydock::DualKawaseNotePrintedLoss, Notes[0].Code);
	EXPECT_EQ(
		"as the article prints it, halving 43x11 and doubling it again 2 times loses 3 columns and 3 rows: the result "
		"is 40x8, and what follows stretches or crops it; r.DualKawase.AsPrinted 0 keeps all",
		Notes[0].Message);
	Run.Execute(Output);
}

TEST(DualKawaseAsPrinted, TheArticlesWidthLosesTwentyTwoColumns)
{
	FPassRun Run(FImage(1366, 32), EArithmetic::Native);
	const FScreenPassTexture Output = AddPass(Run, 5);
	EXPECT_EQ(1344, Output.ViewRect.Width());
	EXPECT_NE(std::string::npos, Drydock::GetGraphNotes(Run.GraphBuilder).at(0).Message.find("22 columns and 0 rows"));
	Run.Execute(Output);
}

TEST(DualKawaseAsPrinted, AnImpulseDrifts)
{
	const DualKawaseReference::FMoments Moments = GetMoments(Blur(Impulse(101, 101, 50, 50), 2), 50, 50);
	EXPECT_GT(std::abs(Moments.X / Moments.Sum), 0.5);
}

TEST(DualKawaseAsPrinted, TheViewRectIsIgnored)
{
	// What lies around the rect is NaN; the picture is 16x16 of it.
	FPassRun Run(FImage(16, 16, {1, 1, 1, 1}), {8, 8, 24, 24}, FIntPoint(32, 32), EArithmetic::Native);
	const FScreenPassTexture Output = AddPass(Run, 1);
	EXPECT_EQ(FIntRect(0, 0, 32, 32), Output.ViewRect);
	EXPECT_TRUE(std::isnan(Run.Execute(Output).At(8, 8)[0]));
}

TEST(DualKawaseAsPrinted, TexturesHaveTheUAVFlagOnly)
{
	FPassRun Run(FImage::Noise(16, 16), EArithmetic::Native);
	const FScreenPassTexture Output = AddPass(Run, 1);
	EXPECT_EQ(TexCreate_UAV, Output.Texture->Desc.Flags);
	Run.Execute(Output);
}

TEST(DualKawaseAsPrinted, OverrideOutputIsNotWritten)
{
	FPassRun Run(FImage::Noise(16, 16), EArithmetic::Native);
	FDualKawaseBlurInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.bAsPrinted = true;
	Inputs.OverrideOutput = FScreenPassRenderTarget::CreateFromInput(
		Run.GraphBuilder, Run.Input, ERenderTargetLoadAction::ENoAction, TEXT("Override"));
	const FScreenPassTexture Output = AddDualKawaseBlurPass(Run.GraphBuilder, Run.View, Inputs);
	EXPECT_NE(Inputs.OverrideOutput.Texture, Output.Texture);
	Run.Execute(Output);
}

TEST(DualKawaseAsPrinted, TooSmallAnImageStaysAsItIs)
{
	FPassRun Run(FImage::Noise(1, 9), EArithmetic::Native);
	EXPECT_EQ(Run.Input, AddPass(Run, 3));
	Run.Execute(Run.Input);
}

TEST(DualKawaseAsPrinted, IsChosenByTheConsoleVariable)
{
	EXPECT_FALSE(IsDualKawaseAsPrinted());
	const FScopedConsoleVariable AsPrinted(TEXT("r.DualKawase.AsPrinted"), 1);
	EXPECT_TRUE(IsDualKawaseAsPrinted());
}
