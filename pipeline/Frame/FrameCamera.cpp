// Gives a view its camera.
#include "Frame/FrameCamera.h"

#include "SceneFile/SceneCamera.h"
#include "SceneViewState.h"

namespace Drydock
{

namespace
{

FViewMatrices MakeViewMatrices(const FSceneViewProjectionData& Projection)
{
	FViewMatrices::FMinimalInitializer Initializer;
	Initializer.ViewRotationMatrix = Projection.ViewRotationMatrix;
	Initializer.ProjectionMatrix = Projection.ProjectionMatrix;
	Initializer.ViewOrigin = Projection.ViewOrigin;
	Initializer.ConstrainedViewRect = Projection.GetViewRect();
	return FViewMatrices(Initializer);
}

} // namespace

void SetUpCamera(const FSceneViewProjectionData& Projection, FViewInfo& View)
{
	const FMatrix& ToView = Projection.ViewRotationMatrix;
	View.ViewMatrices = MakeViewMatrices(Projection);
	View.ViewLocation = Projection.ViewOrigin;
	View.ViewRotation =
		FQuat(FMatrix(ToView.GetColumn(2), ToView.GetColumn(0), ToView.GetColumn(1), FVector())).Rotator();
	View.FOV = static_cast<float>(FMath::RadiansToDegrees(2.0 * View.ViewMatrices.ComputeHalfFieldOfViewPerAxis().X));
	View.DesiredFOV = View.FOV;
	View.PrevViewInfo.ViewRect = View.ViewRect;
	View.PrevViewInfo.ViewMatrices = View.ViewMatrices;
	View.PrevViewInfo.SceneColorPreExposure = View.PreExposure;
	View.ViewState->Next.Projection = Projection;
	SetCameraParameters(Projection, View.UniformParameters);
	if (const std::optional<FSceneViewProjectionData>& Last = View.ViewState->GetLast().Projection)
	{
		View.PrevViewInfo.ViewRect = Last->GetViewRect();
		View.PrevViewInfo.ViewMatrices = MakeViewMatrices(*Last);
		View.UniformParameters.ClipToPrevClip = MakeClipToPrevClip(Projection, *Last);
		SetPrevCameraParameters(*Last, View.UniformParameters);
	}
}

void UpdateCamera(FViewInfo& View)
{
	FSceneViewProjectionData Projection = *View.ViewState->Next.Projection;
	const FViewMatrices Changed = View.ViewMatrices;
	if (Changed == MakeViewMatrices(Projection))
	{
		return;
	}
	Projection.ViewOrigin = Changed.GetViewOrigin();
	Projection.ViewRotationMatrix = Changed.GetTranslatedViewMatrix();
	Projection.ProjectionMatrix = Changed.GetProjectionMatrix();
	SetUpCamera(Projection, View);
	// The jitter is part of the projection, and known by itself too.
	const FVector2D Jitter = Changed.GetTemporalAAJitter();
	View.ViewMatrices = Changed;
	View.UniformParameters.TemporalAAJitter =
		FVector4f(static_cast<float>(Jitter.X), static_cast<float>(Jitter.Y), 0.0f, 0.0f);
	View.TemporalJitterPixels =
		FVector2D(0.5 * Jitter.X * View.ViewRect.Width(), -0.5 * Jitter.Y * View.ViewRect.Height());
}

} // namespace Drydock
