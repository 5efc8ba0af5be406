// The post-processing chain: builds the passes of the effects that were decided on (Effects.h), in the engine's
// order, and calls view extensions at its insertion points. Source: engine PostProcess/PostProcessing.h.
#pragma once

#include "Effects/Effect.h"
#include "Extensions/ViewExtensions.h"
#include "PostProcess/PostProcessing.h"

#include <vector>

class FRDGBuilder;

/** The inputs of one view's chain. */
struct FPostProcessingChainInputs
{
	/** [Required] Linear, pre-exposed; its rect is the view's. */
	FScreenPassTexture SceneColor;
	/** [Required] Where the display-encoded picture goes, at View.UnscaledViewRect. */
	FRDGTextureRef ViewFamilyTexture = nullptr;
	/** Exposure times what scene colour would be without pre-exposure gives display-referred linear. */
	float ExposureScale = 1.0f;
	/** The settings expose in its place. */
	bool bAutoExposure = false;
	/** Null if scene textures are not read. */
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;
	/** Colour of the main light, relative, for ToonShadowBlur. */
	FLinearColor LightColor = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);
};

struct FPostProcessingChainOutputs
{
	/** The scene colour that the tonemapper reads, without bloom. */
	FScreenPassTexture SceneLinear;
	/** The display-encoded picture: ViewFamilyTexture. */
	FScreenPassTexture Final;
	/** The bloom that the tonemapper adds; not valid without bloom. */
	FScreenPassTexture Bloom;
	/** The histogram that the exposure was metered with; null where there is none. */
	FRDGTextureRef Histogram = nullptr;
	/** The textures that effects can be measured on: those that effects kept, and "Bloom". */
	Drydock::FKeptTextures Kept;
};

/** Builds the passes of the effects that are active in Effects. View.FinalPostProcessSettings holds the settings. */
DRYDOCK_API FPostProcessingChainOutputs AddPostProcessingPasses(FRDGBuilder& GraphBuilder,
	const Drydock::FNamedView& NamedView, const FPostProcessingChainInputs& Inputs,
	const std::vector<Drydock::FEffectDecision>& Effects, Drydock::FViewExtensionFrame& Extensions);
