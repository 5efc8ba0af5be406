// The blur of the RED post process: the readings of the article's kernel, by weight and on points of light.
#include "REDPostProcessTestUtils.h"

using namespace Drydock;

using namespace PassTest;
using PassReference::MaxDifference;
using PassReference::SumOf;

namespace
{

constexpr double PrintedWeights[] = {0.0044, 0.0540, 0.2420, 0.3990, 0.2420, 0.0540, 0.0044};

/** A reading of the article's kernel: weights by texel, from the middle outwards, and what header and docs say of it.
 */
struct FKernelFacts
{
	EREDBlurKernel Kernel;
	std::vector<double> Texels;
	double Gain;
	double Deviation;
};

std::vector<FKernelFacts> ListKernels()
{
	// Of the thirteen texels two share each weight but the middle one's.
	const double A = 0.2420 / 2, B = 0.0540 / 2, C = 0.0044 / 2;
	return {{EREDBlurKernel::SevenTaps, {0.3990, 0.2420, 0.0540, 0.0044}, 0.9998, 0.9977},
		{EREDBlurKernel::ThirteenTexels, {0.3990, A, A, B, B, C, C}, 0.9998, 1.6820},
		{EREDBlurKernel::NineTaps, {0.3990, 0.2420, 0.0540, 0.0044, 0.0001}, 1.0000, 0.9992},
		{EREDBlurKernel::Printed, {0.0044, 0.0540, 0.2420, 0.3990, 0.2420, 0.0540, 0.0044}, 1.9952, 3.1650}};
}

FREDPostProcessParameters MakeParameters(EREDBlurKernel Kernel)
{
	FREDPostProcessParameters Parameters;
	Parameters.bAsPrinted = Kernel == EREDBlurKernel::Printed;
	Parameters.Kernel = Parameters.bAsPrinted ? EREDBlurKernel::SevenTaps : Kernel;
	return Parameters;
}

/** Sum and standard deviation of weights at whole distances from the middle, both sides. */
std::pair<double, double> MeasureWeights(const std::vector<double>& Weights)
{
	double Sum = 0, SecondMoment = 0;
	for (int Texel = 0; Texel < static_cast<int>(Weights.size()); ++Texel)
	{
		const double Both = Weights[static_cast<size_t>(Texel)] * (Texel > 0 ? 2 : 1);
		Sum += Both;
		SecondMoment += Both * Texel * Texel;
	}
	return {Sum, std::sqrt(SecondMoment / Sum)};
}

} // namespace

TEST(REDPostProcess, CorrectedBlurHasSevenTapsAndKeepsTheLight)
{
	FImage Image(1, 21, {0, 0, 0, 0});
	Image.At(0, 10) = {1, 1, 1, 1};
	const FImage Result = RunPass(Image, EREDPostProcessPass::BlurV);
	for (int Tap = -3; Tap <= 3; ++Tap)
	{
		EXPECT_NEAR(PrintedWeights[Tap + 3] / 0.9998, Result.At(0, 10 + Tap)[0], 1e-7) << Tap;
	}
	EXPECT_NEAR(1, SumOf(Result, 0), 1e-6);
}

TEST(REDPostProcess, PrintedBlurDoublesTheLightInTwoLobes)
{
	FImage Image(21, 1, {0, 0, 0, 0});
	Image.At(10, 0) = {1, 1, 1, 1};
	FREDPostProcessParameters Parameters;
	Parameters.bAsPrinted = true;
	const FImage Result = RunPass(Image, EREDPostProcessPass::BlurH, Parameters);
	for (int Tap = -6; Tap <= 6; ++Tap)
	{
		EXPECT_NEAR(PrintedWeights[std::abs(Tap)], Result.At(10 + Tap, 0)[0], 1e-7) << Tap;
	}
	EXPECT_NEAR(1.9952, SumOf(Result, 0), 1e-6); // 0.0044 + 2 * (0.9998 - 0.0044)
}

TEST(REDPostProcess, BlurWeightsByTexel)
{
	for (const FKernelFacts& Facts : ListKernels())
	{
		const double Sum = Facts.Kernel == EREDBlurKernel::Printed ? 1 : Facts.Gain;
		const int32 Reach = static_cast<int32>(Facts.Texels.size()) - 1;
		EXPECT_EQ(Reach, GetREDBlurReach(Facts.Kernel)) << ToString(Facts.Kernel);
		for (int32 Texel = -10; Texel <= 10; ++Texel)
		{
			const double Expected = std::abs(Texel) <= Reach ? Facts.Texels[static_cast<size_t>(std::abs(Texel))] : 0.0;
			EXPECT_NEAR(Expected / Sum, GetREDBlurWeight(Texel, Facts.Kernel), 1e-7)
				<< ToString(Facts.Kernel) << " " << Texel;
		}
	}
}

TEST(REDPostProcess, KernelsHaveTheStatedGainAndWidth)
{
	for (const FKernelFacts& Facts : ListKernels())
	{
		SCOPED_TRACE(ToString(Facts.Kernel));
		const auto [Gain, Deviation] = MeasureWeights(Facts.Texels);
		EXPECT_NEAR(Facts.Gain, Gain, 5e-5);
		EXPECT_NEAR(Facts.Deviation, Deviation, 5e-5);

		// The same of what the pass makes of a point of light.
		FImage Point(31, 1, {0, 0, 0, 0});
		Point.At(15, 0) = {1, 1, 1, 1};
		const FImage Result = RunPass(Point, EREDPostProcessPass::BlurH, MakeParameters(Facts.Kernel));
		double SecondMoment = 0;
		for (int X = 0; X < 31; ++X)
		{
			SecondMoment += Result.At(X, 0)[0] * (X - 15) * (X - 15);
			const size_t Texel = static_cast<size_t>(std::abs(X - 15));
			const double Weight = Texel < Facts.Texels.size() ? Facts.Texels[Texel] : 0.0;
			EXPECT_NEAR(Facts.Kernel == EREDBlurKernel::Printed ? Weight : Weight / Gain, Result.At(X, 0)[0], 1e-7)
				<< X;
		}
		EXPECT_NEAR(Facts.Kernel == EREDBlurKernel::Printed ? Facts.Gain : 1.0, SumOf(Result, 0), 1e-6);
		EXPECT_NEAR(Facts.Deviation, std::sqrt(SecondMoment / SumOf(Result, 0)), 5e-5);
	}
}

TEST(REDPostProcess, KernelIsChosenByConsoleVariable)
{
	const auto Choose = [](int32 Value)
	{
		const FScopedConsoleVariable Kernel(TEXT("r.RED.Kernel"), static_cast<float>(Value));
		return FREDPostProcessParameters::FromSettings(FFinalPostProcessSettings()).GetKernel();
	};
	EXPECT_EQ(EREDBlurKernel::SevenTaps, FREDPostProcessParameters::FromSettings({}).GetKernel());
	EXPECT_EQ(EREDBlurKernel::ThirteenTexels, Choose(1));
	EXPECT_EQ(EREDBlurKernel::NineTaps, Choose(2));
	EXPECT_EQ(EREDBlurKernel::NineTaps, Choose(3)); // the printed one has a variable of its own, which wins
	const FScopedConsoleVariable AsPrinted(TEXT("r.RED.AsPrinted"), 1);
	EXPECT_EQ(EREDBlurKernel::Printed, Choose(1));
}

TEST(REDPostProcess, BlurStepWidensTheKernel)
{
	FImage Point(31, 1, {0, 0, 0, 0});
	Point.At(15, 0) = {1, 1, 1, 1};
	FPassRun Run(Point, EArithmetic::Double, PF_A32B32G32R32F);
	FREDPostProcessPassInputs Inputs;
	Inputs.Pass = EREDPostProcessPass::BlurH;
	Inputs.SceneColor = Run.Input;
	Inputs.BlurStep = 2.0f;
	const FImage Result = Run.Execute(AddREDPostProcessPass(Run.GraphBuilder, Run.View, Inputs));
	for (int Tap = -3; Tap <= 3; ++Tap)
	{
		EXPECT_NEAR(PrintedWeights[Tap + 3] / 0.9998, Result.At(15 + 2 * Tap, 0)[0], 1e-7) << Tap;
		EXPECT_EQ(0, Result.At(16 + 2 * Tap, 0)[0]) << Tap;
	}
}

TEST(REDPostProcess, BlurHIsBlurVTransposed)
{
	const FImage Image = FImage::Noise(9, 9);
	const auto Transpose = [](const FImage& Source)
	{
		return FImage::Make(Source.Height, Source.Width, [&](int X, int Y) { return Source.At(Y, X); });
	};
	EXPECT_EQ(Transpose(RunPass(Image, EREDPostProcessPass::BlurV)).Texels,
		RunPass(Transpose(Image), EREDPostProcessPass::BlurH).Texels);
}

TEST(REDPostProcess, ConstantStaysConstantToTheEdge)
{
	for (const EREDBlurKernel Kernel :
		{EREDBlurKernel::SevenTaps, EREDBlurKernel::ThirteenTexels, EREDBlurKernel::NineTaps})
	{
		for (const auto& [Width, Height] : {std::pair(1, 1), {1, 9}, {8, 5}})
		{
			const FImage Image(Width, Height, {0.75, 0.5, 3, 1});
			const FREDPostProcessParameters Parameters = MakeParameters(Kernel);
			EXPECT_LE(MaxDifference(Image, RunPass(Image, EREDPostProcessPass::BlurH, Parameters), 4), 1e-6);
			EXPECT_LE(MaxDifference(Image, RunPass(Image, EREDPostProcessPass::BlurV, Parameters), 4), 1e-6);
		}
	}
}
