// Holds the inputs of post-processing, as PrePostProcessPass_RenderThread sees it. Source: engine file
// PostProcess/PostProcessInputs.h.
#pragma once

#include "CoreMinimal.h"
#include "SceneTextureParameters.h"

struct FPostProcessingInputs
{
	/** (*SceneTextures)->SceneColorTexture is the picture: linear, pre-exposed, to be edited in place. */
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;

	/** The frame's display-encoded output, of all its views. */
	FRDGTextureRef ViewFamilyTexture = nullptr;
	FRDGTextureRef CustomDepthTexture = nullptr;
	bool bSeparateCustomStencil = false;

	void Validate() const
	{
		check(SceneTextures);
		check(ViewFamilyTexture);
	}
};
