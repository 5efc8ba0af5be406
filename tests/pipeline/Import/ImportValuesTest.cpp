// The formulas of an import by hand, and against vectors drawn at random (seed 17) that are encoded here, the other way
// round, in double.
#include "Import/ImportConvert.h"
#include "Import/ImportPrimaries.h"
#include "SceneFile/SceneCamera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace Drydock;

namespace
{

constexpr float Infinity = std::numeric_limits<float>::infinity();
constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

std::optional<float> Depth(float Value, EImportDepth Way, const char* Unit = "m")
{
	FImportEncoding Encoding;
	Encoding.Depth = Way;
	Encoding.Unit = Unit;
	Encoding.Mist = {2.0, 10.0};
	return ConvertDepth(Value, Encoding, {3, 0, 4, 2}, 2.0);
}

std::array<float, 2> Velocity(float X, float Y, EImportVelocity Way, bool bFlip = false)
{
	FImportEncoding Encoding;
	Encoding.Velocity = Way;
	Encoding.bFlipVelocity = bFlip;
	return ConvertVelocity({X, Y}, Encoding, 200, 100);
}

std::array<float, 3> Normal(
	const std::array<double, 3>& N, EImportNormalSpace Space, bool bHalved, const std::array<double, 3>& Rotation = {})
{
	FImportEncoding Encoding;
	Encoding.NormalSpace = Space;
	Encoding.bHalved = bHalved;
	std::array<float, 3> Stored = {};
	for (size_t Axis = 0; Axis < 3; ++Axis)
	{
		Stored[Axis] = static_cast<float>(bHalved ? 0.5 * N[Axis] + 0.5 : N[Axis]);
	}
	return ConvertNormal(Stored, Encoding, Rotation);
}

void ExpectNear(const std::array<double, 3>& Expected, const std::array<float, 3>& Actual)
{
	for (size_t Axis = 0; Axis < 3; ++Axis)
	{
		EXPECT_NEAR(Expected[Axis], Actual[Axis], 1e-5) << "axis " << Axis;
	}
}

} // namespace

TEST(ImportDepth, ComesInUnits)
{
	EXPECT_EQ(2.5f, Depth(2.5f, EImportDepth::Distance));
	EXPECT_FLOAT_EQ(2.5f, *Depth(250.0f, EImportDepth::Distance, "cm"));
	EXPECT_FLOAT_EQ(2.5f, *Depth(2500.0f, EImportDepth::Distance, "mm"));
	EXPECT_FLOAT_EQ(2.5f, *Depth(0.0025f, EImportDepth::Distance, "km"));
}

TEST(ImportDepth, NoSurfaceIsWhatIsFarNotANumberOrNotThere)
{
	for (const float None : {Infinity, NaN, 0.0f, -1.0f, 65504.0f, 1e10f})
	{
		EXPECT_FALSE(Depth(None, EImportDepth::Distance)) << None;
	}
	EXPECT_FALSE(Depth(65504.0f, EImportDepth::Distance, "cm")); // where halves of Unreal's centimetres end
	EXPECT_TRUE(Depth(65505.0f, EImportDepth::Distance, "cm"));  // 655 m, in 32 bit
	EXPECT_FALSE(Depth(1e8f, EImportDepth::Distance, "cm"));
}

TEST(ImportDepth, OtherWays)
{
	EXPECT_FLOAT_EQ(4.0f, *Depth(0.25f, EImportDepth::Inverse));
	EXPECT_FALSE(Depth(0.0f, EImportDepth::Inverse));
	EXPECT_FLOAT_EQ(5.0f, *Depth(0.02f, EImportDepth::Device)); // 0.1 m / 0.02
	EXPECT_FALSE(Depth(0.0f, EImportDepth::Device));
	EXPECT_FLOAT_EQ(4.5f, *Depth(0.25f, EImportDepth::Mist)); // 2 m and a quarter of 10 m
	EXPECT_FALSE(Depth(1.0f, EImportDepth::Mist));
	// The pixel (3, 0) of 4 x 2 is 1.5 right and 0.5 up of the centre, 2 pixels away: 1 / sqrt(1 + 0.5625 + 0.0625).
	EXPECT_FLOAT_EQ(static_cast<float>(10.0 / std::sqrt(1.625)), *Depth(10.0f, EImportDepth::Ray));
}

TEST(ImportVelocity, IsPixelsWithYDown)
{
	using FPixels = std::array<float, 2>;
	EXPECT_EQ((FPixels{3, -2}), Velocity(3, -2, EImportVelocity::Pixels));
	EXPECT_EQ((FPixels{3, -2}), Velocity(3, 2, EImportVelocity::PixelsUp));
	EXPECT_EQ((FPixels{50, 25}), Velocity(0.5f, -0.5f, EImportVelocity::Ndc)); // of 200 x 100
	EXPECT_EQ((FPixels{0, 0}), Velocity(0.5f, 0.5f, EImportVelocity::Unreal));
	EXPECT_EQ((FPixels{100, 50}), Velocity(0.75f, 0.25f, EImportVelocity::Unreal));
	EXPECT_EQ((FPixels{-3, 2}), Velocity(3, 2, EImportVelocity::Blender));
	EXPECT_EQ((FPixels{-3, 2}), Velocity(3, -2, EImportVelocity::Pixels, true));
	EXPECT_EQ((FPixels{0, 0}), Velocity(NaN, 1, EImportVelocity::Pixels));
	EXPECT_EQ((FPixels{0, 0}), Velocity(1, Infinity, EImportVelocity::Blender));
}

TEST(ImportVelocity, AQuarterOfTheEnginesVelocityIsThePass)
{
	std::mt19937 Random(17);
	std::uniform_real_distribution<double> Pixels(-60.0, 60.0);
	for (int Count = 0; Count < 100; ++Count)
	{
		const double Right = Pixels(Random);
		const double Down = Pixels(Random);
		// The engine's screen position of 200 x 100 pixels runs from -1 to 1, y up.
		const double Across = Right / 200.0 * 2.0;
		const double Up = -Down / 100.0 * 2.0;
		const std::array<float, 2> Back = Velocity(
			static_cast<float>(0.5 + Across / 4.0), static_cast<float>(0.5 + Up / 4.0), EImportVelocity::Unreal);
		EXPECT_NEAR(Right, Back[0], 1e-4);
		EXPECT_NEAR(Down, Back[1], 1e-4);
	}
}

TEST(ImportNormal, AxesOfOthersAreTurned)
{
	std::mt19937 Random(17);
	std::normal_distribution<double> Component;
	for (int Count = 0; Count < 100; ++Count)
	{
		std::array<double, 3> N = {Component(Random), Component(Random), Component(Random)};
		const double Length = std::hypot(N[0], N[1], N[2]);
		for (double& Axis : N)
		{
			Axis /= Length;
		}
		for (const bool bHalved : {false, true})
		{
			ExpectNear(N, Normal(N, EImportNormalSpace::World, bHalved));
			ExpectNear(N, Normal({N[0], -N[1], N[2]}, EImportNormalSpace::Unreal, bHalved));
			// Z up is Y up turned about X: up (0, 0, 1) is stored as (0, 1, 0).
			ExpectNear(N, Normal({N[0], N[2], -N[1]}, EImportNormalSpace::YUp, bHalved));
		}
	}
}

TEST(ImportNormal, OfTheCamerasSpaceFollowItsRotation)
{
	// Unrotated, the engine's camera looks along X; y points right, which is -Y of a right-handed world.
	ExpectNear({-1, 0, 0}, Normal({0, 0, 1}, EImportNormalSpace::Camera, false));
	ExpectNear({0, -1, 0}, Normal({1, 0, 0}, EImportNormalSpace::Camera, false));
	ExpectNear({0, 0, 1}, Normal({0, 1, 0}, EImportNormalSpace::Camera, true));
	// Yaw 90 looks along the engine's Y: what faces the viewer points along the scene's +Y.
	ExpectNear({0, 1, 0}, Normal({0, 0, 1}, EImportNormalSpace::Camera, false, {0, 90, 0}));
	// Pitch 90 looks up: what faces the viewer points down.
	ExpectNear({0, 0, -1}, Normal({0, 0, 1}, EImportNormalSpace::Camera, false, {90, 0, 0}));
	// Roll 90, clockwise: what was right of the camera is below.
	ExpectNear({0, 0, -1}, Normal({1, 0, 0}, EImportNormalSpace::Camera, false, {0, 0, 90}));
}

TEST(ImportNormal, NoSurfaceStaysNone)
{
	const std::array<float, 3> None = {0, 0, 0};
	FImportEncoding Encoding;
	EXPECT_EQ(None, ConvertNormal({0, 0, 0}, Encoding, {}));
	EXPECT_EQ(None, ConvertNormal({NaN, 0, 1}, Encoding, {}));
	Encoding.bHalved = true;
	EXPECT_EQ(None, ConvertNormal({0, 0, 0}, Encoding, {}));
	EXPECT_EQ(None, ConvertNormal({0.5f, 0.5f, 0.5f}, Encoding, {}));
}

TEST(ImportNormal, UnitLengthKeepsItsBitsAndOthersGetIt)
{
	FImportEncoding Encoding;
	EXPECT_EQ((std::array<float, 3>{0.6f, 0.0f, 0.8f}), ConvertNormal({0.6f, 0.0f, 0.8f}, Encoding, {}));
	ExpectNear({0.6, 0, 0.8}, ConvertNormal({0.3f, 0.0f, 0.4f}, Encoding, {}));
}

TEST(ImportPrimaries, Rec709AndNoneAreLeftAlone)
{
	EXPECT_FALSE(MakeRec709Matrix({}));
	EXPECT_FALSE(MakeRec709Matrix({0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f}));
	EXPECT_FALSE(MakeRec709Matrix({0, 0, 0, 0, 0, 0, 0, 0}));
	EXPECT_FALSE(MakeRec709Matrix({0.6f, 0.3f, 0.6f, 0.3f, 0.6f, 0.3f, 0.3127f, 0.3290f})); // on one point
	EXPECT_FALSE(MakeRec709Matrix({NaN, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f}));
}

TEST(ImportPrimaries, WhiteStaysWhiteAndKnownMatricesComeOut)
{
	// ITU-R BT.2087 prints Rec.2020 to Rec.709; the ACES documents print AP1 (D60) to Rec.709 (D65), Bradford.
	const std::vector<float> Rec2020 = {0.708f, 0.292f, 0.170f, 0.797f, 0.131f, 0.046f, 0.3127f, 0.3290f};
	const std::vector<float> AP1 = {0.713f, 0.293f, 0.165f, 0.830f, 0.128f, 0.044f, 0.32168f, 0.33767f};
	const std::array<std::array<double, 3>, 3> From2020 = {
		{{1.6605, -0.5876, -0.0728}, {-0.1246, 1.1329, -0.0083}, {-0.0182, -0.1006, 1.1187}}};
	const std::array<std::array<double, 3>, 3> FromAP1 = {
		{{1.70505, -0.62179, -0.08326}, {-0.13026, 1.14080, -0.01055}, {-0.02400, -0.12897, 1.15297}}};
	for (const auto& [Chromaticities, Expected] : {std::pair(Rec2020, From2020), std::pair(AP1, FromAP1)})
	{
		const std::optional<FColorMatrix> Matrix = MakeRec709Matrix(Chromaticities);
		ASSERT_TRUE(Matrix);
		for (size_t Row = 0; Row < 3; ++Row)
		{
			EXPECT_NEAR(1.0, (*Matrix)[Row][0] + (*Matrix)[Row][1] + (*Matrix)[Row][2], 1e-6);
			for (size_t Column = 0; Column < 3; ++Column)
			{
				EXPECT_NEAR(Expected[Row][Column], (*Matrix)[Row][Column], 2e-4) << Row << Column;
			}
		}
	}
}

TEST(ImportCamera, UnrealsAttributesOfTwoReleases)
{
	const FImportCamera Old =
		ReadImportCamera({{"unreal/camera/curPos/x", "10.5"}, {"unreal/camera/curPos/y", "-20"},
							 {"unreal/camera/curPos/z", "150"}, {"unreal/camera/curRot/pitch", "-5"},
							 {"unreal/camera/curRot/yaw", "90"}, {"unreal/camera/curRot/roll", "0"},
							 {"unreal/camera/FinalImage/fov", "60"}, {"unreal/frameRate", "24000/1001"}},
			{});
	EXPECT_EQ((std::array<double, 3>{10.5, -20, 150}), *Old.Location);
	EXPECT_EQ((std::array<double, 3>{-5, 90, 0}), *Old.Rotation);
	EXPECT_EQ(60.0, *Old.Fov);
	EXPECT_NEAR(1001.0 / 24000.0, *Old.DeltaTime, 1e-12);
	const FImportCamera New =
		ReadImportCamera({{"unreal/layerData/rgba/focalLength", "18"}, {"unreal/layerData/rgba/sensorWidth", "36"},
							 {"unreal/frameRate", "soon"}},
			{});
	EXPECT_NEAR(90.0, *New.Fov, 1e-9); // half a sensor by the focal length is 1
	EXPECT_FALSE(New.Location);
	EXPECT_FALSE(New.DeltaTime);
	EXPECT_EQ("", MakeCameraJson(ReadImportCamera({{"Camera", "Camera"}}, {}), 4, 3, 1));
}

TEST(ImportCamera, WhatIsWrittenIsWhatASceneReads)
{
	FImportAsked Asked;
	Asked.Location = {1, 2, 3};
	Asked.Rotation = {4, 5, 6};
	Asked.Fov = 70.0;
	const std::optional<FSceneCamera> Camera =
		ReadSceneCamera(MakeCameraJson(ReadImportCamera({}, Asked), 200, 100, std::nullopt));
	ASSERT_TRUE(Camera);
	EXPECT_EQ(FVector(1, 2, 3), Camera->Location);
	EXPECT_EQ(5.0, Camera->Yaw);
	EXPECT_EQ(70.0, Camera->HorizontalFov);
}
