// The renderer's view: a view with its rect in the scene textures, its shader map and its uniform buffer.
// Source: engine file SceneRendering.h (the part that post-processing reads).
#pragma once

#include "CoreMinimal.h"
#include "EngineProfile.h"
#include "SceneTextures.h"
#include "SceneView.h"

class FSceneViewState;

/** The textures of volumetric fog: none here. */
struct FVolumetricFogViewResources
{
	FRDGTextureRef IntegratedLightScatteringTexture = nullptr;
};

/** A view as the frame before had it. Source: engine file ScenePrivate.h. */
struct FPreviousViewInfo
{
	FIntRect ViewRect;
	FViewMatrices ViewMatrices;
	float SceneColorPreExposure = 1.0f; // that the frame before stored its colours with
};

/** A family and its scene textures: each family of a frame is one. */
class FViewFamilyInfo : public FSceneViewFamily
{
public:
	FViewFamilyInfo() = default;
	explicit FViewFamilyInfo(const FSceneViewFamily& InViewFamily)
		: FSceneViewFamily(InViewFamily)
	{
	}

	FSceneTexturesConfig SceneTexturesConfig;

	/** Null until the frame's graph is built; drydock fills it. */
	const FSceneTextures* SceneTextures = nullptr;

	/** A check before the frame's graph is built. */
	const FSceneTextures& GetSceneTextures() const
	{
		checkf(SceneTextures, TEXT("The scene textures are there once the frame's graph is built"));
		return *SceneTextures;
	}
	const FSceneTextures* GetSceneTexturesChecked() const { return &GetSceneTextures(); }
};

class FViewInfo : public FSceneView
{
public:
	/** Pixels of the scene textures that this view covers. */
	FIntRect ViewRect;
	FGlobalShaderMap* ShaderMap = nullptr;

	/** Scene colour is stored multiplied by this. Above 0 and finite. */
	float PreExposure = 1.0f;

	/** Compute entries in place of pixel shaders (r.PostProcessing.PreferCompute). */
	bool bUseComputePasses = false;

	/** The differences between engine versions: the row of the frame's version. */
	Drydock::FEngineProfile EngineProfile = Drydock::GetDefaultEngineProfile();

	/** The frame before; this frame itself where there was none. */
	FPreviousViewInfo PrevViewInfo;

	/** Pixels by which the projection is jittered. */
	FVector2D TemporalJitterPixels = FVector2D(0.0, 0.0);

	/** The contents of ViewUniformBuffer; null before InitViewUniformBuffer. */
	TSharedPtr<FViewUniformShaderParameters> CachedViewUniformShaderParameters;

	/** Camera matrices and times to start InitViewUniformBuffer from; pipeline/ fills them, defaults are neutral. */
	FViewUniformShaderParameters UniformParameters;

	/** State as the renderer sees it: what the frame before left, what the next one will find (SceneViewState.h). Null
	 * where nothing lives on. */
	FSceneViewState* ViewState = nullptr;

	/** The scene textures of the frame in progress, or null. */
	const FSceneTextures* SceneTextures = nullptr;

	/** Height fog of density 0: the engine's members, for plugins that pass them on. Lengths in cm. */
	FVector4f ExponentialFogParameters = FVector4f(0.0f, 0.0f, 0.0f, 0.0f);
	FVector4f ExponentialFogParameters2 = FVector4f(0.0f, 0.0f, 0.0f, 0.0f);
	FVector4f ExponentialFogParameters3 = FVector4f(0.0f, 0.0f, 0.0f, 0.0f);
	FVector3f ExponentialFogColor = FVector3f(0.0f, 0.0f, 0.0f);
	float FogMaxOpacity = 1.0f;
	float VolumetricFogStartDistance = 0.0f;
	FVolumetricFogViewResources VolumetricFogResources;

	/** Hierarchical depth: none is built. */
	FRDGTextureRef HZB = nullptr;
	FIntPoint HZBMipmap0Size = FIntPoint::ZeroValue;

	DRYDOCK_API FViewInfo();

	/** A view of Rect with neutral camera, settings at their defaults and a built uniform buffer: all that a pass
	 * needs. BufferExtent: extent of the scene textures, at least Rect.Max. */
	DRYDOCK_API FViewInfo(
		const FSceneViewFamily* InFamily, const FIntRect& Rect, FIntPoint BufferExtent, float InPreExposure = 1.0f);

	/** Derives rects, sizes, exposure and samplers from this view's members and creates ViewUniformBuffer. Call it
	 * after ViewRect, PreExposure and UniformParameters are final. */
	DRYDOCK_API void InitViewUniformBuffer(FIntPoint BufferExtent);

	/** The family's output size for this view, in pixels. */
	FIntPoint GetSecondaryViewRectSize() const
	{
		const float Fraction = Family != nullptr ? Family->SecondaryViewFraction : 1.0f;
		return FIntPoint(FMath::CeilToInt(static_cast<float>(UnscaledViewRect.Width()) * Fraction),
			FMath::CeilToInt(static_cast<float>(UnscaledViewRect.Height()) * Fraction));
	}

	const FSceneTextures& GetSceneTextures() const { return GetSceneTexturesChecked(); }
	const FSceneTextures& GetSceneTexturesChecked() const
	{
		check(SceneTextures);
		return *SceneTextures;
	}
};
