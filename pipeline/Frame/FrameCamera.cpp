// Gives a view its camera.
#include "Frame/FrameCamera.h"

#include "SceneFile/SceneCamera.h"
#include "SceneViewState.h"

namespace Drydock
{

namespace
{

FViewMatrices MakeViewMatrices(const FSceneViewProjectionData& Projection, FVector2D Jitter)
{
	FViewMatrices::FMinimalInitializer Initializer;
	Initializer.ViewRotationMatrix = Projection.ViewRotationMatrix;
	Initializer.ProjectionMatrix = Projection.ProjectionMatrix;
	Initializer.ViewOrigin = Projection.ViewOrigin;
	Initializer.ConstrainedViewRect = Projection.GetViewRect();
	FViewMatrices Matrices(Initializer);
	if (Jitter != FVector2D(0.0, 0.0))
	{
		Matrices.HackAddTemporalAAProjectionJitter(Jitter);
	}
	return Matrices;
}

/** The projection as pictures are drawn by it. */
FSceneViewProjectionData MakeJittered(const FSceneViewProjectionData& Projection, const FViewMatrices& Matrices)
{
	FSceneViewProjectionData Jittered = Projection;
	Jittered.ProjectionMatrix = Matrices.GetProjectionMatrix();
	return Jittered;
}

} // namespace

void SetUpCamera(const FSceneViewProjectionData& Projection, FVector2D Jitter, FViewInfo& View)
{
	const FMatrix& ToView = Projection.ViewRotationMatrix;
	View.ViewMatrices = MakeViewMatrices(Projection, Jitter);
	View.TemporalJitterPixels =
		FVector2D(0.5 * Jitter.X * View.ViewRect.Width(), -0.5 * Jitter.Y * View.ViewRect.Height());
	View.ViewLocation = Projection.ViewOrigin;
	View.ViewRotation =
		FQuat(FMatrix(ToView.GetColumn(2), ToView.GetColumn(0), ToView.GetColumn(1), FVector())).Rotator();
	View.FOV = static_cast<float>(FMath::RadiansToDegrees(2.0 * View.ViewMatrices.ComputeHalfFieldOfViewPerAxis().X));
	View.DesiredFOV = View.FOV;
	View.PrevViewInfo.ViewRect = View.ViewRect;
	View.PrevViewInfo.ViewMatrices = View.ViewMatrices;
	View.PrevViewInfo.SceneColorPreExposure = View.PreExposure;
	FViewHistory& Next = View.ViewState->Next;
	Next.Projection = Projection;
	Next.Jitter = Jitter;
	Next.PreExposure = View.PreExposure;
	SetCameraParameters(MakeJittered(Projection, View.ViewMatrices), View.UniformParameters);
	const FViewHistory& Last = View.ViewState->GetLast();
	if (Last.Projection && !View.bCameraCut)
	{
		View.PrevViewInfo.ViewRect = Last.Projection->GetViewRect();
		View.PrevViewInfo.ViewMatrices = MakeViewMatrices(*Last.Projection, Last.Jitter);
		View.PrevViewInfo.SceneColorPreExposure = Last.PreExposure;
		// Without both frames' jitter, as velocities are.
		View.UniformParameters.ClipToPrevClip = MakeClipToPrevClip(Projection, *Last.Projection);
		SetPrevCameraParameters(MakeJittered(*Last.Projection, View.PrevViewInfo.ViewMatrices), View.UniformParameters);
	}
}

void UpdateCamera(FViewInfo& View)
{
	FSceneViewProjectionData Projection = *View.ViewState->Next.Projection;
	const FViewMatrices Changed = View.ViewMatrices;
	if (Changed == MakeViewMatrices(Projection, View.ViewState->Next.Jitter))
	{
		return;
	}
	const FVector2D Jitter = Changed.GetTemporalAAJitter();
	Projection.ViewOrigin = Changed.GetViewOrigin();
	Projection.ViewRotationMatrix = Changed.GetTranslatedViewMatrix();
	Projection.ProjectionMatrix = Changed.GetProjectionNoAAMatrix();
	SetUpCamera(Projection, Jitter, View);
	View.ViewMatrices = Changed;
}

} // namespace Drydock
