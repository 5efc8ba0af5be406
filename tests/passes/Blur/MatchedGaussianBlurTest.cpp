// The Gaussian that the dual Kawase blur is compared with.
#include "PassTestUtils.h"

#include "DualKawaseBlurReference.h"

#include "Blur/DualKawaseBlurWidth.h"
#include "Blur/MatchedGaussianBlur.h"
#include "RenderGraphNotes.h"

using namespace Drydock;

using namespace PassTest;
using PassReference::MaxDifference;

namespace
{

FScreenPassTexture AddPass(FPassRun& Run, double StandardDeviation, bool bSeparable = false)
{
	FMatchedGaussianBlurInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.StandardDeviation = StandardDeviation;
	Inputs.bSeparable = bSeparable;
	return AddMatchedGaussianBlurPasses(Run.GraphBuilder, Run.View, Inputs);
}

FImage Blur(
	const FImage& Image, double StandardDeviation, bool bSeparable, EArithmetic Arithmetic = EArithmetic::Float32)
{
	FPassRun Run(Image, Arithmetic);
	return Run.Execute(AddPass(Run, StandardDeviation, bSeparable));
}

/** exp(-x^2 / 2 s^2) on the texels of the reach, as a product of a row and a column, clamped to the image. */
FImage Expected(const FImage& Image, double Sigma, int Reach)
{
	const auto Weigh = [&](int Distance)
	{
		return std::exp(-Distance * Distance / (2 * Sigma * Sigma));
	};
	return FImage::Make(Image.Width, Image.Height,
		[&](int X, int Y)
		{
			FTexel Color{0, 0, 0, 0};
			double Sum = 0;
			for (int DY = -Reach; DY <= Reach; ++DY)
			{
				for (int DX = -Reach; DX <= Reach; ++DX)
				{
					const double Weight = Weigh(DX) * Weigh(DY);
					Color = Color +
							Image.At(std::clamp(X + DX, 0, Image.Width - 1), std::clamp(Y + DY, 0, Image.Height - 1)) *
								Weight;
					Sum += Weight;
				}
			}
			return Color * (1 / Sum);
		});
}

} // namespace

TEST(MatchedGaussianBlur, IsAGaussianWiderByWhatItsTailsLack)
{
	// Weights at distances 0 and 1 differ by exp(-1 / 2 s^2), which gives the s that was used.
	const TArray<double> Weights = Drydock::ComputeMatchedGaussian(2.0);
	const double Sigma = std::sqrt(0.5 / std::log(Weights[0] / Weights[1]));
	EXPECT_NEAR(2.0, Sigma, 0.06);
	EXPECT_GT(Sigma, 2.0);
	const FImage Image = FImage::Noise(29, 17);
	for (const bool bSeparable : {false, true})
	{
		EXPECT_LE(MaxDifference(Expected(Image, Sigma, 6), Blur(Image, 2.0, bSeparable), 4), 2e-6) << bSeparable;
	}
}

TEST(MatchedGaussianBlur, MeasuredWidthIsThatOfTheDualKawaseBlur)
{
	const double Kawase = Drydock::GetDualKawaseStandardDeviation(2, 1.0);
	for (const bool bSeparable : {false, true})
	{
		const DualKawaseReference::FMoments Moments = DualKawaseReference::GetMoments(
			Blur(DualKawaseReference::Impulse(51, 49, 25, 24), Kawase, bSeparable), 25, 24);
		EXPECT_NEAR(1, Moments.Sum, 1e-5);
		EXPECT_NEAR(Kawase, std::sqrt(Moments.XX / Moments.Sum), 1e-5);
		EXPECT_NEAR(Kawase, std::sqrt(Moments.YY / Moments.Sum), 1e-5);
	}
}

TEST(MatchedGaussianBlur, ConstantStaysConstantToTheEdgeOfAnOffsetRect)
{
	const FImage Constant(19, 13, {0.75, 0.5, 3, 1});
	for (const bool bSeparable : {false, true})
	{
		FPassRun Run(Constant, {3, 2, 22, 15}, FIntPoint(32, 24), EArithmetic::Native);
		EXPECT_EQ(Constant.Texels, Run.Execute(AddPass(Run, 3.0, bSeparable)).Texels);
	}
}

TEST(MatchedGaussianBlur, OffsetRectGivesTheBitsOfTheCroppedImage)
{
	const FImage Image = FImage::Noise(23, 17);
	for (const bool bSeparable : {false, true})
	{
		const FImage Cropped = Blur(Image, 1.7, bSeparable, EArithmetic::Native);
		FPassRun Run(Image, {5, 9, 28, 26}, FIntPoint(40, 33), EArithmetic::Native);
		EXPECT_EQ(Cropped.Texels, Run.Execute(AddPass(Run, 1.7, bSeparable)).Texels);
	}
}

TEST(MatchedGaussianBlur, OnePixelStaysAsItIs)
{
	const FImage Pixel(1, 1, {0.5, 0.25, 0.125, 1});
	EXPECT_EQ(Pixel.Texels, Blur(Pixel, 5.0, false, EArithmetic::Native).Texels);
}

TEST(MatchedGaussianBlur, ManyTapsAreRemarkedOn)
{
	// Reach 3 * 12 = 36: 73^2 taps, or 2 * 73.
	FPassRun Run(FImage::Noise(4, 4), EArithmetic::Native);
	const FScreenPassTexture Output = AddPass(Run, 12.0);
	const std::vector<Drydock::FDiagnostic> Notes = Drydock::GetGraphNotes(Run.GraphBuilder);
	ASSERT_EQ(1u, Notes.size());
	EXPECT_EQ(
		"the direct Gaussian takes 5329 taps per pixel, which may be minutes; r.DualKawase.SeparableGaussian 1 takes "
		"146",
		Notes[0].Message);
	Run.Execute(Output);
}

TEST(MatchedGaussianBlur, FewTapsAreNot)
{
	FPassRun Run(FImage::Noise(4, 4), EArithmetic::Native);
	AddPass(Run, 12.0, true);
	const FScreenPassTexture Output = AddPass(Run, 11.0);
	EXPECT_TRUE(Drydock::GetGraphNotes(Run.GraphBuilder).empty());
	Run.Execute(Output);
}

TEST(MatchedGaussianBlur, OverrideOutputIsWritten)
{
	const FImage Expected = Blur(FImage::Noise(16, 12), 1.5, false, EArithmetic::Native);
	FPassRun Run(FImage::Noise(16, 12), EArithmetic::Native);
	FMatchedGaussianBlurInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.StandardDeviation = 1.5;
	Inputs.OverrideOutput = FScreenPassRenderTarget::CreateFromInput(
		Run.GraphBuilder, Run.Input, ERenderTargetLoadAction::ENoAction, TEXT("Override"));
	const FScreenPassTexture Output = AddMatchedGaussianBlurPasses(Run.GraphBuilder, Run.View, Inputs);
	EXPECT_EQ(Inputs.OverrideOutput.Texture, Output.Texture);
	EXPECT_EQ(Expected.Texels, Run.Execute(Output).Texels);
}
