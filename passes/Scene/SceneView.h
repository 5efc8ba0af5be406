// The view as passes and plugins see it: family, view, the renderer's view (FViewInfo in SceneRendering.h derives it)
// and the View uniform buffer. Filled by pipeline/. Source: engine file SceneView.h (the part that post-processing
// reads).
#pragma once

#include "CoreMinimal.h"
#include "DynamicResolutionState.h"
#include "GlobalShader.h"
#include "PostProcessSettings.h"
#include "RHI.h"
#include "SceneInterface.h"
#include "ScreenPass.h"
#include "ShaderParameterMacros.h"
#include "ShowFlags.h"
#include "UniformBuffer.h"
#include "ViewMatrices.h"

class AActor;
class FRenderTarget;
class FSceneView;
class FViewInfo; // SceneRendering.h
class ISceneViewExtension;

/** The members that shaders read as View.X. Lengths in centimetres, times in seconds, rects and extents in pixels. */
BEGIN_GLOBAL_SHADER_PARAMETER_STRUCT(FViewUniformShaderParameters, DRYDOCK_API)
	SHADER_PARAMETER(FMatrix44f, TranslatedWorldToClip)
	SHADER_PARAMETER(FMatrix44f, TranslatedWorldToView)
	SHADER_PARAMETER(FMatrix44f, ViewToTranslatedWorld)
	SHADER_PARAMETER(FMatrix44f, ViewToClip)
	SHADER_PARAMETER(FMatrix44f, ClipToView)
	SHADER_PARAMETER(FMatrix44f, ClipToTranslatedWorld)
	SHADER_PARAMETER(FMatrix44f, SVPositionToTranslatedWorld)
	SHADER_PARAMETER(FMatrix44f, ScreenToWorld)
	SHADER_PARAMETER(FMatrix44f, ScreenToTranslatedWorld)
	SHADER_PARAMETER(FMatrix44f, ClipToPrevClip)
	SHADER_PARAMETER(FMatrix44f, WorldToClip)
	SHADER_PARAMETER(FMatrix44f, ClipToWorld)
	SHADER_PARAMETER(FMatrix44f, ViewToWorld)
	SHADER_PARAMETER(FMatrix44f, WorldToView)
	SHADER_PARAMETER(FMatrix44f, PrevTranslatedWorldToClip) // of last frame's translated world, as all Prev members
	SHADER_PARAMETER(FMatrix44f, PrevTranslatedWorldToView)
	SHADER_PARAMETER(FMatrix44f, PrevViewToClip)
	SHADER_PARAMETER(FVector3f, ViewForward)
	SHADER_PARAMETER(FVector3f, ViewUp)
	SHADER_PARAMETER(FVector3f, ViewRight)
	SHADER_PARAMETER(FVector3f, WorldCameraOrigin)
	SHADER_PARAMETER(FVector3f, TranslatedWorldCameraOrigin)
	SHADER_PARAMETER(FVector3f, PreViewTranslation)
	SHADER_PARAMETER(FVector3f, PrevPreViewTranslation)
	SHADER_PARAMETER(FVector3f, PrevWorldCameraOrigin)
	SHADER_PARAMETER(FVector3f, RelativeWorldCameraOrigin) // to the tile, which is the world: scenes here are small
	SHADER_PARAMETER(FVector3f, WorldViewOriginHigh)       // the same, as the greater of two floats
	SHADER_PARAMETER(FVector3f, WorldViewOriginLow)
	SHADER_PARAMETER(FVector3f, ViewTilePosition)
	SHADER_PARAMETER(FVector4f, InvDeviceZToWorldZTransform)
	SHADER_PARAMETER(FVector4f, ScreenPositionScaleBias)
	SHADER_PARAMETER(FVector4f, ViewRectMin)        // xy min of the rect
	SHADER_PARAMETER(FVector4f, ViewSizeAndInvSize) // xy size of the rect, zw inverse
	SHADER_PARAMETER(FUintVector4, ViewRectMinAndSize)
	SHADER_PARAMETER(FVector4f, BufferSizeAndInvSize)   // xy extent of the scene textures, zw inverse
	SHADER_PARAMETER(FVector4f, BufferBilinearUVMinMax) // xy min, zw max: half a texel inside the rect
	SHADER_PARAMETER(FVector4f, TemporalAAJitter)
	SHADER_PARAMETER(FVector4f, FieldOfViewWideAngles)
	SHADER_PARAMETER(float, PreExposure)
	SHADER_PARAMETER(float, OneOverPreExposure)
	SHADER_PARAMETER(float, NearPlane)
	SHADER_PARAMETER(float, GameTime)
	SHADER_PARAMETER(float, RealTime)
	SHADER_PARAMETER(float, DeltaTime)
	SHADER_PARAMETER(uint32, FrameNumber)
	SHADER_PARAMETER(uint32, StateFrameIndex)
	SHADER_PARAMETER(uint32, StateFrameIndexMod8)
	// Neutral where a scene of drydock has nothing to say: no light, no fog, no cursor.
	SHADER_PARAMETER(FVector4f, TemporalAAParams) // x sample, y samples, zw jitter in pixels
	SHADER_PARAMETER(FVector3f, DirectionalLightDirection)
	SHADER_PARAMETER(FLinearColor, DirectionalLightColor)
	SHADER_PARAMETER_ARRAY(FVector4f, AtmosphereLightDirection, [2])
	SHADER_PARAMETER(FVector3f, VolumetricFogGridZParams)
	SHADER_PARAMETER(FVector3f, VolumetricFogInvGridSize)
	SHADER_PARAMETER(FVector2f, VolumetricFogSVPosToVolumeUV)
	SHADER_PARAMETER(float, VolumetricFogMaxDistance)
	SHADER_PARAMETER(float, MaterialTextureMipBias)
	SHADER_PARAMETER(float, MaterialTextureDerivativeMultiply)
	SHADER_PARAMETER(float, GeneralPurposeTweak)
	SHADER_PARAMETER(float, GeneralPurposeTweak2)
	SHADER_PARAMETER(float, PrevGameTime)
	SHADER_PARAMETER(float, PrevFrameGameTime)
	SHADER_PARAMETER(float, PrevFrameRealTime)
	SHADER_PARAMETER(float, CullingSign)
	SHADER_PARAMETER(float, CameraCut) // 1 on a view's first frame
	SHADER_PARAMETER(uint32, Random)   // another every frame
	SHADER_PARAMETER(FIntPoint, CursorPosition)
	SHADER_PARAMETER_SAMPLER(SamplerState, SharedPointWrappedSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, SharedPointClampedSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, SharedBilinearWrappedSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, SharedBilinearClampedSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, SharedTrilinearWrappedSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, SharedTrilinearClampedSampler)
END_GLOBAL_SHADER_PARAMETER_STRUCT()

/** Time of a frame, in seconds. */
struct FGameTime
{
	float RealTimeSeconds = 0.0f;
	float WorldTimeSeconds = 0.0f;
	float DeltaRealTimeSeconds = 0.0f;
	float DeltaWorldTimeSeconds = 0.0f;

	float GetRealTimeSeconds() const { return RealTimeSeconds; }
	float GetWorldTimeSeconds() const { return WorldTimeSeconds; }
	float GetDeltaRealTimeSeconds() const { return DeltaRealTimeSeconds; }
	float GetDeltaWorldTimeSeconds() const { return DeltaWorldTimeSeconds; }
};

/** The state of a view that persists from frame to frame; pipeline/ derives it. */
class FSceneViewStateInterface
{
public:
	virtual ~FSceneViewStateInterface() = default;

	virtual uint32 GetViewKey() const = 0;
	virtual float GetLastEyeAdaptationExposure() const { return 0.0f; }
};

/** The pictures that a capture of the scene may take. Source: engine file Engine/EngineTypes.h. */
enum ESceneCaptureSource : int
{
	SCS_SceneColorHDR,
	SCS_SceneColorHDRNoAlpha,
	SCS_FinalColorLDR,
	SCS_SceneColorSceneDepth,
	SCS_SceneDepth,
	SCS_DeviceDepth,
	SCS_Normal,
	SCS_BaseColor,
	SCS_FinalColorHDR,
	SCS_FinalToneCurveHDR,
	SCS_MAX
};

/** Views that are rendered together. */
class FSceneViewFamily
{
public:
	/** Not owned. */
	TArray<const FSceneView*> Views;
	/** Target of the final picture; null outside of a frame. */
	const FRenderTarget* RenderTarget = nullptr;
	FEngineShowFlags EngineShowFlags;
	/** The world's, in a frame. */
	FSceneInterface* Scene = nullptr;
	FGameTime Time;
	uint32 FrameNumber = 0;
	uint64 FrameCounter = 0;
	bool bIsHDR = false;
	bool bIsMainViewFamily = true;
	bool bResolveScene = true;
	/** Active extensions in calling order. */
	TArray<TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>> ViewExtensions;
	float SecondaryViewFraction = 1.0f;
	/** For captures, of which there are none. */
	ESceneCaptureSource SceneCaptureSource = SCS_FinalToneCurveHDR;

	ERHIFeatureLevel::Type GetFeatureLevel() const { return GMaxRHIFeatureLevel; }
	EShaderPlatform GetShaderPlatform() const { return GMaxRHIShaderPlatform; }
	/** Never null; every fraction is 1. */
	DRYDOCK_API const ISceneViewFamilyScreenPercentage* GetScreenPercentageInterface() const;
};

/** The final picture in a graph, View.Family->RenderTarget; null where there is none. */
DRYDOCK_API FRDGTextureRef TryCreateViewFamilyTexture(FRDGBuilder& GraphBuilder, const FSceneViewFamily& ViewFamily);

/** Position and projection of a view before it is made. */
struct FSceneViewProjectionData
{
	FVector ViewOrigin = FVector(0.0, 0.0, 0.0); // cm
	FMatrix ViewRotationMatrix = FMatrix::Identity;
	FMatrix ProjectionMatrix = FMatrix::Identity;

	void SetViewRectangle(const FIntRect& InViewRect)
	{
		ViewRect = InViewRect;
		ConstrainedViewRect = InViewRect;
	}
	const FIntRect& GetViewRect() const { return ViewRect; }
	const FIntRect& GetConstrainedViewRect() const { return ConstrainedViewRect; }

private:
	FIntRect ViewRect;
	FIntRect ConstrainedViewRect;
};

enum EAntiAliasingMethod : int32
{
	AAM_None = 0,
	AAM_FXAA = 1,
	AAM_TemporalAA = 2,
	AAM_MSAA = 3,
	AAM_TSR = 4,
	AAM_SMAA = 5, // 5.7
	AAM_MAX = 6,
};

/** One camera's picture of the scene. */
class FSceneView
{
public:
	const FSceneViewFamily* Family = nullptr;
	FSceneViewStateInterface* State = nullptr;

	/** Final settings after defaults, volumes, camera and clamps. */
	FFinalPostProcessSettings FinalPostProcessSettings;

	/** Null until the renderer has set the view up (FViewInfo::InitViewUniformBuffer). */
	TUniformBufferRef<FViewUniformShaderParameters> ViewUniformBuffer;

	/** Rects in pixels of the family's output, before the screen percentage. */
	FIntRect UnconstrainedViewRect;
	FIntRect UnscaledViewRect;

	/** The camera: place in cm, turn in degrees, horizontal angle of view in degrees. */
	FVector ViewLocation = FVector(0.0, 0.0, 0.0);
	FRotator ViewRotation = FRotator(0.0, 0.0, 0.0);
	float FOV = 90.0f;
	float DesiredFOV = 90.0f;

	/** The camera's matrices. Changes that code makes in SetupView, such as a jitter, reach the View
	 * uniform buffer. */
	FViewMatrices ViewMatrices;

	/** Who looks: nobody here. */
	const AActor* ViewActor = nullptr;
	int32 PlayerIndex = INDEX_NONE;
	/** The index of an eye's view: there are none. */
	int32 StereoViewIndex = INDEX_NONE;

	/** The camera's fade, after the film curve, on display-linear light: the picture times ColorScale, then blended
	 * with OverlayColor by its alpha. */
	FLinearColor ColorScale = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);
	FLinearColor OverlayColor = FLinearColor(0.0f, 0.0f, 0.0f, 0.0f);

	EAntiAliasingMethod AntiAliasingMethod = AAM_None;
	ERHIFeatureLevel::Type FeatureLevel = GMaxRHIFeatureLevel;

	bool bIsViewInfo = false;
	bool bIsGameView = true;
	bool bIsSceneCapture = false;
	bool bIsSceneCaptureCube = false;
	bool bIsOfflineRender = false;
	bool bIsReflectionCapture = false;
	bool bIsPlanarReflection = false;
	bool bIsVirtualTexture = false;
	bool bCameraCut = false;

	virtual ~FSceneView() = default;

	ERHIFeatureLevel::Type GetFeatureLevel() const { return FeatureLevel; }
	EShaderPlatform GetShaderPlatform() const { return GMaxRHIShaderPlatform; }

	/** Directions of the world, of length 1. */
	FVector GetViewRight() const { return ViewMatrices.GetViewMatrix().GetColumn(0); }
	FVector GetViewUp() const { return ViewMatrices.GetViewMatrix().GetColumn(1); }
	FVector GetViewDirection() const { return ViewMatrices.GetViewMatrix().GetColumn(2); }
	bool IsPerspectiveProjection() const { return ViewMatrices.IsPerspectiveProjection(); }
	/** 0 without a state. */
	uint32 GetViewKey() const { return State != nullptr ? State->GetViewKey() : 0; }
	/** The exposure scale that the frame before adapted to; 0 where there is none, as in the engine. */
	float GetLastEyeAdaptationExposure() const
	{
		return State != nullptr ? State->GetLastEyeAdaptationExposure() : 0.0f;
	}

	/** Views after the first of a family must keep what those before them drew. */
	DRYDOCK_API ERenderTargetLoadAction GetOverwriteLoadAction() const;
};
