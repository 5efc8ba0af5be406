// Reads the camera from a file's header and makes its matrices.
#include "SceneFile/SceneCamera.h"

#include "Config/ConfigReader.h"
#include "Text/Json.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

constexpr double DegreesToRadians = UE_DOUBLE_PI / 180.0;

/** The engine's guard against a division by zero where there is no surface. */
constexpr double FarthestInverse = 1e-8;

std::optional<double> FindNumber(const FJsonValue& Object, const char* Key)
{
	const FJsonValue* Value = Object.Find(Key);
	return Value != nullptr && Value->Type == EJsonType::Number ? std::optional(Value->Number) : std::nullopt;
}

std::optional<FVector2D> FindPoint(const FJsonValue& Object, const char* Key)
{
	const FJsonValue* Value = Object.Find(Key);
	const bool bPoint = Value != nullptr && Value->Type == EJsonType::Array && Value->Elements.size() == 2 &&
						Value->Elements[0].Type == EJsonType::Number && Value->Elements[1].Type == EJsonType::Number;
	return bPoint ? std::optional(FVector2D(Value->Elements[0].Number, Value->Elements[1].Number)) : std::nullopt;
}

/** World to view axes: x right, y up, z forward. */
FMatrix MakeViewRotation(const FSceneCamera& Camera)
{
	const FMatrix Axes(FVector(0, 0, 1), FVector(1, 0, 0), FVector(0, 1, 0), FVector(0, 0, 0));
	return FInverseRotationMatrix(FRotator(Camera.Pitch, Camera.Yaw, Camera.Roll)) * Axes;
}

FVector3f ToFloat(const FVector& Vector)
{
	return FVector3f(static_cast<float>(Vector.X), static_cast<float>(Vector.Y), static_cast<float>(Vector.Z));
}

} // namespace

std::optional<FSceneCamera> ReadSceneCamera(const std::string& Json)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(Json, "drydock:camera_json", Ignored, bSyntaxError);
	const FJsonValue* Position = Root.Find("position_uecm");
	FConfigVector Location;
	if (bSyntaxError || Position == nullptr || !ReadConfigVector(*Position, Location))
	{
		return std::nullopt;
	}
	FSceneCamera Camera;
	Camera.Location = FVector(Location[0], Location[1], Location[2]);
	Camera.HorizontalFov = FindNumber(Root, "hfov_deg").value_or(Camera.HorizontalFov);
	Camera.FocalLength = FindNumber(Root, "focal_length_px");
	Camera.PrincipalPoint = FindPoint(Root, "principal_point_px");
	Camera.Jitter = FindPoint(Root, "jitter_px");
	const FJsonValue* const Cut = Root.Find("camera_cut");
	Camera.bCut = Cut != nullptr && Cut->Type == EJsonType::Bool && Cut->Bool;
	if (const FJsonValue* Rotator = Root.Find("rotator_ue_deg"))
	{
		Camera.Pitch = FindNumber(*Rotator, "pitch").value_or(0.0);
		Camera.Yaw = FindNumber(*Rotator, "yaw").value_or(0.0);
		Camera.Roll = FindNumber(*Rotator, "roll").value_or(0.0);
	}
	return Camera;
}

std::optional<double> ReadSceneDeltaTime(const std::string& Json)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(Json, "drydock:camera_json", Ignored, bSyntaxError);
	const std::optional<double> Seconds = bSyntaxError ? std::nullopt : FindNumber(Root, "delta_time_s");
	return Seconds && *Seconds > 0.0 && std::isfinite(*Seconds) ? Seconds : std::nullopt;
}

FVector2D MakeClipJitter(const FSceneCamera& Camera, const FIntRect& Rect)
{
	const FVector2D Jitter = Camera.Jitter.value_or(FVector2D(0.0, 0.0));
	return FVector2D(2.0 * Jitter.X / Rect.Width(), -2.0 * Jitter.Y / Rect.Height());
}

FMatrix MakeProjection(const FSceneCamera& Camera, FIntPoint PictureExtent, const FIntRect& Rect)
{
	const FVector2D Center = Camera.PrincipalPoint.value_or(FVector2D(0.5 * PictureExtent.X, 0.5 * PictureExtent.Y));
	const double Focal =
		Camera.FocalLength.value_or(0.5 * PictureExtent.X / std::tan(0.5 * Camera.HorizontalFov * DegreesToRadians));
	const double Width = Rect.Width();
	const double Height = Rect.Height();
	return FMatrix(FVector4(2.0 * Focal / Width, 0, 0, 0), FVector4(0, 2.0 * Focal / Height, 0, 0),
		FVector4(2.0 * (Center.X - Rect.Min.X) / Width - 1.0, 1.0 - 2.0 * (Center.Y - Rect.Min.Y) / Height, 0, 1),
		FVector4(0, 0, SceneNearPlane, 0));
}

FVector4f GetInvDeviceZToWorldZTransform()
{
	return FVector4f(0.0f, 0.0f, static_cast<float>(1.0 / SceneNearPlane), static_cast<float>(-FarthestInverse));
}

float MakeDeviceDepth(double Depth)
{
	return static_cast<float>(std::max(0.0, (1.0 / Depth - FarthestInverse) * SceneNearPlane));
}

FSceneViewProjectionData MakeProjectionData(
	const FSceneCamera& Camera, FIntPoint PictureExtent, const FIntRect& Rect, const FIntRect& BufferRect)
{
	FSceneViewProjectionData ProjectionData;
	ProjectionData.ViewOrigin = Camera.Location;
	ProjectionData.ViewRotationMatrix = MakeViewRotation(Camera);
	ProjectionData.ProjectionMatrix = MakeProjection(Camera, PictureExtent, Rect);
	ProjectionData.SetViewRectangle(BufferRect);
	return ProjectionData;
}

void SetCameraParameters(const FSceneViewProjectionData& ProjectionData, FViewUniformShaderParameters& Parameters)
{
	const FMatrix& ViewRotation = ProjectionData.ViewRotationMatrix;
	const FMatrix& Projection = ProjectionData.ProjectionMatrix;
	const FIntRect& BufferRect = ProjectionData.GetViewRect();
	const FMatrix ToClip = ViewRotation * Projection;
	const FMatrix FromClip = Projection.Inverse() * ViewRotation.GetTransposed();

	// Pixel of the scene textures and device depth to clip space.
	const double Width = BufferRect.Width();
	const double Height = BufferRect.Height();
	const FMatrix PixelToClip(FVector4(2.0 / Width, 0, 0, 0), FVector4(0, -2.0 / Height, 0, 0), FVector4(0, 0, 1, 0),
		FVector4(-1.0 - 2.0 * BufferRect.Min.X / Width, 1.0 + 2.0 * BufferRect.Min.Y / Height, 0, 1));
	// (screen x * z, screen y * z, z, 1) to clip space.
	const FMatrix ScreenToClip(FVector4(1, 0, 0, 0), FVector4(0, 1, 0, 0), FVector4(0, 0, Projection.M[2][2], 1),
		FVector4(0, 0, Projection.M[3][2], 0));

	Parameters.TranslatedWorldToView = FMatrix44f(ViewRotation);
	Parameters.ViewToTranslatedWorld = FMatrix44f(ViewRotation.GetTransposed());
	Parameters.ViewToClip = FMatrix44f(Projection);
	Parameters.ClipToView = FMatrix44f(Projection.Inverse());
	Parameters.TranslatedWorldToClip = FMatrix44f(ToClip);
	Parameters.ClipToTranslatedWorld = FMatrix44f(FromClip);
	Parameters.SVPositionToTranslatedWorld = FMatrix44f(PixelToClip * FromClip);
	Parameters.ScreenToTranslatedWorld = FMatrix44f(ScreenToClip * FromClip);
	Parameters.ScreenToWorld = FMatrix44f(ScreenToClip * FromClip * FTranslationMatrix(ProjectionData.ViewOrigin));
	Parameters.ClipToPrevClip = FMatrix44f::Identity;
	const FTranslationMatrix ToTranslatedWorld(ProjectionData.ViewOrigin * -1.0);
	const FTranslationMatrix ToWorld(ProjectionData.ViewOrigin);
	Parameters.WorldToView = FMatrix44f(ToTranslatedWorld * ViewRotation);
	Parameters.WorldToClip = FMatrix44f(ToTranslatedWorld * ToClip);
	Parameters.ViewToWorld = FMatrix44f(ViewRotation.GetTransposed() * ToWorld);
	Parameters.ClipToWorld = FMatrix44f(FromClip * ToWorld);

	const auto GetAxis = [&ViewRotation](int32 Column)
	{
		return ToFloat(FVector(ViewRotation.M[0][Column], ViewRotation.M[1][Column], ViewRotation.M[2][Column]));
	};
	Parameters.ViewRight = GetAxis(0);
	Parameters.ViewUp = GetAxis(1);
	Parameters.ViewForward = GetAxis(2);
	Parameters.WorldCameraOrigin = ToFloat(ProjectionData.ViewOrigin);
	Parameters.TranslatedWorldCameraOrigin = FVector3f(0.0f, 0.0f, 0.0f);
	Parameters.PreViewTranslation = ToFloat(ProjectionData.ViewOrigin * -1.0);
	Parameters.RelativeWorldCameraOrigin = Parameters.WorldCameraOrigin;
	Parameters.WorldViewOriginHigh = Parameters.WorldCameraOrigin;
	const FVector High(Parameters.WorldCameraOrigin.X, Parameters.WorldCameraOrigin.Y, Parameters.WorldCameraOrigin.Z);
	Parameters.WorldViewOriginLow = ToFloat(ProjectionData.ViewOrigin - High);
	Parameters.InvDeviceZToWorldZTransform = GetInvDeviceZToWorldZTransform();
	Parameters.NearPlane = static_cast<float>(SceneNearPlane);
	const float AngleX = static_cast<float>(2.0 * std::atan(1.0 / Projection.M[0][0]));
	const float AngleY = static_cast<float>(2.0 * std::atan(1.0 / Projection.M[1][1]));
	Parameters.FieldOfViewWideAngles = FVector4f(AngleX, AngleY, AngleX, AngleY);
	SetPrevCameraParameters(ProjectionData, Parameters);
}

void SetPrevCameraParameters(const FSceneViewProjectionData& Previous, FViewUniformShaderParameters& Parameters)
{
	Parameters.PrevTranslatedWorldToView = FMatrix44f(Previous.ViewRotationMatrix);
	Parameters.PrevViewToClip = FMatrix44f(Previous.ProjectionMatrix);
	Parameters.PrevTranslatedWorldToClip = FMatrix44f(Previous.ViewRotationMatrix * Previous.ProjectionMatrix);
	Parameters.PrevWorldCameraOrigin = ToFloat(Previous.ViewOrigin);
	Parameters.PrevPreViewTranslation = ToFloat(Previous.ViewOrigin * -1.0);
}

FMatrix44f MakeClipToPrevClip(const FSceneViewProjectionData& Current, const FSceneViewProjectionData& Previous)
{
	if (Current.ViewOrigin == Previous.ViewOrigin && Current.ViewRotationMatrix == Previous.ViewRotationMatrix &&
		Current.ProjectionMatrix == Previous.ProjectionMatrix)
	{
		return FMatrix44f::Identity;
	}
	const FMatrix ToTranslatedWorld = Current.ProjectionMatrix.Inverse() * Current.ViewRotationMatrix.GetTransposed();
	// Each frame's translated world has its own camera at the origin.
	const FTranslationMatrix ToPrevTranslatedWorld(Current.ViewOrigin - Previous.ViewOrigin);
	return FMatrix44f(
		ToTranslatedWorld * ToPrevTranslatedWorld * (Previous.ViewRotationMatrix * Previous.ProjectionMatrix));
}

} // namespace Drydock
