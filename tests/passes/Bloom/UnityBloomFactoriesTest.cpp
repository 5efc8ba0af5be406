// The passes of the Unity-style bloom by name: what a config's parameters make of them.
#include "FactoryTestUtils.h"

using namespace PassTest;

TEST(UnityBloomFactories, ExtractTakesItsThreshold)
{
	const FImage Image(2, 2, {0.5, 0.5, 0.5, 1});
	EXPECT_NEAR(0.125, RunFactory("UnityBloomExtract", Image, {{"Threshold", 0.25}}).At(0, 0)[0], 1e-6);
}

TEST(UnityBloomFactories, ExtractTakesItsSoftKnee)
{
	// At the threshold the parabola is a quarter of the knee, which is the threshold.
	const FImage Image(2, 2, {0.5, 0.5, 0.5, 1});
	EXPECT_NEAR(
		0.5 * 0.125, RunFactory("UnityBloomExtract", Image, {{"Threshold", 0.5}, {"SoftKnee", 1.0}}).At(0, 0)[0], 1e-5);
}

TEST(UnityBloomFactories, BlursTakeTheirSpread)
{
	FImage Image(9, 9, {0, 0, 0, 0});
	Image.At(4, 4) = {1, 1, 1, 1};
	EXPECT_NEAR(0.2442, RunFactory("UnityBloomGaussianBlurVertical", Image).At(4, 5)[0], 1e-6);
	EXPECT_NEAR(0.2442, RunFactory("UnityBloomGaussianBlurHorizontal", Image, {{"Spread", 2.0}}).At(6, 4)[0], 1e-6);
}

TEST(UnityBloomFactories, CompositeTakesItsIntensity)
{
	const FImage Image(2, 2, {0.5, 0.5, 0.5, 1});
	EXPECT_NEAR(0.75, RunFactory("UnityBloomComposite", Image, {{"Intensity", 0.5}}, "Bloom").At(0, 0)[0], 1e-6);
}
