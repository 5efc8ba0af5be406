// Initial contents of a view. Source: engine file SceneView.cpp.
#include "SceneView.h"

IMPLEMENT_GLOBAL_SHADER_PARAMETER_STRUCT(FViewUniformShaderParameters, "View");

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
