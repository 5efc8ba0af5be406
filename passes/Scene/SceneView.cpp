// Initial contents of a view. Source: engine file SceneView.cpp.
#include "SceneView.h"

#include "UnrealClient.h"

IMPLEMENT_GLOBAL_SHADER_PARAMETER_STRUCT(FViewUniformShaderParameters, "View");

FRDGTextureRef TryCreateViewFamilyTexture(FRDGBuilder& GraphBuilder, const FSceneViewFamily& ViewFamily)
{
	return ViewFamily.RenderTarget ? ViewFamily.RenderTarget->GetRenderTargetTexture(GraphBuilder) : nullptr;
}

const ISceneViewFamilyScreenPercentage* FSceneViewFamily::GetScreenPercentageInterface() const
{
	static const ISceneViewFamilyScreenPercentage FullResolution;
	return &FullResolution;
}

ERenderTargetLoadAction FSceneView::GetOverwriteLoadAction() const
{
	const bool bFirst = !Family || Family->Views.Num() == 0 || Family->Views[0] == this;
	return bFirst ? ERenderTargetLoadAction::ENoAction : ERenderTargetLoadAction::ELoad;
}
