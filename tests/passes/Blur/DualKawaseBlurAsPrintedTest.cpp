// The dual Kawase blur as the article prints it: its sizes, its taps, its faults.
#include "PassTestUtils.h"

#include "DualKawaseBlurReference.h"

#include "Blur/DualKawaseBlurErrors.h"
#include "Blur/DualKawaseBlurPass.h"
#include "RenderGraphNotes.h"

#include <algorithm>
#include <cmath>

using namespace Drydock;

using namespace PassTest;
using DualKawaseReference::GetMoments;
using DualKawaseReference::Impulse;

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

// The article a second time, from its text and in its precision: sizes and passes from its C++ (the first pass down at
// the picture's size, integers halved and doubled, point sampler, clamped on all axes, ViewSize the size of what is
// written), taps as it describes them, corners and then sides and corners: Bjorge's filter, "Bandwidth-Efficient
// Rendering", SIGGRAPH 2015.

struct FFloatTap
{
	float X, Y, Weight;
};

/** What a point sampler with clamped addresses takes at this coordinate: snapped to 1/256 texel, then the texel. */
int GetClampedTexel(float Coordinate, int Size)
{
	const int Texel = static_cast<int>(std::floor(Coordinate * static_cast<float>(Size) * 256.0f + 0.5f)) >> 8;
	return std::clamp(Texel, 0, Size - 1);
}

FImage RunArticlePass(const FImage& In, int Width, int Height, float Offset, const std::vector<FFloatTap>& Taps)
{
	float WeightSum = 0;
	for (const FFloatTap& Tap : Taps)
	{
		WeightSum += Tap.Weight;
	}
	const float SizeX = static_cast<float>(Width), SizeY = static_cast<float>(Height);
	return FImage::Make(Width, Height,
		[&](int X, int Y)
		{
			float Sum[4] = {};
			for (const FFloatTap& Tap : Taps)
			{
				const float U = (static_cast<float>(X) + 0.5f) / SizeX + Tap.X * (0.5f / SizeX * Offset);
				const float V = (static_cast<float>(Y) + 0.5f) / SizeY + Tap.Y * (0.5f / SizeY * Offset);
				const FTexel& Texel = In.At(GetClampedTexel(U, In.Width), GetClampedTexel(V, In.Height));
				for (int Channel = 0; Channel < 4; ++Channel)
				{
					Sum[Channel] += Tap.Weight * static_cast<float>(Texel[Channel]);
				}
			}
			// HLSL's compiler divides by a constant as it multiplies by its reciprocal.
			const float Scale = 1.0f / WeightSum;
			return FTexel{Sum[0] * Scale, Sum[1] * Scale, Sum[2] * Scale, Sum[3] * Scale};
		});
}

FImage RunArticle(FImage Image, int PassNum, float Offset)
{
	int Width = Image.Width, Height = Image.Height;
	for (int Pass = 0; Pass < PassNum; ++Pass)
	{
		Image =
			RunArticlePass(Image, Width, Height, Offset, {{0, 0, 4}, {-1, -1, 1}, {1, 1, 1}, {1, -1, 1}, {-1, 1, 1}});
		Width = Width / 2;
		Height = Height / 2;
	}
	for (int Pass = 0; Pass < PassNum; ++Pass)
	{
		Width = Width * 2;
		Height = Height * 2;
		Image = RunArticlePass(Image, Width, Height, Offset,
			{{-2, 0, 1}, {2, 0, 1}, {0, -2, 1}, {0, 2, 1}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}, {-1, -1, 2}});
	}
	return Image;
}

} // namespace

TEST(DualKawaseAsPrinted, IsTheArticlesLoopBitForBitAtEvenAndOddSizes)
{
	for (const auto& [Width, Height] : {std::pair(32, 24), {43, 11}, {7, 5}, {64, 2}, {65, 37}})
	{
		const FImage Image = FImage::Noise(Width, Height, 8.0, 7);
		for (const int PassNum : {1, 2, 3})
		{
			if (std::min(Width, Height) >> (PassNum - 1) < 2)
			{
				continue; // the article's texture would be of no size
			}
			for (const float Offset : {0.0f, 0.9f, 1.0f, 2.25f})
			{
				EXPECT_EQ(RunArticle(Image, PassNum, Offset).Texels, Blur(Image, PassNum, Offset).Texels)
					<< Width << "x" << Height << ", " << PassNum << " passes, offset " << Offset;
			}
		}
	}
}

TEST(DualKawaseAsPrinted, BordersAreClampedNotWrapped)
{
	// White below a black picture: nothing of it reaches the top.
	FImage Image(16, 16, {0, 0, 0, 1});
	for (int X = 0; X < 16; ++X)
	{
		Image.At(X, 15) = {1, 1, 1, 1};
	}
	const FImage Result = Blur(Image, 1);
	EXPECT_EQ(0.0, Result.At(8, 0)[0]);
	EXPECT_EQ(1.0, Blur(FImage(16, 16, {1, 1, 1, 1}), 1).At(0, 15)[0]);
	EXPECT_GT(Result.At(8, 15)[0], 0.9);
}

TEST(DualKawaseAsPrinted, NoPassReturnsTheInput)
{
	FPassRun Run(FImage::Noise(16, 16), EArithmetic::Native);
	EXPECT_EQ(Run.Input, AddPass(Run, 0));
	EXPECT_TRUE(Drydock::GetGraphNotes(Run.GraphBuilder).empty());
	Run.Execute(Run.Input);
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

TEST(DualKawaseAsPrinted, TheViewRectIsIgnoredAndBlackLiesAroundIt)
{
	FImage Black(32, 32, {0, 0, 0, 0});
	for (int Y = 8; Y < 24; ++Y)
	{
		for (int X = 8; X < 24; ++X)
		{
			Black.At(X, Y) = {1, 1, 1, 1};
		}
	}
	FImage Expected;
	{
		FPassRun Whole(Black, EArithmetic::Native);
		Expected = Whole.Execute(AddPass(Whole, 1));
	}
	// This input is NaN around the rect of 16x16.
	FPassRun Run(FImage(16, 16, {1, 1, 1, 1}), {8, 8, 24, 24}, FIntPoint(32, 32), EArithmetic::Native);
	const FScreenPassTexture Output = AddPass(Run, 1);
	EXPECT_EQ(FIntRect(0, 0, 32, 32), Output.ViewRect);
	EXPECT_EQ(Expected.Texels, Run.Execute(Output).Texels);
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
