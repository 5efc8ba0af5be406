// The post-processing chain: builds the passes of the effects that were decided on (EffectDecisions.h).
// Source: engine PostProcess/PostProcessing.h.
#pragma once

#include "PostProcess/EffectDecisions.h"
#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "ScreenPass.h"

#include <vector>

class FRDGBuilder;

struct FPostProcessingChainInputs
{
	/** [Required] Linear, pre-exposed; its rect is the view's. */
	FScreenPassTexture SceneColor;
	/** Exposure times what scene colour would be without pre-exposure gives display-referred linear. */
	float ExposureScale = 1.0f;
};

struct FPostProcessingChainOutputs
{
	/** What the tonemapper reads, bloom apart. */
	FScreenPassTexture SceneLinear;
	/** The display-encoded picture. */
	FScreenPassTexture Final;
};

/** Builds the passes of the effects that are active in Effects. View.FinalPostProcessSettings holds the settings. */
DRYDOCK_API FPostProcessingChainOutputs AddPostProcessingPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FPostProcessingChainInputs& Inputs, const std::vector<Drydock::FEffectDecision>& Effects);
