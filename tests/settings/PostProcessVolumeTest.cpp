// Weight of a volume by distance. Rule: weight = clamp(BlendWeight) * (1 - distance / BlendRadius), by hand.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "Engine/PostProcessVolume.h"
#include "PostProcessVolumeWeight.h"

#include <cmath>
#include <limits>

using namespace Drydock;

namespace
{

FPostProcessVolumeProperties Bounded(float BlendRadius, float BlendWeight = 1.0f)
{
	FPostProcessVolumeProperties Volume;
	Volume.bIsEnabled = true;
	Volume.BlendRadius = BlendRadius;
	Volume.BlendWeight = BlendWeight;
	return Volume;
}

float WeightAt(const FPostProcessVolumeProperties& Volume, double Distance)
{
	return GetInfluence(Volume, Distance).Weight;
}

} // namespace

TEST(VolumeWeight, DefaultsAreTheEngines)
{
	const APostProcessVolume Volume;
	EXPECT_EQ(0.0f, Volume.Priority);
	EXPECT_EQ(100.0f, Volume.BlendRadius);
	EXPECT_EQ(1.0f, Volume.BlendWeight);
	EXPECT_TRUE(Volume.bEnabled);
	EXPECT_FALSE(Volume.bUnbound);
}

TEST(VolumeWeight, E4FalloffIsLinearHalfAtHalfTheRadius)
{
	EXPECT_EQ(0.5f, WeightAt(Bounded(100.0f), 50.0));
	EXPECT_EQ(0.25f, WeightAt(Bounded(100.0f), 75.0));
}

TEST(VolumeWeight, E4FullInside)
{
	EXPECT_EQ(1.0f, WeightAt(Bounded(100.0f), 0.0));
}

TEST(VolumeWeight, E4NothingAtTheRadiusAndBeyond)
{
	EXPECT_EQ(0.0f, WeightAt(Bounded(100.0f), 100.0));
	EXPECT_EQ(EVolumeSkip::OutOfRadius, GetInfluence(Bounded(100.0f), 100.0).Skip);
	EXPECT_EQ(EVolumeSkip::OutOfRadius, GetInfluence(Bounded(100.0f), 101.0).Skip);
}

TEST(VolumeWeight, RadiusBelowOneIsFullToItsEdge)
{
	EXPECT_EQ(1.0f, WeightAt(Bounded(0.5f), 0.5));
	EXPECT_EQ(0.0f, WeightAt(Bounded(0.5f), 0.5000001));
}

TEST(VolumeWeight, RadiusZeroIsAllOrNothing)
{
	EXPECT_EQ(1.0f, WeightAt(Bounded(0.0f), 0.0));
	EXPECT_EQ(0.0f, WeightAt(Bounded(0.0f), 1e-9));
}

TEST(VolumeWeight, RadiusOneFallsOffAlready)
{
	EXPECT_EQ(0.75f, WeightAt(Bounded(1.0f), 0.25));
}

TEST(VolumeWeight, NegativeRadiusActsNowhere)
{
	EXPECT_EQ(0.0f, WeightAt(Bounded(-1.0f), 0.0));
}

TEST(VolumeWeight, E2UnboundIgnoresTheDistance)
{
	FPostProcessVolumeProperties Volume = Bounded(100.0f, 0.75f);
	Volume.bIsUnbound = true;
	EXPECT_EQ(0.75f, WeightAt(Volume, 1e9));
	EXPECT_EQ(0.75f, WeightAt(Volume, std::nan("")));
}

TEST(VolumeWeight, E3BlendWeightScalesTheFalloff)
{
	EXPECT_EQ(0.25f, WeightAt(Bounded(100.0f, 0.5f), 50.0));
}

TEST(VolumeWeight, E5BlendWeightIsClamped)
{
	EXPECT_EQ(0.5f, WeightAt(Bounded(100.0f, 7.0f), 50.0));
	EXPECT_EQ(0.0f, WeightAt(Bounded(100.0f, -7.0f), 50.0));
}

TEST(VolumeWeight, E5WeightZeroSkips)
{
	EXPECT_EQ(EVolumeSkip::NoWeight, GetInfluence(Bounded(100.0f, 0.0f), 0.0).Skip);
	EXPECT_EQ(EVolumeSkip::NoWeight, GetInfluence(Bounded(100.0f, -1.0f), 0.0).Skip);
}

TEST(VolumeWeight, DisabledSkipsWhateverElse)
{
	FPostProcessVolumeProperties Volume = Bounded(100.0f, 0.0f);
	Volume.bIsEnabled = false;
	Volume.bIsUnbound = true;
	EXPECT_EQ(EVolumeSkip::Disabled, GetInfluence(Volume, 0.0).Skip);
}

TEST(VolumeWeight, NaNSkips)
{
	const float NaN = std::numeric_limits<float>::quiet_NaN();
	EXPECT_EQ(EVolumeSkip::NotANumber, GetInfluence(Bounded(NaN), 0.0).Skip);
	EXPECT_EQ(EVolumeSkip::NotANumber, GetInfluence(Bounded(100.0f, NaN), 0.0).Skip);
	EXPECT_EQ(EVolumeSkip::NotANumber, GetInfluence(Bounded(100.0f), std::nan("")).Skip);
}

TEST(VolumeWeight, InfiniteRadiusIsFullEverywhere)
{
	EXPECT_EQ(1.0f, WeightAt(Bounded(std::numeric_limits<float>::infinity()), 1e30));
}

TEST(VolumeWeight, InfinitelyFarIsNothing)
{
	const float Infinity = std::numeric_limits<float>::infinity();
	EXPECT_EQ(0.0f, WeightAt(Bounded(Infinity), static_cast<double>(Infinity)));
	EXPECT_EQ(0.0f, WeightAt(Bounded(100.0f), static_cast<double>(Infinity)));
}

TEST(VolumeWeight, SkipsAreExplained)
{
	EXPECT_EQ("out of radius: 150.5 cm away, BlendRadius 100.0",
		ExplainSkip(EVolumeSkip::OutOfRadius, Bounded(100.0f), 150.5));
	EXPECT_EQ("out of radius: 1e+200 cm away, BlendRadius 100.0",
		ExplainSkip(EVolumeSkip::OutOfRadius, Bounded(100.0f), 1e200));
	EXPECT_EQ("", ExplainSkip(EVolumeSkip::None, Bounded(100.0f), 0.0));
}

TEST(VolumeWeight, TinyWeightIsNotLost)
{
	// 1 - 99999.9 / 100000 = 1e-6
	EXPECT_NEAR(1e-6f, WeightAt(Bounded(100000.0f), 99999.9), 1e-11f);
	EXPECT_EQ(EVolumeSkip::None, GetInfluence(Bounded(100000.0f), 99999.9).Skip);
}

RC_GTEST_PROP(VolumeWeight, LiesBetweenZeroAndOneAndFallsWithTheDistance, ())
{
	const FPostProcessVolumeProperties Volume =
		Bounded(*rc::gen::inRange(-10, 5000) / 8.0f, *rc::gen::inRange(-32, 64) / 32.0f);
	const double Near = *rc::gen::inRange(0, 5000) / 8.0;
	const double Far = Near + *rc::gen::inRange(0, 5000) / 8.0;
	RC_ASSERT(WeightAt(Volume, Near) >= WeightAt(Volume, Far));
	RC_ASSERT(WeightAt(Volume, Near) <= 1.0f && WeightAt(Volume, Far) >= 0.0f);
}

TEST(PostProcessVolume, EncompassesPointSaysHowFar)
{
	APostProcessVolume Volume;
	Volume.Shape = FVolumeShape::MakeSphere(FVector(0, 0, 0), 5.0);
	float Distance = -1.0f;
	EXPECT_FALSE(Volume.EncompassesPoint(FVector(0, 0, 12), 6.0f, &Distance));
	EXPECT_EQ(7.0f, Distance);
	EXPECT_TRUE(Volume.EncompassesPoint(FVector(0, 0, 12), 7.0f));
	EXPECT_TRUE(Volume.EncompassesPoint(FVector(0, 0, 3)));
}

TEST(PostProcessVolume, PropertiesAreItsMembers)
{
	APostProcessVolume Volume;
	Volume.Priority = 3.0f;
	Volume.BlendWeight = 0.5f;
	Volume.bUnbound = true;
	const IInterface_PostProcessVolume& Interface = Volume;
	const FPostProcessVolumeProperties Properties = Interface.GetProperties();
	EXPECT_EQ(&Volume.Settings, Properties.Settings);
	EXPECT_EQ(3.0f, Properties.Priority);
	EXPECT_EQ(0.5f, Properties.BlendWeight);
	EXPECT_TRUE(Properties.bIsEnabled && Properties.bIsUnbound);
}
