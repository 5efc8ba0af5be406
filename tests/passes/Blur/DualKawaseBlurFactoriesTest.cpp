// The dual Kawase blur and its Gaussian by name: what a config's parameters make of them.
#include "FactoryTestUtils.h"

using namespace PassTest;

TEST(DualKawaseBlurFactories, ConstantsStayAndSizesToo)
{
	const FImage Image(33, 17, {0.5, 0.25, 1, 1});
	EXPECT_LE(PassReference::MaxDifference(Image, RunFactory("DualKawase", Image), 4), 1e-6);
	EXPECT_LE(PassReference::MaxDifference(Image, RunFactory("MatchedGaussian", Image), 4), 1e-6);
}

TEST(DualKawaseBlurFactories, MoreLevelsSpreadFurther)
{
	FImage Image(65, 65, {0, 0, 0, 0});
	Image.At(32, 32) = {64, 64, 64, 64};
	EXPECT_LT(RunFactory("DualKawase", Image, {{"PassNum", 3.0}}).At(32, 32)[0],
		RunFactory("DualKawase", Image, {{"PassNum", 1.0}}).At(32, 32)[0]);
	EXPECT_LT(RunFactory("MatchedGaussian", Image, {{"StandardDeviation", 8.0}}).At(32, 32)[0],
		RunFactory("MatchedGaussian", Image, {{"StandardDeviation", 2.0}}).At(32, 32)[0]);
}
