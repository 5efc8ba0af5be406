// Before post-processing, with the scene textures: what lies far is fogged, what is toon-shaded is not.
#include "CoreMinimal.h"
#include "DataDrivenShaderPlatformInfo.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessInputs.h"
#include "SceneRenderTargetParameters.h"
#include "SceneRendering.h"
#include "SceneTexturesConfig.h"
#include "SceneViewExtension.h"
#include "SystemTextures.h"

class FDepthFogPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDepthFogPS)
	SHADER_USE_PARAMETER_STRUCT(FDepthFogPS, FGlobalShader)

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
		SHADER_PARAMETER(float, FogStart)
		SHADER_PARAMETER(FVector3f, FogColor)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()

	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters& Parameters)
	{
		return IsFeatureLevelSupported(Parameters.Platform, ERHIFeatureLevel::SM5);
	}
};

IMPLEMENT_GLOBAL_SHADER(FDepthFogPS, "/Plugin/DepthFog/DepthFog.usf", "MainPS", SF_Pixel)

class FDepthFogExtension : public FSceneViewExtensionBase
{
public:
	FDepthFogExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& InView, const FPostProcessingInputs& Inputs) override
	{
		if (!InView.bIsViewInfo || InView.bIsReflectionCapture)
		{
			return;
		}
		const FViewInfo& View = static_cast<const FViewInfo&>(InView);
		const FScreenPassTexture SceneColor((*Inputs.SceneTextures)->SceneColorTexture, View.ViewRect);
		FRDGTextureRef Fogged = GraphBuilder.CreateTexture(
			FRDGTextureDesc::Create2D(SceneColor.Texture->Desc.Extent, SceneColor.Texture->Desc.Format, {},
				TexCreate_RenderTargetable | TexCreate_ShaderResource),
			TEXT("Fogged"));

		FDepthFogPS::FParameters* Parameters = GraphBuilder.AllocParameters<FDepthFogPS::FParameters>();
		Parameters->View = View.ViewUniformBuffer;
		Parameters->SceneTextures = CreateSceneTextureShaderParameters(GraphBuilder, View,
			ESceneTextureSetupMode::SceneColor | ESceneTextureSetupMode::SceneDepth | ESceneTextureSetupMode::GBuffers);
		Parameters->FogStart = 5000.0f; // cm
		Parameters->FogColor = FVector3f(0.25f, 0.5f, 8.0f);
		Parameters->RenderTargets[0] = FRenderTargetBinding(Fogged, ERenderTargetLoadAction::ENoAction);
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap, RDG_EVENT_NAME("DepthFog"),
			TShaderMapRef<FDepthFogPS>(View.ShaderMap), Parameters, View.ViewRect);
		AddCopyTexturePass(GraphBuilder, Fogged, SceneColor.Texture);
	}
};

static TSharedPtr<FDepthFogExtension, ESPMode::ThreadSafe> GDepthFog =
	FSceneViewExtensions::NewExtension<FDepthFogExtension>();
