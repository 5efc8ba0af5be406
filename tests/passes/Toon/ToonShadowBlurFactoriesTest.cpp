// The passes of the toon-shadow blur by name: what a config's parameters make of them.
#include "FactoryTestUtils.h"

using namespace PassTest;

namespace
{

/** Lit in one texel of a field. */
FImage Spot(int Size)
{
	FImage Image(Size, Size, {0, 0, 0, 1});
	Image.At(Size / 2, Size / 2) = {64, 64, 64, 1};
	return Image;
}

} // namespace

TEST(ToonShadowBlurFactories, SetupTakesTheDarkerOfTheTwo)
{
	EXPECT_NEAR(0.25, RunFactory("ToonShadowSetup", FImage(2, 2, {0.75, 0.25, 1, 1})).At(0, 0)[0], 1e-6);
	EXPECT_NEAR(0.25, RunFactory("ToonShadowSetup", FImage(2, 2, {0.25, 0.75, 1, 1})).At(0, 0)[0], 1e-6);
}

TEST(ToonShadowBlurFactories, TextureBlurHalvesTheSizeAndKeepsAConstant)
{
	const FImage Result = RunFactory("TextureBlur", FImage(33, 17, {0.5, 0.25, 1, 1}));
	EXPECT_EQ(17, Result.Width);
	EXPECT_EQ(9, Result.Height);
	EXPECT_LE(PassReference::MaxDifference(FImage(17, 9, {0.5, 0.25, 1, 1}), Result, 4), 1e-6);
}

TEST(ToonShadowBlurFactories, TextureBlurTakesItsSizes)
{
	const auto Peak = [](double Scale)
	{
		return RunFactory("TextureBlur", Spot(64), {{"SizeScale", Scale}}).At(16, 16)[0];
	};
	EXPECT_GT(Peak(1), Peak(16));
}

TEST(ToonShadowBlurFactories, TextureBlurTakesItsTints)
{
	// Only the last stage runs, with a tint of 1/2 that is not normalised.
	std::map<std::string, Drydock::FParameterValue> Values = {
		{"Normalize", false}, {"Tint1", FLinearColor(0.5f, 0.25f, 1.0f, 1.0f)}};
	for (const char* Size : {"Size2", "Size3", "Size4", "Size5", "Size6"})
	{
		Values[Size] = 0.0;
	}
	const FImage Result = RunFactory("TextureBlur", FImage(32, 32, {1, 1, 1, 1}), Values);
	EXPECT_LE(PassReference::MaxDifference(FImage(16, 16, {0.5, 0.25, 1, 1}), Result, 4), 1e-6);
}

TEST(ToonShadowBlurFactories, TextureBlurWithoutAnyStageGivesItsInput)
{
	std::map<std::string, Drydock::FParameterValue> Values;
	for (const char* Size : {"Size1", "Size2", "Size3", "Size4", "Size5", "Size6"})
	{
		Values[Size] = 0.0;
	}
	EXPECT_LE(PassReference::MaxDifference(Spot(8), RunFactory("TextureBlur", Spot(8), Values), 4), 0.0);
}

TEST(ToonShadowBlurFactories, CombineKeepsTheShadowsAndTakesItsStore)
{
	const FImage Shadow(4, 4, {0.25, 0.5, 0, 0});
	const FImage Root = RunFactory("ToonShadowCombine", Shadow, {}, "Blurred");
	EXPECT_LE(PassReference::MaxDifference(FImage(4, 4, {0.25, 0.5, 0, 0.5}), Root, 4), 1e-6);
	const FImage Linear = RunFactory("ToonShadowCombine", Shadow, {{"Store", std::string("SixteenBit")}}, "Blurred");
	EXPECT_NEAR(0.25, Linear.At(0, 0)[3], 1e-6);
}

TEST(ToonShadowBlurFactories, LightingLeavesWhatIsNotToon)
{
	// There is no G-buffer here, so nothing is toon; tests/pipeline/ArticleEffectsRunTest.cpp has one.
	const FImage Picture(4, 4, {0.5, 2, 0, 1});
	EXPECT_LE(PassReference::MaxDifference(Picture, RunFactory("ToonShadowLighting", Picture, {}, "Shadow"), 4), 0.0);
}
