// Twelve layouts whose values were worked out on paper. BloomSizeScale is 4 where nothing sets it.
#include <gtest/gtest.h>

#include "BlendTesting.h"

using namespace Drydock;

namespace
{

FPostProcessSettings Scale(double Value)
{
	return Give({{"BloomSizeScale", Value}});
}

float ScaleAt(const std::vector<APostProcessVolume>& Volumes, const FVector& Location)
{
	return Blended(Volumes, Location).BloomSizeScale;
}

} // namespace

TEST(BlendLayouts, HalfWayIntoTheRadius)
{
	// A cube to x = 100, a radius of 200, the view at x = 200: distance 100, weight 1 - 100/200 = 1/2.
	// 4 + (8 - 4) / 2 = 6. (A quadratic falloff would give 7.)
	EXPECT_EQ(
		6.0f, ScaleAt({Bounded(0, FVolumeShape::MakeBox(FVector(0, 0, 0), FVector(100, 100, 100)), 200, Scale(8))},
				  FVector(200, 0, 0)));
}

TEST(BlendLayouts, TwoHalfWeightsAreAQuarterAQuarterAndAHalf)
{
	// 4/4 + 8/4 + 16/2 = 1 + 2 + 8
	EXPECT_EQ(11.0f, ScaleAt({Unbound(0, 0.5f, Scale(8)), Unbound(1, 0.5f, Scale(16))}, FVector(0, 0, 0)));
}

TEST(BlendLayouts, CameraOnTheBoundaryOfTwoRooms)
{
	const FVector Half(200, 200, 200);
	const std::vector<APostProcessVolume> Rooms = {
		Bounded(0, FVolumeShape::MakeBox(FVector(-200, 0, 0), Half), 100, Scale(8)),
		Bounded(1, FVolumeShape::MakeBox(FVector(200, 0, 0), Half), 100, Scale(16))};
	// On the wall x = 0 both are at distance 0 and full: the higher one alone.
	EXPECT_EQ(16.0f, ScaleAt(Rooms, FVector(0, 0, 0)));
	// 50 before it the first is full, the second at 1/2: 8 + (16 - 8) / 2.
	EXPECT_EQ(12.0f, ScaleAt(Rooms, FVector(-50, 0, 0)));
	// 50 behind it the first is at 1/2, which the full second covers.
	EXPECT_EQ(16.0f, ScaleAt(Rooms, FVector(50, 0, 0)));
	// 100 before it the second has just ended.
	EXPECT_EQ(8.0f, ScaleAt(Rooms, FVector(-100, 0, 0)));
}

TEST(BlendLayouts, AThousandSpheresInARow)
{
	std::vector<APostProcessVolume> Spheres;
	for (int Index = 0; Index < 1000; ++Index)
	{
		Spheres.push_back(Bounded(
			static_cast<float>(Index), FVolumeShape::MakeSphere(FVector(100.0 * Index, 0, 0), 1), 50, Scale(Index)));
	}
	// In the middle of number 700; its neighbours are 99 away.
	EXPECT_EQ(700.0f, ScaleAt(Spheres, FVector(70000, 0, 0)));
	// 24 beside its skin, 74 beside the next one's: weight 1 - 24/50 = 0.52; 4 + 0.52 * 696 = 365.92.
	EXPECT_FLOAT_EQ(365.92f, ScaleAt(Spheres, FVector(70025, 0, 0)));
}

TEST(BlendLayouts, RotatedBox)
{
	const std::vector<APostProcessVolume> Volumes = {
		Bounded(0, FVolumeShape::MakeBox(FVector(0, 0, 0), FVector(300, 100, 100), FRotator(0, 90, 0)), 400, Scale(8))};
	// The long side lies along Y: x = 200 is 100 outside, weight 1 - 100/400 = 3/4; 4 + 3. Unrotated: y = 250 is 150
	// outside, which would give 6.5.
	EXPECT_EQ(7.0f, ScaleAt(Volumes, FVector(200, 250, 0)));
}

TEST(BlendLayouts, BoxOnItsEdge)
{
	const std::vector<APostProcessVolume> Volumes = {
		Bounded(0, FVolumeShape::MakeBox(FVector(0, 0, 0), FVector(100, 100, 100), FRotator(0, 45, 0)), 100, Scale(8))};
	// Turned by 45 degrees its edge reaches x = 100 * sqrt 2 = 141.42136; 50 further the weight is 1/2.
	EXPECT_FLOAT_EQ(6.0f, ScaleAt(Volumes, FVector(191.42135623730951, 0, 0)));
}

TEST(BlendLayouts, Sphere)
{
	// 125 above the centre of a sphere of 50: 75 of 100, weight 1/4.
	EXPECT_EQ(5.0f, ScaleAt({Bounded(0, FVolumeShape::MakeSphere(FVector(100, 200, 300), 50), 100, Scale(8))},
						FVector(100, 200, 425)));
}

TEST(BlendLayouts, CapsuleOnItsSide)
{
	// Rolled by 90 degrees its segment lies along Y from -70 to 70. 30 beyond its end and 40 above it: 50 away, less
	// the radius of 30 is 20 of 80, weight 3/4.
	EXPECT_EQ(7.0f,
		ScaleAt({Bounded(0, FVolumeShape::MakeCapsule(FVector(0, 0, 0), 30, 100, FRotator(0, 0, 90)), 80, Scale(8))},
			FVector(0, 100, 40)));
}

TEST(BlendLayouts, ConvexTetrahedron)
{
	// The plane x + y + z = 400 is (600 - 400) / sqrt 3 = 115.470 away from (200, 200, 200), and the radius is twice
	// that.
	const FVolumeShape Tetrahedron =
		FVolumeShape::MakeConvex({FVector(0, 0, 0), FVector(400, 0, 0), FVector(0, 400, 0), FVector(0, 0, 400)});
	EXPECT_NEAR(6.0f, ScaleAt({Bounded(0, Tetrahedron, 230.9401f, Scale(8))}, FVector(200, 200, 200)), 1e-6f);
	// (100, 100, 100) is inside: 300 < 400.
	EXPECT_EQ(8.0f, ScaleAt({Bounded(0, Tetrahedron, 230.9401f, Scale(8))}, FVector(100, 100, 100)));
}

TEST(BlendLayouts, EqualPrioritiesFollowTheDeclaration)
{
	const APostProcessVolume Eight = Unbound(5, 0.5f, Scale(8));
	const APostProcessVolume Sixteen = Unbound(5, 0.5f, Scale(16));
	// 1 + 2 + 8, and 1 + 4 + 4.
	EXPECT_EQ(11.0f, ScaleAt({Eight, Sixteen}, FVector(0, 0, 0)));
	EXPECT_EQ(9.0f, ScaleAt({Sixteen, Eight}, FVector(0, 0, 0)));
}

TEST(BlendLayouts, CameraOverVolumes)
{
	FBlendInputs Scene = Inputs({Unbound(1e9f, 1.0f, Scale(8))});
	Scene.Camera = Scale(16);
	Scene.CameraWeight = 0.25f;
	// 8 + (16 - 8) / 4
	EXPECT_EQ(10.0f, BlendAt(Scene).Settings.BloomSizeScale);
}

TEST(BlendLayouts, FocalDistanceSwitchesOnAndOffAndBlendsBetween)
{
	const auto Focus = [](float Priority, float Weight, double Distance)
	{
		return Unbound(Priority, Weight, Give({{"DepthOfFieldFocalDistance", Distance}}));
	};
	// From 0 (off) to 500 at once, whatever the weight; then half way to 1000; then off at once.
	EXPECT_EQ(500.0f, Blended({Focus(0, 0.25f, 500)}).DepthOfFieldFocalDistance);
	EXPECT_EQ(750.0f, Blended({Focus(0, 0.25f, 500), Focus(1, 0.5f, 1000)}).DepthOfFieldFocalDistance);
	EXPECT_EQ(
		0.0f, Blended({Focus(0, 0.25f, 500), Focus(1, 0.5f, 1000), Focus(2, 0.125f, 0)}).DepthOfFieldFocalDistance);
}

TEST(BlendLayouts, ShowFlagHasTheLastWord)
{
	FBlendInputs Scene = Inputs({Unbound(0, 1.0f, Give({{"BloomIntensity", 8}}))});
	Scene.Camera = Give({{"BloomIntensity", 16}});
	Scene.CommandLine = Give({{"BloomIntensity", 32}});
	EXPECT_EQ(32.0f, BlendAt(Scene).Settings.BloomIntensity);
	Scene.ShowFlags.SetBloom(false);
	EXPECT_EQ(0.0f, BlendAt(Scene).Settings.BloomIntensity);
}
