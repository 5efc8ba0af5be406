// A screen pass with vertex shader and blend state over one half of the picture, on engine 5.5's side of the version
// switches.
#include "Modules/ModuleManager.h"
#include "PostProcess/PostProcessing.h"
#include "Runtime/Launch/Resources/Version.h"

#define HALFSCREEN_NEW_SUBSCRIBE (ENGINE_MAJOR_VERSION > 5 || (ENGINE_MAJOR_VERSION == 5 && ENGINE_MINOR_VERSION >= 5))

class FHalfScreenPS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FHalfScreenPS);
	SHADER_USE_PARAMETER_STRUCT(FHalfScreenPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureInput, Input)
		SHADER_PARAMETER(FVector3f, Color)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FHalfScreenPS, "/Plugin/HalfScreen/HalfScreen.usf", "MainPS", SF_Pixel);

class FHalfScreenExtension : public FSceneViewExtensionBase
{
public:
	FHalfScreenExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

#if HALFSCREEN_NEW_SUBSCRIBE
	virtual void SubscribeToPostProcessingPass(EPostProcessingPass Pass, const FSceneView& InView,
		FPostProcessingPassDelegateArray& InOutPassCallbacks, bool bIsPassEnabled) override
#else
	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled) override
#endif
	{
#if HALFSCREEN_NEW_SUBSCRIBE
		const EPostProcessingPass Wanted = EPostProcessingPass::BeforeDOF;
#else
		const EPostProcessingPass Wanted = EPostProcessingPass::MotionBlur;
#endif
		if (Pass == Wanted)
		{
			InOutPassCallbacks.Add(FPostProcessingPassDelegate::CreateRaw(this, &FHalfScreenExtension::Draw));
		}
	}

private:
	FScreenPassTexture Draw(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture SceneColor =
			FScreenPassTexture::CopyFromSlice(GraphBuilder, Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
		FRDGTextureDesc Desc = SceneColor.Texture->Desc;
		Desc.Reset();
		FScreenPassRenderTarget Output(
			GraphBuilder.CreateTexture(Desc, TEXT("HalfScreen")), SceneColor.ViewRect, ERenderTargetLoadAction::ELoad);
		AddCopyTexturePass(GraphBuilder, SceneColor.Texture, Output.Texture);

		// The right half, blended by its alpha of one half.
		FScreenPassTextureViewport RightHalf(Output);
		RightHalf.Rect.Min.X += RightHalf.Rect.Width() / 2;

		const FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(GMaxRHIFeatureLevel);
		TShaderMapRef<FScreenPassVS> VertexShader(ShaderMap);
		TShaderMapRef<FHalfScreenPS> PixelShader(ShaderMap);
		FHalfScreenPS::FParameters* Parameters = GraphBuilder.AllocParameters<FHalfScreenPS::FParameters>();
		Parameters->Input =
			GetScreenPassTextureInput(SceneColor, TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp>::GetRHI());
		Parameters->Color = FVector3f(0.0f, 0.0f, 4.0f);
		Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
		FRHIBlendState* Blend = TStaticBlendState<CW_RGBA, BO_Add, BF_SourceAlpha, BF_InverseSourceAlpha, BO_Add,
			BF_Zero, BF_One>::GetRHI();
		AddDrawScreenPass(GraphBuilder, RDG_EVENT_NAME("HalfScreen"), static_cast<const FViewInfo&>(View), RightHalf,
			RightHalf, VertexShader, PixelShader, Blend, Parameters);
		return Output;
	}
};

class FHalfScreenModule : public IModuleInterface
{
public:
	virtual void StartupModule() override { Extension = FSceneViewExtensions::NewExtension<FHalfScreenExtension>(); }

private:
	TSharedPtr<FHalfScreenExtension, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FHalfScreenModule, HalfScreen)
