// The blur kernel against the golden numbers of the engine and against its definition.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "PassTestUtils.h"

#include "Blur/PostProcessWeightedSampleSum.h"

using namespace Drydock;
using namespace PassTest;

namespace
{

struct FGoldenTap
{
	double Offset, Weight;
};

/** Taps printed to five digits, weights to six. */
void ExpectTaps(const std::vector<FGoldenTap>& Expected, float Radius)
{
	const TArray<FGaussianTap> Taps = ComputeGaussianKernel(32, Radius);
	ASSERT_EQ(static_cast<int>(Expected.size()), Taps.Num()) << "radius " << Radius;
	for (int Index = 0; Index < Taps.Num(); ++Index)
	{
		EXPECT_NEAR(Expected[Index].Offset, Taps[Index].Offset, 0.6e-5) << "radius " << Radius << " tap " << Index;
		EXPECT_NEAR(Expected[Index].Weight, Taps[Index].Weight, 0.6e-6) << "radius " << Radius << " tap " << Index;
	}
}

double SumWeights(const TArray<FGaussianTap>& Taps)
{
	double Sum = 0;
	for (const FGaussianTap& Tap : Taps)
	{
		Sum += Tap.Weight;
	}
	return Sum;
}

} // namespace

TEST(GaussianKernel, RadiusFourMatchesTheEngine)
{
	ExpectTaps({{-3.00067, 0.000048}, {-1.04184, 0.211798}, {0.26043, 0.779246}, {2.00538, 0.008909}, {4, 0}}, 4.0f);
}

TEST(GaussianKernel, FinestBloomStageMatchesTheEngine)
{
	ExpectTaps({{-5.00392, 0.000001}, {-3.02865, 0.004442}, {-1.18093, 0.295418}, {0.37675, 0.642245},
				   {2.07469, 0.057765}, {4.01066, 0.000129}, {6, 0}},
		5.76f);
}

TEST(GaussianKernel, SecondBloomStageMatchesTheEngine)
{
	ExpectTaps({{-9.03098, 0}, {-7.06191, 0.000036}, {-5.11991, 0.002941}, {-3.21952, 0.060239}, {-1.36735, 0.3167},
				   {0.45482, 0.440528}, {2.28781, 0.163354}, {4.16371, 0.015813}, {6.08661, 0.000386},
				   {8.04392, 0.000002}, {10, 0}},
		9.6f);
}

TEST(GaussianKernel, ReachOfTheDefaultStages)
{
	// Widths of the levels of 1920x1080, sizes 64, 30, 10, 2, 1, 0.3 percent times 4: coarse to fine.
	const struct
	{
		uint32 Width;
		float Percent;
		float Radius;
		int32 Taps;
	} Stages[] = {{30, 256, 38.4f, 32}, {60, 120, 36.0f, 32}, {120, 40, 24.0f, 25}, {240, 8, 9.6f, 11},
		{480, 4, 9.6f, 11}, {960, 1.2f, 5.76f, 7}};
	for (const auto& Stage : Stages)
	{
		const float Radius = GetBlurRadius(Stage.Width, Stage.Percent);
		EXPECT_NEAR(Stage.Radius, Radius, 1e-4);
		EXPECT_EQ(Stage.Taps, ComputeGaussianKernel(32, Radius).Num());
	}
}

TEST(GaussianKernel, ReachOfTheDefaultStagesAt720p)
{
	const struct
	{
		uint32 Width;
		float Percent;
		float Radius;
	} Stages[] = {
		{20, 256, 25.6f}, {40, 120, 24.0f}, {80, 40, 16.0f}, {160, 8, 6.4f}, {320, 4, 6.4f}, {640, 1.2f, 3.84f}};
	for (const auto& Stage : Stages)
	{
		EXPECT_NEAR(Stage.Radius, GetBlurRadius(Stage.Width, Stage.Percent), 1e-4);
	}
}

TEST(GaussianKernel, TinyRadiusIsOneTapAtTheCentre)
{
	for (const float Radius : {0.0f, -3.0f, 1e-6f, 0.05f, 0.3f, 0.39f})
	{
		double Centre = 0;
		for (const FGaussianTap& Tap : ComputeGaussianKernel(32, Radius))
		{
			EXPECT_FALSE(std::isnan(Tap.Offset)) << Radius;
			Centre += std::abs(Tap.Offset) < 1e-9 ? Tap.Weight : 0;
		}
		EXPECT_NEAR(1.0, Centre, 1e-12) << Radius;
	}
}

TEST(GaussianKernel, SharpestCrossIsAnImpulse)
{
	for (const FGaussianTap& Tap : ComputeGaussianKernel(32, 20.0f, 4.0f))
	{
		EXPECT_EQ(Tap.Offset == 0 ? 1.0 : 0.0, Tap.Weight);
		EXPECT_TRUE(std::isfinite(Tap.Offset));
	}
}

TEST(GaussianKernel, HalfCrossBlendsWithTheTriangle)
{
	// Texel weights of radius 2 before normalising: 1, and half of exp(-16.7 / 4) and exp(-16.7) on either side.
	const double One = 0.5 * std::exp(-16.7 / 4), Two = 0.5 * std::exp(-16.7);
	const TArray<FGaussianTap> Taps = ComputeGaussianKernel(32, 2.0f, 0.5f);
	ASSERT_EQ(3, Taps.Num());
	const double Sum = 1 + 2 * One + 2 * Two;
	EXPECT_NEAR((Two + One) / Sum, Taps[0].Weight, 1e-12);
	EXPECT_NEAR((1 + One) / Sum, Taps[1].Weight, 1e-12);
	EXPECT_NEAR(One / (1 + One), Taps[1].Offset, 1e-12);
}

TEST(GaussianKernel, SizeScaleCutsTheReachNotTheWidth)
{
	const FScopedConsoleVariable SizeScale(TEXT("r.Filter.SizeScale"), 0.5f);
	EXPECT_EQ(5, GetIntegerKernelRadius(32, 10.0f));
	EXPECT_FLOAT_EQ(10.0f, GetClampedKernelRadius(32, 10.0f));
}

TEST(GaussianKernel, LoopModeAllowsWideKernels)
{
	EXPECT_EQ(32, GetFilterSampleCountMax());
	const FScopedConsoleVariable LoopMode(TEXT("r.Filter.LoopMode"), 1);
	EXPECT_EQ(128, GetFilterSampleCountMax());
	EXPECT_EQ(78, ComputeGaussianKernel(GetFilterSampleCountMax(), 76.8f).Num());
}

TEST(GaussianKernel, HugeAndInfiniteRadiiClampToTheLargest)
{
	EXPECT_EQ(32, ComputeGaussianKernel(32, 1e30f).Num());
	EXPECT_EQ(32, ComputeGaussianKernel(32, std::numeric_limits<float>::infinity()).Num());
}

TEST(GaussianKernel, NaNRadiusHasNoTaps)
{
	EXPECT_EQ(0, ComputeGaussianKernel(32, std::numeric_limits<float>::quiet_NaN()).Num());
}

TEST(GaussianKernel, FastBlurStartsAtItsThreshold)
{
	EXPECT_FALSE(IsFastBlurEnabled(6.99f));
	EXPECT_TRUE(IsFastBlurEnabled(7.0f));
	const FScopedConsoleVariable Threshold(TEXT("r.FastBlurThreshold"), 0);
	EXPECT_TRUE(IsFastBlurEnabled(0.0f));
}

RC_GTEST_PROP(GaussianKernel, WeightsSumToOneAndTheMeanIsTheCentre, ())
{
	const float Radius = *rc::gen::inRange(1, 40000) * 0.001f;
	const TArray<FGaussianTap> Taps = ComputeGaussianKernel(32, Radius);
	double Mean = 0;
	for (const FGaussianTap& Tap : Taps)
	{
		Mean += Tap.Offset * Tap.Weight;
	}
	RC_ASSERT(std::abs(SumWeights(Taps) - 1) < 1e-12);
	RC_ASSERT(std::abs(Mean) < 1e-10);
}

RC_GTEST_PROP(GaussianKernel, PairsStandForTheirTexels, ())
{
	const float Radius = *rc::gen::inRange(1000, 30000) * 0.001f;
	const int Reach = static_cast<int>(std::ceil(Radius));
	const std::vector<double> Texels = PassReference::GaussianWeights(Radius, Reach);
	const TArray<FGaussianTap> Taps = ComputeGaussianKernel(32, Radius);
	RC_ASSERT(Taps.Num() == Reach + 1);
	for (int Index = 0; Index <= Reach; ++Index)
	{
		const double First = Texels[2 * Index];
		const double Second = Index < Reach ? Texels[2 * Index + 1] : 0;
		// The bilinear weights of the tap.
		const double Fraction = Taps[Index].Offset - (2 * Index - Reach);
		RC_ASSERT(std::abs(Taps[Index].Weight * (1 - Fraction) - First) < 1e-12);
		RC_ASSERT(std::abs(Taps[Index].Weight * Fraction - Second) < 1e-12);
	}
}
