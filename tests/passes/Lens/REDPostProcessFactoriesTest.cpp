// The RED passes by name: what a config's parameters make of them.
#include "FactoryTestUtils.h"

using namespace PassTest;

TEST(REDPostProcessFactories, DownSampleHalves)
{
	EXPECT_EQ(3, RunFactory("REDDownSample", FImage(6, 4)).Width);
}

TEST(REDPostProcessFactories, BlurAsPrintedDoublesTheLight)
{
	FImage Image(21, 1, {0, 0, 0, 0});
	Image.At(10, 0) = {1, 1, 1, 1};
	EXPECT_NEAR(1, PassReference::SumOf(RunFactory("REDBlurH", Image), 0), 1e-6);
	EXPECT_NEAR(1.9952, PassReference::SumOf(RunFactory("REDBlurH", Image, {{"AsPrinted", true}}), 0), 1e-6);
}

TEST(REDPostProcessFactories, BlurTakesItsKernel)
{
	FImage Image(1, 21, {0, 0, 0, 0});
	Image.At(0, 10) = {1, 1, 1, 1};
	const auto Blur = [&](const char* Kernel)
	{
		return RunFactory("REDBlurV", Image, {{"Kernel", std::string(Kernel)}});
	};
	EXPECT_EQ(0, Blur("SevenTaps").At(0, 14)[0]);
	EXPECT_NEAR(0.0001, Blur("NineTaps").At(0, 14)[0], 1e-7);
	EXPECT_NEAR(0.0540 / 2 / 0.9998, Blur("ThirteenTexels").At(0, 14)[0], 1e-6);
}

TEST(REDPostProcessFactories, PrintedDiffusionFilter2TakesTheThreshold)
{
	const FImage Image(2, 2, {0.5, 0.5, 0.5, 1});
	const auto Combine = [&](double Threshold)
	{
		return RunFactory(
			"REDDiffusionFilter2", Image, {{"AsPrinted", true}, {"LuminanceThreshold", Threshold}}, "Blurred")
			.At(0, 0)[0];
	};
	EXPECT_NEAR(0.5625, Combine(0.25), 1e-6); // the blur weighs 0.5 - 0.25: 1 - 0.5 * (1 - 0.125)
	EXPECT_NEAR(0.5, Combine(1), 1e-6);
}

TEST(REDPostProcessFactories, DiffusionFilterTakesItsThreshold)
{
	const FImage Result =
		RunFactory("REDDiffusionFilter", FImage(2, 2, {0.5, 0.5, 0.5, 1}), {{"LuminanceThreshold", 0.25}});
	EXPECT_NEAR(0.125, Result.At(0, 0)[0], 1e-6); // 0.5 * (0.5 - 0.25)
}

TEST(REDPostProcessFactories, DiffusionFilter2TakesBlendAndIntensity)
{
	const FImage Image(2, 2, {0.5, 0.5, 0.5, 1});
	EXPECT_NEAR(0.75, RunFactory("REDDiffusionFilter2", Image, {}, "Blurred").At(0, 0)[0], 1e-6);
	EXPECT_NEAR(
		0.5, RunFactory("REDDiffusionFilter2", Image, {{"Blend", std::string("Max")}}, "Blurred").At(0, 0)[0], 1e-6);
	EXPECT_NEAR(0.625, RunFactory("REDDiffusionFilter2", Image, {{"Intensity", 0.5}}, "Blurred").At(0, 0)[0], 1e-6);
}

TEST(REDPostProcessFactories, SoftFocusTakesItsSaturation)
{
	const FImage Result = RunFactory("REDSoftFocus", FImage(2, 2, {1, 0, 0, 1}), {{"Saturation", 0.0}}, "Blurred");
	EXPECT_NEAR(0.299, Result.At(0, 0)[2], 1e-6); // the luma of red
}

TEST(REDPostProcessFactories, GlowTakesItsIntensity)
{
	EXPECT_NEAR(0.625,
		RunFactory("REDGlow", FImage(2, 2, {0.5, 0.5, 0.5, 1}), {{"Intensity", 0.5}}, "Blurred").At(0, 0)[0], 1e-6);
}

TEST(REDPostProcessFactories, PrintedLastNodesWriteAlphaOne)
{
	// From the article: OutColor = float4(Result, 1.0f) of DiffusionFilter2PS, SoftFocus and Glow.
	const FImage Image(2, 2, {0.5, 0.5, 0.5, 0.25});
	for (const char* Pass : {"REDDiffusionFilter2", "REDSoftFocus", "REDGlow"})
	{
		EXPECT_EQ(0.25, RunFactory(Pass, Image, {}, "Blurred").At(0, 0)[3]) << Pass;
		EXPECT_EQ(1.0, RunFactory(Pass, Image, {{"AsPrinted", true}}, "Blurred").At(0, 0)[3]) << Pass;
	}
}
