// Bloom that lands outside and inside the toon, by hand.
#include <gtest/gtest.h>

#include "Effects/ToonBleed.h"

using namespace Drydock;

namespace
{

constexpr double Toon = 8.0 / 255.0;
constexpr double Other = 4.0 / 255.0;

/** Grey. */
FImage MakeBloom(int Width, int Height, const std::vector<double>& Values)
{
	FImage Bloom{Width, Height, 3, {}};
	for (const double Value : Values)
	{
		Bloom.Values.insert(Bloom.Values.end(), {Value, Value, Value});
	}
	return Bloom;
}

} // namespace

TEST(ToonBleed, EnergyOfEachPixelsOwnTexel)
{
	// Two texels, 1 and 3, over 4x2 pixels. Toon are one pixel of each: inside 4, outside 3 * 1 + 3 * 3.
	const FImage Ids{4, 2, 1, {Toon, Other, Other, Other, Other, Other, Other, Toon}};
	const FToonBleed Bleed = MeasureToonBleed(MakeBloom(2, 1, {1, 3}), Ids, 1.0);
	EXPECT_DOUBLE_EQ(4, Bleed.Inside);
	EXPECT_DOUBLE_EQ(12, Bleed.Outside);
	EXPECT_DOUBLE_EQ(3, Bleed.GetRatio());
}

TEST(ToonBleed, OddSizesGoByThePixelsCentre)
{
	// Three pixels over two texels: centres at 1/3, 1 and 5/3 of a texel, so 0, 1, 1.
	const FImage Ids{3, 1, 1, {Toon, Toon, Other}};
	const FToonBleed Bleed = MeasureToonBleed(MakeBloom(2, 1, {1, 10}), Ids, 1.0);
	EXPECT_DOUBLE_EQ(11, Bleed.Inside);
	EXPECT_DOUBLE_EQ(10, Bleed.Outside);
}

TEST(ToonBleed, PreExposureIsTakenOut)
{
	EXPECT_DOUBLE_EQ(2, MeasureToonBleed(MakeBloom(1, 1, {8}), FImage{1, 1, 1, {Toon}}, 4.0).Inside);
}

TEST(ToonBleed, NothingInsideHasNoRatio)
{
	const FToonBleed Bleed = MeasureToonBleed(MakeBloom(1, 1, {8}), FImage{1, 1, 1, {Other}}, 1.0);
	EXPECT_DOUBLE_EQ(8, Bleed.Outside);
	EXPECT_EQ(0, Bleed.GetRatio());
}

TEST(ToonBleed, TexelsThatAreNotFiniteDoNotCount)
{
	const FImage Ids{2, 1, 1, {Toon, Toon}};
	EXPECT_DOUBLE_EQ(
		5, MeasureToonBleed(MakeBloom(2, 1, {std::numeric_limits<double>::infinity(), 5}), Ids, 1.0).Inside);
}
