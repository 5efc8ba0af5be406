// The engine's passes by name: what a config's parameters make of them.
#include "FactoryTestUtils.h"

using namespace PassTest;

TEST(PassFactories, DownsampleHalves)
{
	const FImage Result = RunFactory("Downsample", FImage(9, 6, {0.5, 0.25, 1, 1}), {{"Quality", std::string("Low")}});
	EXPECT_EQ(FImage(5, 3, {0.5, 0.25, 1, 1}).Texels, Result.Texels);
}

TEST(PassFactories, GaussianBlurTints)
{
	const FImage Result = RunFactory("GaussianBlur", FImage(16, 8, {1, 1, 1, 1}),
		{{"KernelSizePercent", 0.0}, {"Tint", FLinearColor(0.5f, 0.25f, 0, 1)}});
	EXPECT_EQ((FTexel{0.5, 0.25, 0, 1}), Result.At(8, 4)); // a kernel of no size copies
}

TEST(PassFactories, BloomSetupTakesItsThreshold)
{
	// Luminance 1 at threshold 0: half way up the ramp, which is two wide.
	EXPECT_NEAR(0.5, RunFactory("BloomSetup", FImage(4, 4, {1, 1, 1, 1}), {{"Threshold", 0.0}}).At(1, 1)[0], 1e-6);
}

TEST(PassFactories, EveryPassHasADocAndItsParametersToo)
{
	for (const Drydock::FPassFactory* Factory : Drydock::GetPassFactories())
	{
		EXPECT_FALSE(Factory->Doc.empty()) << Factory->Type;
		for (const Drydock::FParameterSpec& Parameter : Factory->Parameters)
		{
			EXPECT_FALSE(Parameter.Doc.empty()) << Factory->Type << " " << Parameter.Name;
		}
	}
}
