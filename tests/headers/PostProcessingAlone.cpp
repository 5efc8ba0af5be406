// PostProcess/PostProcessing.h alone gives the renderer's view, global shaders and compute passes complete.
#include "PostProcess/PostProcessing.h"

static_assert(sizeof(FViewInfo) > sizeof(FSceneView) && sizeof(FGlobalShader) > 0 && sizeof(FComputeShaderUtils) > 0);

FIntVector CountGroups(const FViewInfo& View)
{
	return FComputeShaderUtils::GetGroupCount(View.ViewRect.Size(), FComputeShaderUtils::kGolden2DGroupSize);
}
