// Scene channels to G-buffer texels, by hand, and the camera's matrices. Formulas: engine DeferredShadingCommon.ush.
#include <gtest/gtest.h>

#include "SceneFile/SceneCamera.h"
#include "SceneFile/SceneTexturePacking.h"

#include <cmath>

using namespace Drydock;

namespace
{

FLinearColor Pack(const char* Texture, const FScenePackValues& Values, const FScenePackContext& Context = {})
{
	const FScenePacking* Packing = FindScenePacking(Texture);
	EXPECT_NE(nullptr, Packing) << Texture;
	return Packing->Pack(Values, Context);
}

/** What a shader's ConvertFromDeviceZ gives. */
double FromDeviceDepth(float DeviceDepth)
{
	const FVector4f Transform = GetInvDeviceZToWorldZTransform();
	return 1.0 / (static_cast<double>(DeviceDepth) * Transform.Z - Transform.W);
}

/** Pixel at which a view of Rect sees a point of the world. */
FVector2D Project(const FViewUniformShaderParameters& View, const FIntRect& Rect, const FVector& Point)
{
	const FVector4f Clip = View.TranslatedWorldToClip.TransformPosition(
		FVector3f(static_cast<float>(Point.X), static_cast<float>(Point.Y), static_cast<float>(Point.Z)) +
		View.PreViewTranslation);
	return FVector2D(Rect.Min.X + (0.5 + 0.5 * Clip.X / Clip.W) * Rect.Width(),
		Rect.Min.Y + (0.5 - 0.5 * Clip.Y / Clip.W) * Rect.Height());
}

FViewUniformShaderParameters MakeView(const FSceneCamera& Camera, const FIntRect& Rect, const FIntRect& BufferRect)
{
	FViewUniformShaderParameters Parameters;
	SetCameraParameters(MakeProjectionData(Camera, FIntPoint(200, 100), Rect, BufferRect), Parameters);
	return Parameters;
}

const FIntRect Whole(0, 0, 200, 100);

} // namespace

TEST(ScenePacking, ShadingModelIsInTheLowFourBitsOfAlpha)
{
	EXPECT_EQ(8.0f / 255.0f, Pack("GBufferB", {0.25f, 0.5f, 0.75f, 8.0f}).A);
	EXPECT_EQ(0.25f, Pack("GBufferB", {0.25f, 0.5f, 0.75f, 8.0f}).R);
	EXPECT_EQ(1.0f / 255.0f, Pack("GBufferB", {0, 0, 0, 17.0f}).A);
	EXPECT_EQ(0.0f, Pack("GBufferB", {0, 0, 0, std::nanf("")}).A);
}

TEST(ScenePacking, NormalIsHalvedAndItsYAxisTurned)
{
	const FLinearColor Normal = Pack("GBufferA", {1, 1, -1, 0});
	EXPECT_EQ(1.0f, Normal.R);
	EXPECT_EQ(0.0f, Normal.G);
	EXPECT_EQ(0.0f, Normal.B);
	EXPECT_EQ(0.5f, Pack("GBufferA", {1, 0, 0, 0}).G);
}

TEST(ScenePacking, NoSurfaceHasAClearedNormal)
{
	EXPECT_EQ(FLinearColor(0, 0, 0, 0), Pack("GBufferA", {0, -0.0f, 0, 0}));
}

TEST(ScenePacking, MaskIsCustomDataBlue)
{
	EXPECT_EQ(FLinearColor(0, 0, 0.5f, 0), Pack("GBufferD", {0.5f, 0, 0, 0}));
}

TEST(ScenePacking, ColourIsPreExposedAndAlphaIsNot)
{
	EXPECT_EQ(FLinearColor(2, 4, 6, 1), Pack("SceneColor", {1, 2, 3, 1}, {2.0f, FIntPoint(1, 1)}));
}

TEST(ScenePacking, DepthIsReversedAndComesBackInCentimetres)
{
	// Near plane 10 cm: 10 cm is 1, 10 m is 0.01, less the guard 1e-8 * 10.
	EXPECT_NEAR(1.0, Pack("SceneDepthZ", {0.1f}).R, 1e-6);
	EXPECT_NEAR(0.01, Pack("SceneDepthZ", {10.0f}).R, 2e-7);
	for (const float Metres : {0.5f, 3.0f, 11.3f, 100.0f, 65504.0f})
	{
		EXPECT_NEAR(1.0, FromDeviceDepth(Pack("SceneDepthZ", {Metres}).R) / (100.0 * Metres), 1e-5) << Metres;
	}
}

TEST(ScenePacking, InfiniteDepthIsTheFarPlane)
{
	EXPECT_EQ(0.0f, Pack("SceneDepthZ", {HUGE_VALF}).R);
	EXPECT_NEAR(1e8, FromDeviceDepth(0.0f), 1.0);
}

TEST(ScenePacking, VelocityIsOfTheViewAndPointsUp)
{
	const FScenePackContext Context{1.0f, FIntPoint(200, 100)};
	const FLinearColor Still = Pack("SceneVelocity", {0, 0}, Context);
	EXPECT_FLOAT_EQ(32767.0f / 65535.0f, Still.R);
	// 100 of 200 pixels right are 1 in screen position: sqrt(2) * 0.2495 above the bias. 25 of 100 down: -0.5, sqrt(1).
	const FLinearColor Moving = Pack("SceneVelocity", {100, 25}, Context);
	EXPECT_NEAR(0.4999924 + 1.41421356 * 0.2495, Moving.R, 1e-6);
	EXPECT_NEAR(0.4999924 - 0.2495, Moving.G, 1e-6);
}

TEST(ScenePacking, OtherUnitsOfTheFile)
{
	const FScenePackContext Context{1.0f, FIntPoint(200, 100), {true, true, true}};
	EXPECT_EQ(Pack("SceneDepthZ", {10.0f}).R, Pack("SceneDepthZ", {1000.0f}, Context).R);
	EXPECT_EQ(1.0f, Pack("GBufferA", {1, 1, -1, 0}, Context).G);
	// 1 in screen position is 100 of 200 pixels, -0.5 is 25 of 100 down.
	EXPECT_EQ(
		Pack("SceneVelocity", {100, 25}, {1.0f, FIntPoint(200, 100)}), Pack("SceneVelocity", {1.0f, -0.5f}, Context));
}

TEST(ScenePacking, TableNamesEachTextureAndChannelOnce)
{
	std::vector<std::string> Names = GetSceneChannelNames();
	std::sort(Names.begin(), Names.end());
	EXPECT_EQ(Names.end(), std::adjacent_find(Names.begin(), Names.end()));
	EXPECT_EQ(nullptr, FindScenePacking("GBufferZ"));
}

TEST(SceneCamera, LooksAlongItsForwardAxis)
{
	// 90 degrees over 200 pixels: the focal length is 100 pixels. 50 cm right at 100 cm is 50 pixels right of the
	// centre.
	FSceneCamera Camera;
	Camera.Location = FVector(10, 20, 30);
	const FViewUniformShaderParameters View = MakeView(Camera, Whole, Whole);
	const FVector2D Pixel = Project(View, Whole, FVector(110, 70, 55));
	EXPECT_NEAR(150, Pixel.X, 1e-3);
	EXPECT_NEAR(25, Pixel.Y, 1e-3);
	EXPECT_EQ(FVector3f(1, 0, 0), View.ViewForward);
	EXPECT_EQ(FVector3f(10, 20, 30), View.WorldCameraOrigin);
}

TEST(SceneCamera, APartOfThePictureSeesThePointAtTheSamePixel)
{
	FSceneCamera Camera;
	Camera.Yaw = 20;
	Camera.Pitch = -10;
	const FIntRect Part(120, 30, 170, 90);
	const FVector Point(100, 60, -10);
	const FVector2D Expected = Project(MakeView(Camera, Whole, Whole), Whole, Point);
	const FVector2D Actual = Project(MakeView(Camera, Part, Part), Part, Point);
	EXPECT_NEAR(Expected.X, Actual.X, 1e-3);
	EXPECT_NEAR(Expected.Y, Actual.Y, 1e-3);
}

TEST(SceneCamera, PrincipalPointAndFocalLengthOfTheFileWin)
{
	const std::optional<FSceneCamera> Camera = ReadSceneCamera(
		R"({"position_uecm": [0, 0, 0], "hfov_deg": 20, "focal_length_px": 50, "principal_point_px": [30, 40]})");
	ASSERT_TRUE(Camera);
	const FVector2D Ahead = Project(MakeView(*Camera, Whole, Whole), Whole, FVector(100, 0, 0));
	EXPECT_NEAR(30, Ahead.X, 1e-3);
	EXPECT_NEAR(40, Ahead.Y, 1e-3);
	EXPECT_NEAR(80, Project(MakeView(*Camera, Whole, Whole), Whole, FVector(100, 100, 0)).X, 1e-3);
}

TEST(SceneCamera, PixelAndDepthGiveTheWorldPositionBack)
{
	FSceneCamera Camera;
	Camera.Location = FVector(5, 0, 0);
	Camera.Yaw = 35;
	const FIntRect InBuffer(64, 32, 264, 132);
	const FViewUniformShaderParameters View = MakeView(Camera, Whole, InBuffer);
	const FVector Point(200, 150, 20);
	const FVector4f Clip = View.TranslatedWorldToClip.TransformPosition(FVector3f(195, 150, 20));
	const FVector2D Pixel = Project(View, InBuffer, Point);
	const FVector4f Back = View.SVPositionToTranslatedWorld.TransformPosition(
		FVector3f(static_cast<float>(Pixel.X), static_cast<float>(Pixel.Y), Clip.Z / Clip.W));
	EXPECT_NEAR(195, Back.X / Back.W, 0.05);
	EXPECT_NEAR(150, Back.Y / Back.W, 0.05);
	EXPECT_NEAR(20, Back.Z / Back.W, 0.05);
	// Screen position times depth, as ScreenToWorld wants it.
	const FVector4f World = View.ScreenToWorld.TransformFVector4(FVector4f(Clip.X, Clip.Y, Clip.W, 1.0f));
	EXPECT_NEAR(200, World.X / World.W, 0.05);
}

TEST(SceneCamera, WorldMatricesHaveTheCameraInThem)
{
	const FSceneCamera Camera{FVector(1000.0, -250.0, 40.0), 10.0, -35.0, 0.0, 70.0, {}, {}, {}, false};
	const FViewUniformShaderParameters View = MakeView(Camera, Whole, Whole);
	for (const FVector3f Point : {FVector3f(1300.0f, -400.0f, 90.0f), FVector3f(2000.0f, -1200.0f, 0.0f)})
	{
		const FVector4f Relative = View.TranslatedWorldToClip.TransformPosition(Point + View.PreViewTranslation);
		const FVector4f Clip = View.WorldToClip.TransformPosition(Point);
		for (int32 Index = 0; Index < 4; ++Index)
		{
			// By row vectors in double: the point against the matrix that has the translation in it.
			const double World[4] = {Point.X, Point.Y, Point.Z, 1.0};
			double Sum = 0.0;
			for (int32 Row = 0; Row < 4; ++Row)
			{
				Sum += World[Row] * double(View.WorldToClip.M[Row][Index]);
			}
			const float Parts[4] = {Clip.X, Clip.Y, Clip.Z, Clip.W};
			const float Expected[4] = {Relative.X, Relative.Y, Relative.Z, Relative.W};
			EXPECT_NEAR(Expected[Index], Parts[Index], 2e-3);
			EXPECT_NEAR(Sum, Parts[Index], 2e-3);
		}
	}
	EXPECT_EQ(View.WorldCameraOrigin, View.RelativeWorldCameraOrigin);
}

TEST(SceneCamera, ThePreviousFrameIsThisOneUntilThereIsAnother)
{
	const FSceneCamera Camera{FVector(1000.0, -250.0, 40.0), 10.0, -35.0, 0.0, 70.0, {}, {}, {}, false};
	FSceneCamera Before = Camera;
	Before.Location = FVector(900.0, -250.0, 40.0);
	FViewUniformShaderParameters View = MakeView(Camera, Whole, Whole);
	EXPECT_EQ(View.TranslatedWorldToClip.M[0][0], View.PrevTranslatedWorldToClip.M[0][0]);
	EXPECT_EQ(View.PreViewTranslation, View.PrevPreViewTranslation);
	SetPrevCameraParameters(MakeProjectionData(Before, FIntPoint(200, 100), Whole, Whole), View);
	EXPECT_EQ(FVector3f(-900.0f, 250.0f, -40.0f), View.PrevPreViewTranslation);
	EXPECT_EQ(FVector3f(900.0f, -250.0f, 40.0f), View.PrevWorldCameraOrigin);
	EXPECT_EQ(FVector3f(-1000.0f, 250.0f, -40.0f), View.PreViewTranslation);
}
