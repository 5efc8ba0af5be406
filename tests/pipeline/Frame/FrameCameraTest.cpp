// A view's matrices are those of the camera by plain maths, agree with what shaders read, and know the frame before.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <random>

#include "ExtensionTestUtils.h"
#include "SceneViewState.h"

using namespace ExtensionTest;

namespace
{

using FPlainMatrix = std::array<std::array<double, 4>, 4>;

FPlainMatrix Multiply(const FPlainMatrix& A, const FPlainMatrix& B)
{
	FPlainMatrix Result = {};
	for (size_t Row = 0; Row < 4; ++Row)
	{
		for (size_t Column = 0; Column < 4; ++Column)
		{
			for (size_t Inner = 0; Inner < 4; ++Inner)
			{
				Result[Row][Column] += A[Row][Inner] * B[Inner][Column];
			}
		}
	}
	return Result;
}

/** Matrices of a camera, from sines and cosines alone. */
struct FPlainCamera
{
	FPlainMatrix Rotation = {};
	FPlainMatrix View = {};
	FPlainMatrix Projection = {};

	FPlainCamera(const FSceneCamera& Camera, double Width, double Height)
	{
		constexpr double ToRadians = 3.14159265358979323846 / 180.0;
		const double Yaw = Camera.Yaw * ToRadians;
		const double Pitch = Camera.Pitch * ToRadians;
		const double Forward[3] = {std::cos(Pitch) * std::cos(Yaw), std::cos(Pitch) * std::sin(Yaw), std::sin(Pitch)};
		const double Right[3] = {-std::sin(Yaw), std::cos(Yaw), 0.0};
		const double Up[3] = {-std::sin(Pitch) * std::cos(Yaw), -std::sin(Pitch) * std::sin(Yaw), std::cos(Pitch)};
		const double Location[3] = {Camera.Location.X, Camera.Location.Y, Camera.Location.Z};
		FPlainMatrix Translation = {};
		for (size_t Axis = 0; Axis < 3; ++Axis)
		{
			Rotation[Axis] = {Right[Axis], Up[Axis], Forward[Axis], 0.0};
			Translation[Axis][Axis] = 1.0;
			Translation[3][Axis] = -Location[Axis];
		}
		Rotation[3][3] = Translation[3][3] = 1.0;
		View = Multiply(Translation, Rotation);
		const double Scale = 1.0 / std::tan(0.5 * Camera.HorizontalFov * ToRadians);
		Projection[0][0] = Scale;
		Projection[1][1] = Scale * Width / Height;
		Projection[2][3] = 1.0;
		Projection[3][2] = 10.0; // the near plane
	}
};

template<typename MatrixType>
void ExpectMatrix(const FPlainMatrix& Expected, const MatrixType& Actual, double Tolerance, const char* Name)
{
	for (size_t Row = 0; Row < 4; ++Row)
	{
		for (size_t Column = 0; Column < 4; ++Column)
		{
			const double Scale = std::max(1.0, std::fabs(Expected[Row][Column]));
			EXPECT_NEAR(Expected[Row][Column], static_cast<double>(Actual.M[Row][Column]), Tolerance * Scale)
				<< Name << " [" << Row << "][" << Column << "]";
		}
	}
}

void ExpectInverse(const FMatrix& Matrix, const FMatrix& Inverse, const char* Name)
{
	FPlainMatrix A, B, One = {};
	for (size_t Row = 0; Row < 4; ++Row)
	{
		One[Row][Row] = 1.0;
		for (size_t Column = 0; Column < 4; ++Column)
		{
			A[Row][Column] = Matrix.M[Row][Column];
			B[Row][Column] = Inverse.M[Row][Column];
		}
	}
	const FPlainMatrix Product = Multiply(A, B);
	FMatrix Actual;
	for (size_t Index = 0; Index < 16; ++Index)
	{
		Actual.M[Index / 4][Index % 4] = Product[Index / 4][Index % 4];
	}
	ExpectMatrix(One, Actual, 1e-9, Name);
}

/** Records what a view has when its passes are added; may jitter it before. */
class FSeesCamera : public FSceneViewExtensionBase
{
public:
	using FSceneViewExtensionBase::FSceneViewExtensionBase;

	void SetupView(FSceneViewFamily&, FSceneView& View) override
	{
		if (Jitter != FVector2D(0.0, 0.0))
		{
			View.ViewMatrices.HackAddTemporalAAProjectionJitter(Jitter);
		}
	}
	void PrePostProcessPass_RenderThread(FRDGBuilder&, const FSceneView& View, const FPostProcessingInputs&) override
	{
		const FViewInfo& Info = static_cast<const FViewInfo&>(View);
		Matrices = View.ViewMatrices;
		Previous = Info.PrevViewInfo.ViewMatrices;
		Uniforms = *Info.CachedViewUniformShaderParameters;
		Buffer = *static_cast<const FViewUniformShaderParameters*>(View.ViewUniformBuffer->GetContents());
		Direction = View.GetViewDirection();
		Rotation = View.ViewRotation;
		Fov = View.FOV;
		JitterPixels = Info.TemporalJitterPixels;
		bIsFamilyInfo = &static_cast<const FViewFamilyInfo*>(View.Family)->GetSceneTextures() == Info.SceneTextures;
	}

	FVector2D Jitter = FVector2D(0.0, 0.0);
	FViewMatrices Matrices;
	FViewMatrices Previous;
	FViewUniformShaderParameters Uniforms;
	FViewUniformShaderParameters Buffer;
	FVector Direction;
	FRotator Rotation;
	float Fov = 0.0f;
	FVector2D JitterPixels = FVector2D(0.0, 0.0);
	bool bIsFamilyInfo = false;
};

FFrameInputs MakeFrameOf(const FSceneCamera& Camera)
{
	FFrameInputs Inputs = MakeFrame();
	Inputs.Views[0].Lens = Camera;
	Inputs.Views[0].Camera.Location = Camera.Location;
	Inputs.Views[0].Camera.Rotation = FRotator(Camera.Pitch, Camera.Yaw, Camera.Roll);
	Inputs.Views[0].Camera.FOV = static_cast<float>(Camera.HorizontalFov);
	return Inputs;
}

FSceneCamera MakeCamera(std::mt19937& Random)
{
	std::uniform_real_distribution<double> Place(-900.0, 900.0);
	FSceneCamera Camera;
	Camera.Location = FVector(Place(Random), Place(Random), Place(Random));
	Camera.Pitch = Place(Random) / 12.0;
	Camera.Yaw = Place(Random) / 6.0;
	Camera.HorizontalFov = 70.0 + Place(Random) / 30.0;
	return Camera;
}

} // namespace

TEST(FrameCamera, MatricesAreThoseOfPlainMathsAndOfTheUniformBuffer)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FSeesCamera>();
	std::mt19937 Random(7);
	for (int Run = 0; Run < 4; ++Run)
	{
		SCOPED_TRACE("camera " + std::to_string(Run) + " of seed 7");
		const FSceneCamera Camera = MakeCamera(Random);
		Render(MakeFrameOf(Camera));
		const FPlainCamera Plain(Camera, Width, Height);
		const FViewMatrices& Seen = Extension->Matrices;
		const FViewUniformShaderParameters& Shaders = Extension->Uniforms;

		ExpectMatrix(Plain.View, Seen.GetViewMatrix(), 1e-10, "View");
		ExpectMatrix(Plain.Rotation, Seen.GetTranslatedViewMatrix(), 1e-12, "TranslatedView");
		ExpectMatrix(Plain.Rotation, Seen.GetOverriddenTranslatedViewMatrix(), 1e-12, "OverriddenTranslatedView");
		ExpectMatrix(Plain.Projection, Seen.GetProjectionMatrix(), 1e-12, "Projection");
		ExpectMatrix(Plain.Projection, Seen.GetProjectionNoAAMatrix(), 1e-12, "ProjectionNoAA");
		ExpectMatrix(Plain.Projection, Seen.ComputeProjectionNoAAMatrix(), 1e-12, "ComputeProjectionNoAA");
		const FPlainMatrix ToClip = Multiply(Plain.View, Plain.Projection);
		const FPlainMatrix TranslatedToClip = Multiply(Plain.Rotation, Plain.Projection);
		ExpectMatrix(ToClip, Seen.GetViewProjectionMatrix(), 1e-10, "ViewProjection");
		ExpectMatrix(TranslatedToClip, Seen.GetTranslatedViewProjectionMatrix(), 1e-12, "TranslatedViewProjection");
		ExpectInverse(Seen.GetViewMatrix(), Seen.GetInvViewMatrix(), "InvView");
		ExpectInverse(Seen.GetProjectionMatrix(), Seen.GetInvProjectionMatrix(), "InvProjection");
		ExpectInverse(Seen.GetViewProjectionMatrix(), Seen.GetInvViewProjectionMatrix(), "InvViewProjection");
		ExpectInverse(Seen.GetTranslatedViewMatrix(), Seen.GetInvTranslatedViewMatrix(), "InvTranslatedView");
		ExpectInverse(Seen.GetTranslatedViewProjectionMatrix(), Seen.GetInvTranslatedViewProjectionMatrix(),
			"InvTranslatedViewProjection");
		EXPECT_EQ(Camera.Location, Seen.GetViewOrigin());
		EXPECT_EQ(Camera.Location * -1.0, Seen.GetPreViewTranslation());
		EXPECT_EQ(FVector2D(0.0, 0.0), Seen.GetTemporalAAJitter());
		EXPECT_TRUE(Seen.IsPerspectiveProjection());
		EXPECT_NEAR(10.0f, Seen.ComputeNearPlane(), 1e-5f);
		EXPECT_NEAR(0.5 * Width * Plain.Projection[0][0], Seen.GetScreenScale(), 1e-4);

		// Shaders read the same numbers, as floats.
		ExpectMatrix(ToClip, Shaders.WorldToClip, 1e-6, "WorldToClip");
		ExpectMatrix(TranslatedToClip, Shaders.TranslatedWorldToClip, 1e-6, "TranslatedWorldToClip");
		EXPECT_EQ(FMatrix44f(Seen.GetProjectionMatrix()), Shaders.ViewToClip);
		EXPECT_EQ(FMatrix44f(Seen.GetInvProjectionMatrix()), Shaders.ClipToView);
		EXPECT_EQ(FMatrix44f(Seen.GetViewMatrix()), Shaders.WorldToView);
		EXPECT_EQ(FMatrix44f(Seen.GetInvViewMatrix()), Shaders.ViewToWorld);
		EXPECT_EQ(FMatrix44f(Seen.GetTranslatedViewMatrix()), Shaders.TranslatedWorldToView);
		EXPECT_EQ(FMatrix44f(Seen.GetInvTranslatedViewProjectionMatrix()), Shaders.ClipToTranslatedWorld);
		EXPECT_EQ(FVector3f(Seen.GetPreViewTranslation()), Shaders.PreViewTranslation);
		EXPECT_EQ(Shaders.ViewToClip, Extension->Buffer.ViewToClip);

		// The first frame's past is itself.
		EXPECT_EQ(Seen, Extension->Previous);
		const double Forward[3] = {Plain.Rotation[0][2], Plain.Rotation[1][2], Plain.Rotation[2][2]};
		EXPECT_TRUE(Extension->Direction.Equals(FVector(Forward[0], Forward[1], Forward[2]), 1e-9));
		EXPECT_NEAR(Camera.Pitch, Extension->Rotation.Pitch, 1e-6);
		EXPECT_NEAR(Camera.Yaw, Extension->Rotation.Yaw, 1e-6);
		EXPECT_NEAR(0.0, Extension->Rotation.Roll, 1e-6);
		EXPECT_NEAR(Camera.HorizontalFov, Extension->Fov, 1e-4);
		EXPECT_TRUE(Extension->bIsFamilyInfo);
	}
}

TEST(FrameCamera, AJitterOfAnExtensionReachesTheUniformBuffer)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FSeesCamera>();
	std::mt19937 Random(11);
	const FSceneCamera Camera = MakeCamera(Random);
	Extension->Jitter = FVector2D(0.5 / Width, -0.25 / Height);
	Render(MakeFrameOf(Camera));
	FPlainCamera Plain(Camera, Width, Height);
	ExpectMatrix(Plain.Projection, Extension->Matrices.GetProjectionNoAAMatrix(), 1e-12, "ProjectionNoAA");
	ExpectMatrix(Plain.Projection, Extension->Matrices.ComputeProjectionNoAAMatrix(), 1e-12, "ComputeProjectionNoAA");
	Plain.Projection[2][0] += 0.5 / Width;
	Plain.Projection[2][1] -= 0.25 / Height;
	ExpectMatrix(Plain.Projection, Extension->Matrices.GetProjectionMatrix(), 1e-12, "Projection");
	ExpectMatrix(Plain.Projection, Extension->Uniforms.ViewToClip, 1e-6, "ViewToClip");
	ExpectMatrix(Multiply(Plain.View, Plain.Projection), Extension->Uniforms.WorldToClip, 1e-6, "WorldToClip");
	ExpectInverse(Extension->Matrices.GetProjectionMatrix(), Extension->Matrices.GetInvProjectionMatrix(), "Inverse");
	EXPECT_NEAR(0.5 / Width, Extension->Uniforms.TemporalAAJitter.X, 1e-8);
	EXPECT_NEAR(-0.25 / Height, Extension->Uniforms.TemporalAAJitter.Y, 1e-8);
	EXPECT_NEAR(0.25, Extension->JitterPixels.X, 1e-12);
	EXPECT_NEAR(0.125, Extension->JitterPixels.Y, 1e-12);

	FViewMatrices Removed = Extension->Matrices;
	Removed.HackRemoveTemporalAAProjectionJitter();
	EXPECT_TRUE(Removed.GetProjectionMatrix().Equals(Removed.GetProjectionNoAAMatrix(), 1e-12));
	EXPECT_EQ(FVector2D(0.0, 0.0), Removed.GetTemporalAAJitter());
}

TEST(FrameCamera, TheNextFrameKnowsTheMatricesOfThisOne)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FSeesCamera>();
	std::mt19937 Random(13);
	const FSceneCamera First = MakeCamera(Random);
	const FSceneCamera Second = MakeCamera(Random);
	const FFrameResult Before = Render(MakeFrameOf(First));
	const FViewMatrices Seen = Extension->Matrices;
	FFrameInputs Inputs = MakeFrameOf(Second);
	Inputs.ViewStates = Before.ViewStates;
	Render(Inputs);
	EXPECT_EQ(Seen, Extension->Previous);
	const FPlainCamera Plain(First, Width, Height);
	ExpectMatrix(Plain.View, Extension->Previous.GetViewMatrix(), 1e-10, "View");
	ExpectMatrix(Plain.Projection, Extension->Uniforms.PrevViewToClip, 1e-6, "PrevViewToClip");
	EXPECT_EQ(FVector3f(Seen.GetPreViewTranslation()), Extension->Uniforms.PrevPreViewTranslation);
	ExpectMatrix(FPlainCamera(Second, Width, Height).View, Extension->Matrices.GetViewMatrix(), 1e-10, "second View");
}

TEST(FrameCamera, AViewMovesByUpdateViewMatrixAsTheCameraDoes)
{
	std::mt19937 Random(17);
	const FSceneCamera Camera = MakeCamera(Random);
	FViewMatrices Matrices;
	Matrices.UpdateViewMatrix(Camera.Location, FRotator(Camera.Pitch, Camera.Yaw, 0.0));
	ExpectMatrix(FPlainCamera(Camera, 1.0, 1.0).View, Matrices.GetViewMatrix(), 1e-10, "View");
	EXPECT_EQ(Camera.Location, Matrices.GetViewOrigin());
}
