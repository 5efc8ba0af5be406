// Calls on views, inside a frame: in the hooks of an extension that the test registers.
#include "Calls.h"
#include "FrameCalls.h"

#include "Camera/CameraTypes.h"
#include "Engine/Engine.h"
#include "FXRenderingUtils.h"
#include "PostProcess/PostProcessing.h"
#include "ScenePrivate.h"

namespace
{

constexpr Calls::EArea Area = Calls::EArea::View;

/** A perspective view: the transform from world to clip by hand, row vectors. */
FVector4 Transform(const FVector4& V, const FMatrix& M)
{
	FVector4 Result(0, 0, 0, 0);
	for (int32 Column = 0; Column < 4; ++Column)
	{
		for (int32 Row = 0; Row < 4; ++Row)
		{
			Result[Column] += V[Row] * M.M[Row][Column];
		}
	}
	return Result;
}

/** What a blendable pushes. */
struct FCallsBlendable
{
	static const FName& GetFName()
	{
		static const FName Name(TEXT("FCallsBlendable"));
		return Name;
	}
};

bool IsInverse(const FMatrix& A, const FMatrix& B)
{
	return (A * B).Equals(FMatrix::Identity, 1e-4);
}

void CallView(FRDGBuilder& GraphBuilder, const FSceneView& View)
{
	const FIntRect Rect(0, 0, Calls::FrameWidth, Calls::FrameHeight);
	CALL("FSceneView::Family", View.Family->Views[0] == &View);
	CALL("FSceneView::bIsViewInfo", View.bIsViewInfo);
	const FViewInfo& Info = static_cast<const FViewInfo&>(View);
	CALL("static_cast<const FViewInfo&>, FViewInfo::ViewRect", Info.ViewRect == Rect);
	CALL("FViewInfo::ShaderMap",
		Info.ShaderMap != nullptr && Info.ShaderMap == GetGlobalShaderMap(View.GetFeatureLevel()));
	CALL("FSceneView::GetFeatureLevel, FeatureLevel",
		View.GetFeatureLevel() == ERHIFeatureLevel::SM5 || View.FeatureLevel == ERHIFeatureLevel::SM6);
	CALL("FSceneView::GetShaderPlatform", View.GetShaderPlatform() == GMaxRHIShaderPlatform);
	CALL("FSceneView::UnconstrainedViewRect, UnscaledViewRect",
		View.UnconstrainedViewRect == Rect && View.UnscaledViewRect == Rect);
	CALL("FSceneView::ViewUniformBuffer", View.ViewUniformBuffer.IsValid());
	CALL("UE::FXRenderingUtils::GetRawViewRectUnsafe", UE::FXRenderingUtils::GetRawViewRectUnsafe(View) == Rect);
	CALL("FSceneView::GetOverwriteLoadAction", View.GetOverwriteLoadAction() == ERenderTargetLoadAction::ENoAction);
	CALL("FSceneView::bIsSceneCapture, bIsReflectionCapture, bIsPlanarReflection",
		!View.bIsSceneCapture && !View.bIsReflectionCapture && !View.bIsPlanarReflection);
	CALL("FSceneView::bIsGameView", View.bIsGameView);
	CALL("FSceneView::bIsSceneCaptureCube, bIsOfflineRender, bIsVirtualTexture",
		!View.bIsSceneCaptureCube && !View.bIsOfflineRender && !View.bIsVirtualTexture);
	CALL("FSceneView::bCameraCut", View.bCameraCut || !View.bCameraCut);
	CALL("FSceneView::AntiAliasingMethod", View.AntiAliasingMethod >= AAM_None && View.AntiAliasingMethod < AAM_MAX);
	CALL("FSceneView::StereoViewIndex, PlayerIndex, ViewActor",
		View.StereoViewIndex == INDEX_NONE && View.PlayerIndex == INDEX_NONE && View.ViewActor == nullptr);
	CALL("FSceneView::State, GetViewKey", View.State == nullptr || View.GetViewKey() == View.State->GetViewKey());
	CALL("FViewInfo::ViewState", Info.ViewState == nullptr || Info.ViewState->GetViewKey() == View.GetViewKey());
	CALL("FSceneView::GetLastEyeAdaptationExposure", View.GetLastEyeAdaptationExposure() >= 0.0f);
	CALL("FSceneView::ViewLocation, ViewRotation",
		View.ViewLocation == View.ViewMatrices.GetViewOrigin() && View.ViewRotation.Equals(View.ViewRotation));
	CALL("FSceneView::FOV, DesiredFOV", View.FOV > 0.0f && View.FOV < 180.0f && View.DesiredFOV > 0.0f);
	CALL("FSceneView::IsPerspectiveProjection", View.IsPerspectiveProjection());
	CALL("FSceneView::GetViewDirection, GetViewRight, GetViewUp",
		FMath::IsNearlyEqual(View.GetViewDirection().Size(), 1.0, 1e-6) &&
			FMath::Abs(View.GetViewDirection() | View.GetViewRight()) < 1e-6 &&
			FMath::Abs(View.GetViewUp() | View.GetViewRight()) < 1e-6);
	CALL("FSceneView::ColorScale, OverlayColor", View.ColorScale == FLinearColor::White && View.OverlayColor.A == 0.0f);
	const FViewMatrices& M = View.ViewMatrices;
	CALL("FViewMatrices::GetViewMatrix, GetInvViewMatrix", IsInverse(M.GetViewMatrix(), M.GetInvViewMatrix()));
	CALL("FViewMatrices::GetProjectionMatrix, GetInvProjectionMatrix",
		IsInverse(M.GetProjectionMatrix(), M.GetInvProjectionMatrix()));
	CALL("FViewMatrices::GetProjectionNoAAMatrix, ComputeProjectionNoAAMatrix",
		M.GetProjectionNoAAMatrix().Equals(M.ComputeProjectionNoAAMatrix(), 1e-6));
	CALL("FViewMatrices::ComputeInvProjectionNoAAMatrix",
		IsInverse(M.GetProjectionNoAAMatrix(), M.ComputeInvProjectionNoAAMatrix()));
	CALL("FViewMatrices::GetViewProjectionMatrix, GetInvViewProjectionMatrix",
		M.GetViewProjectionMatrix().Equals(M.GetViewMatrix() * M.GetProjectionMatrix(), 1e-6) &&
			IsInverse(M.GetViewProjectionMatrix(), M.GetInvViewProjectionMatrix()));
	CALL("FViewMatrices::GetTranslatedViewMatrix, GetInvTranslatedViewMatrix",
		IsInverse(M.GetTranslatedViewMatrix(), M.GetInvTranslatedViewMatrix()));
	CALL("FViewMatrices::GetOverriddenTranslatedViewMatrix, GetOverriddenInvTranslatedViewMatrix",
		IsInverse(M.GetOverriddenTranslatedViewMatrix(), M.GetOverriddenInvTranslatedViewMatrix()));
	CALL("FViewMatrices::GetTranslatedViewProjectionMatrix, GetInvTranslatedViewProjectionMatrix",
		M.GetTranslatedViewProjectionMatrix().Equals(M.GetTranslatedViewMatrix() * M.GetProjectionMatrix(), 1e-6) &&
			IsInverse(M.GetTranslatedViewProjectionMatrix(), M.GetInvTranslatedViewProjectionMatrix()));
	CALL("FViewMatrices::GetViewOrigin, GetPreViewTranslation", M.GetPreViewTranslation() == -M.GetViewOrigin());
	CALL("FViewMatrices::GetTemporalAAJitter", M.GetTemporalAAJitter() == FVector2D(0, 0));
	CALL("FViewMatrices::IsPerspectiveProjection", M.IsPerspectiveProjection());
	CALL("FViewMatrices::ComputeNearPlane", M.ComputeNearPlane() > 0.0f);
	CALL("FViewMatrices::ComputeHalfFieldOfViewPerAxis", M.ComputeHalfFieldOfViewPerAxis().X > 0.0);
	CALL("FViewMatrices::GetScreenScale", M.GetScreenScale() > 0.0f);
	CALL("FMatrix44f(View.ViewMatrices...)",
		FMatrix44f(M.GetInvProjectionMatrix()).M[3][3] == float(M.GetInvProjectionMatrix().M[3][3]));
	// A point 100 cm before the camera is in the middle of the picture, and w is its depth.
	const FVector Point = M.GetViewOrigin() + View.GetViewDirection() * 100.0;
	const FVector4 Clip = Transform(FVector4(Point, 1.0), M.GetViewProjectionMatrix());
	CALL("View.ViewMatrices of a point",
		FMath::Abs(Clip.X / Clip.W) < 1e-6 && FMath::IsNearlyEqual(Clip.W, 100.0, 1e-4));
	FViewMatrices Jittered = M;
	Jittered.HackAddTemporalAAProjectionJitter(FVector2D(0.25, 0.5));
	CALL("FViewMatrices::HackAddTemporalAAProjectionJitter",
		Jittered.GetProjectionMatrix().M[2][0] == M.GetProjectionMatrix().M[2][0] + 0.25);
	Jittered.HackRemoveTemporalAAProjectionJitter();
	CALL("FViewMatrices::HackRemoveTemporalAAProjectionJitter",
		Jittered.GetProjectionMatrix().Equals(M.GetProjectionNoAAMatrix(), 1e-9));
	CALL("FViewInfo::PrevViewInfo",
		Info.PrevViewInfo.ViewRect == Rect &&
			Info.PrevViewInfo.ViewMatrices.GetProjectionMatrix().Equals(M.GetProjectionMatrix(), 1e-6));
	CALL("FPreviousViewInfo::SceneColorPreExposure", Info.PrevViewInfo.SceneColorPreExposure > 0.0f);
	CALL("FViewInfo::TemporalJitterPixels", Info.TemporalJitterPixels == FVector2D(0, 0));
	CALL("FViewInfo::PreExposure", Info.PreExposure == 1.0f);
	CALL("FViewInfo::GetSecondaryViewRectSize", Info.GetSecondaryViewRectSize() == Rect.Size());
	CALL("FViewInfo::bUseComputePasses", Info.bUseComputePasses || !Info.bUseComputePasses);
	CALL("FViewInfo::CachedViewUniformShaderParameters", Info.CachedViewUniformShaderParameters->PreExposure == 1.0f);
	const FViewUniformShaderParameters& P = *Info.CachedViewUniformShaderParameters;
	CALL("FViewUniformShaderParameters::ViewToClip, ClipToView",
		P.ViewToClip.M[2][3] == 1.0f && P.ClipToView.M[0][0] > 0.0f);
	CALL("FViewUniformShaderParameters::TranslatedWorldToClip, TranslatedWorldToView, ViewToTranslatedWorld, "
		 "ClipToTranslatedWorld",
		FMatrix(P.TranslatedWorldToClip).Equals(M.GetTranslatedViewProjectionMatrix(), 1e-4));
	CALL("FViewUniformShaderParameters::ViewForward, ViewUp, ViewRight",
		FVector(P.ViewForward).Equals(View.GetViewDirection(), 1e-6) &&
			FVector(P.ViewRight).Equals(View.GetViewRight(), 1e-6));
	CALL("FViewUniformShaderParameters::ViewSizeAndInvSize",
		P.ViewSizeAndInvSize == FVector4f(Rect.Width(), Rect.Height(), 1.0f / Rect.Width(), 1.0f / Rect.Height()));
	CALL("FViewUniformShaderParameters::BufferSizeAndInvSize", P.BufferSizeAndInvSize.X == float(Rect.Width()));
	CALL("FViewUniformShaderParameters::ViewRectMin, ViewRectMinAndSize",
		P.ViewRectMin.X == 0.0f && P.ViewRectMinAndSize.Z == uint32(Rect.Width()));
	CALL("FViewUniformShaderParameters::ScreenPositionScaleBias",
		P.ScreenPositionScaleBias == FVector4f(0.5f, -0.5f, 0.5f, 0.5f));
	CALL("FViewUniformShaderParameters::OneOverPreExposure", P.OneOverPreExposure == 1.0f);
	CALL("FViewUniformShaderParameters::GameTime, RealTime, DeltaTime",
		P.GameTime >= 0.0f && P.RealTime >= 0.0f && P.DeltaTime >= 0.0f);
	CALL("FViewUniformShaderParameters::StateFrameIndexMod8, StateFrameIndex, FrameNumber",
		P.StateFrameIndexMod8 == P.StateFrameIndex % 8);
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	CALL("FSceneView::FinalPostProcessSettings", Settings.BloomIntensity == 0.675f);
	CALL("FPostProcessSettings::VignetteIntensity, SceneFringeIntensity, FilmGrainIntensity",
		Settings.VignetteIntensity == 0.4f && Settings.SceneFringeIntensity == 0.0f &&
			Settings.FilmGrainIntensity == 0.0f);
	CALL("FPostProcessSettings::AutoExposureBias, AutoExposureMethod", Settings.AutoExposureMethod >= 0);
	CALL("FPostProcessSettings::DepthOfFieldFocalDistance, DepthOfFieldFstop",
		Settings.DepthOfFieldFocalDistance == 0.0f && Settings.DepthOfFieldFstop == 4.0f);
	CALL("FPostProcessSettings::MotionBlurAmount, MotionBlurMax",
		Settings.MotionBlurAmount == 0.5f && Settings.MotionBlurMax == 5.0f);
	CALL("FPostProcessSettings::ColorSaturation, ColorContrast, ColorGamma, ColorGain, ColorOffset",
		FVector4f(Settings.ColorSaturation) == FVector4f(1, 1, 1, 1) &&
			FVector4f(Settings.ColorOffset) == FVector4f(0, 0, 0, 0));
	CALL("FPostProcessSettings::bOverride_BloomIntensity",
		[]
		{
			FPostProcessSettings S;
			S.bOverride_BloomIntensity = true;
			S.BloomIntensity = 2.0f;
			return S.bOverride_BloomIntensity;
		}());
	FBlendableEntry* Iterator = nullptr;
	CALL("FFinalPostProcessSettings::BlendableManager.IterateBlendables",
		Settings.BlendableManager.IterateBlendables<FCallsBlendable>(Iterator) == nullptr);
	CALL("FViewInfo::GetSceneTextures, GetSceneTexturesChecked",
		Info.GetSceneTextures().Config.Extent == Rect.Max &&
			&Info.GetSceneTexturesChecked() == &Info.GetSceneTextures());
	CALL("FSceneTextures::Color, Depth, GBufferA..F, Velocity, CustomDepth",
		Info.GetSceneTextures().Color.Target != nullptr);
	CALL("FViewInfo::ExponentialFogParameters, FogMaxOpacity, VolumetricFogResources",
		Info.ExponentialFogParameters.X == 0.0f &&
			Info.VolumetricFogResources.IntegratedLightScatteringTexture == nullptr);
	CALL("FViewInfo::HZB, HZBMipmap0Size", Info.HZB == nullptr && Info.HZBMipmap0Size == FIntPoint(0, 0));
	(void)GraphBuilder;
}

} // namespace

TEST(CallsOfViews, InAFrame)
{
	Calls::RunInFrame({.View = &CallView});
}

TEST(CallsOfViews, OutsideOfAFrame)
{
	FMinimalViewInfo ViewPoint;
	CALL("FMinimalViewInfo::Location, Rotation, FOV", ViewPoint.FOV == 90.0f && ViewPoint.Location == FVector(0, 0, 0));
	CALL("FMinimalViewInfo::PostProcessSettings",
		ViewPoint.PostProcessBlendWeight >= 0.0f && ViewPoint.PostProcessSettings.BloomIntensity == 0.675f);
	CALL("FMinimalViewInfo::AspectRatio, DesiredFOV", ViewPoint.AspectRatio > 1.0f && ViewPoint.DesiredFOV == 90.0f);
	FSceneViewProjectionData Projection;
	Projection.SetViewRectangle(FIntRect(0, 0, 4, 3));
	CALL("FSceneViewProjectionData",
		Projection.GetViewRect().Width() == 4 && Projection.GetConstrainedViewRect().Height() == 3);
	CALL("FSceneViewProjectionData::ViewOrigin, ViewRotationMatrix, ProjectionMatrix",
		Projection.ViewOrigin == FVector(0, 0, 0) && Projection.ViewRotationMatrix == FMatrix::Identity);
}
