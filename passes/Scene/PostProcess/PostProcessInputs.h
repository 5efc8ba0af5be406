// Holds the inputs of post-processing, as PrePostProcessPass_RenderThread sees it. Source: engine file
// PostProcess/PostProcessInputs.h.
#pragma once

#include "CoreMinimal.h"
#include "RenderGraphUtils.h"
#include "SceneTextureParameters.h"

/** When translucent objects are drawn. */
namespace ETranslucencyPass
{
enum Type : int
{
	TPT_TranslucencyStandard,
	TPT_TranslucencyStandardModulate,
	TPT_TranslucencyAfterDOF,
	TPT_TranslucencyAfterDOFModulate,
	TPT_TranslucencyAfterMotionBlur,
	TPT_AllTranslucency,
	TPT_MAX
};
}

/** The targets of translucent objects, apart from the scene colour. */
struct FTranslucencyPassResources
{
	FIntRect ViewRect;
	FRDGTextureMSAA ColorTexture;
	FRDGTextureMSAA ColorModulateTexture;
	FRDGTextureMSAA DepthTexture;

	bool IsValid() const { return ViewRect.Width() > 0 && ViewRect.Height() > 0; }
};

/** Not valid for any pass: a scene file has its translucent objects in the scene colour. */
struct FTranslucencyViewResourcesMap
{
	FTranslucencyPassResources Get(ETranslucencyPass::Type) const { return {}; }
};

struct FPostProcessingInputs
{
	/** (*SceneTextures)->SceneColorTexture is the picture: linear, pre-exposed, to be edited in place. */
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;

	/** The frame's display-encoded output, of all its views. */
	FRDGTextureRef ViewFamilyTexture = nullptr;
	FTranslucencyViewResourcesMap TranslucencyViewResourcesMap;
	FRDGTextureRef CustomDepthTexture = nullptr;
	bool bSeparateCustomStencil = false;

	void Validate() const
	{
		check(SceneTextures);
		check(ViewFamilyTexture);
	}
};
