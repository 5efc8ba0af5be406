// Headers under their whole paths give what the short ones give: no header is included here by its short name.
#include "Runtime/Engine/Classes/Engine/TextureRenderTarget2D.h"
#include "Runtime/Engine/Public/SceneViewExtension.h"
#include "Runtime/Launch/Resources/Version.h"
#include "Runtime/RenderCore/Public/PixelShaderUtils.h"
#include "Runtime/Renderer/Internal/PostProcess/PostProcessInputs.h"
#include "Runtime/Renderer/Private/SceneRendering.h"
#include "Runtime/Renderer/Public/ScreenPass.h"

static_assert(sizeof(UTextureRenderTarget2D) > 0 && sizeof(FSceneViewExtensionBase) > 0 &&
			  sizeof(FPixelShaderUtils) > 0 && sizeof(FPostProcessingInputs) > 0 && sizeof(FViewInfo) > 0 &&
			  sizeof(FScreenPassTexture) > 0 && ENGINE_MAJOR_VERSION == 5);
