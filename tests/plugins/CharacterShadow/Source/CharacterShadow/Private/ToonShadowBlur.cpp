// Setup into 16 bits, blur, and back into eight. The frame has its shadow in a texture of its own.
#include "ToonShadowBlur.h"

#include "GaussianBlurPassRendering.h"
#include "Modules/ModuleManager.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessing.h"
#include "SceneRendering.h"
#include "SceneTextures.h"

BEGIN_SHADER_PARAMETER_STRUCT(FToonShadowParameters, )
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

#define TOON_SHADOW_SHADER(Name, Entry) \
	class Name : public FGlobalShader \
	{ \
	public: \
		DECLARE_GLOBAL_SHADER(Name); \
		SHADER_USE_PARAMETER_STRUCT(Name, FGlobalShader); \
		using FParameters = FToonShadowParameters; \
	}; \
	IMPLEMENT_GLOBAL_SHADER(Name, "/Plugin/CharacterShadow/ToonShadowBlur.usf", Entry, SF_Pixel);

TOON_SHADOW_SHADER(FShadowSetupPS, "ShadowSetupPS")
TOON_SHADOW_SHADER(FShadowCombinePS, "ShadowCombinePS")
TOON_SHADOW_SHADER(FShowShadowPS, "ShowShadowPS")

template<typename FShader>
static FScreenPassTexture AddShadowPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const TCHAR* Name,
	FScreenPassTexture Input, FScreenPassRenderTarget Output)
{
	FToonShadowParameters* PassParameters = GraphBuilder.AllocParameters<FToonShadowParameters>();
	PassParameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Input));
	PassParameters->InputTexture = Input.Texture;
	PassParameters->InputSampler = TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	TShaderMapRef<FShader> PixelShader(View.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(
		GraphBuilder, View.ShaderMap, RDG_EVENT_NAME("%s", Name), PixelShader, PassParameters, Output.ViewRect);
	return Output;
}

static FScreenPassRenderTarget CreateTarget(
	FRDGBuilder& GraphBuilder, FScreenPassTexture Like, EPixelFormat Format, const TCHAR* Name)
{
	const FRDGTextureDesc Desc = FRDGTextureDesc::Create2D(Like.Texture->Desc.Extent, Format, FClearValueBinding::Black,
		TexCreate_RenderTargetable | TexCreate_ShaderResource);
	return FScreenPassRenderTarget(
		GraphBuilder.CreateTexture(Desc, Name), Like.ViewRect, ERenderTargetLoadAction::ENoAction);
}

FScreenPassTexture AddToonMainLightShadowBlurPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, FScreenPassTexture SceneShadow)
{
	RDG_EVENT_SCOPE(GraphBuilder, "ToonShadowBlur");
	const FScreenPassTexture Wide = AddShadowPass<FShadowSetupPS>(GraphBuilder, View, TEXT("ShadowSetup"), SceneShadow,
		CreateTarget(GraphBuilder, SceneShadow, PF_R16F, TEXT("ToonShadow16")));
	const TArray<FGaussianBlurStage> Stages = {{1.0f, FLinearColor(0.3465f, 0.3465f, 0.3465f)},
		{2.0f, FLinearColor(0.138f, 0.138f, 0.138f)}, {4.0f, FLinearColor(0.1176f, 0.1176f, 0.1176f)}};
	const FScreenPassTexture Blurred = AddTextureBlurPass(GraphBuilder, View, Wide, Stages);
	return AddShadowPass<FShadowCombinePS>(GraphBuilder, View, TEXT("ShadowCombine"), Blurred,
		CreateTarget(GraphBuilder, SceneShadow, PF_B8G8R8A8, TEXT("BlurredToonShadow")));
}

FScreenPassTexture AddShowShadowPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, FScreenPassTexture Shadow, FScreenPassRenderTarget Output)
{
	return AddShadowPass<FShowShadowPS>(GraphBuilder, View, TEXT("ShowShadow"), Shadow, Output);
}

class FCharacterShadowExtension : public FSceneViewExtensionBase
{
public:
	FCharacterShadowExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& InView, const FPostProcessingInputs& Inputs) override
	{
		const FViewInfo& View = static_cast<const FViewInfo&>(InView);
		const FRDGTextureRef SceneShadow = View.GetSceneTextures().FindNamed(TEXT("CharacterShadow"));
		if (SceneShadow == nullptr)
		{
			return;
		}
		const FScreenPassTexture Shadow =
			AddToonMainLightShadowBlurPass(GraphBuilder, View, FScreenPassTexture(SceneShadow, View.ViewRect));
		AddShowShadowPass(GraphBuilder, View, Shadow,
			FScreenPassRenderTarget(
				(*Inputs.SceneTextures)->SceneColorTexture, View.ViewRect, ERenderTargetLoadAction::ELoad));
	}
};

class FCharacterShadowModule : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
		Extension = FSceneViewExtensions::NewExtension<FCharacterShadowExtension>();
	}

private:
	TSharedPtr<FCharacterShadowExtension, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FCharacterShadowModule, CharacterShadow)
