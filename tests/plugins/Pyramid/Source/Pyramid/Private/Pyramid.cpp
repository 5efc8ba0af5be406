// Scaled buffers: a pyramid of halves downwards, then back to full size in one step, blocky. An actor of the world
// keeps how deep it goes.
#include "CoreMinimal.h"
#include "EngineUtils.h"
#include "GameFramework/Actor.h"
#include "Modules/ModuleManager.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "Renderer/Private/ScreenPass.h"
#include "Runtime/RenderCore/Public/PixelShaderUtils.h"
#include "SceneViewExtension.h"

class UPyramidComponent : public UActorComponent
{
public:
	int32 Levels = 0;
	virtual void BeginPlay() override { Levels = 2; }
};

class APyramidActor : public AActor
{
public:
	APyramidActor() { Component = CreateDefaultSubobject<UPyramidComponent>(TEXT("Pyramid")); }
	UPyramidComponent* Component;
};

namespace PyramidShaders
{

class FDownPS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FDownPS);
	SHADER_USE_PARAMETER_STRUCT(FDownPS, FGlobalShader);
	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureInput, Input)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};
IMPLEMENT_GLOBAL_SHADER(FDownPS, "/Plugin/Pyramid/Pyramid.usf", "DownPS", SF_Pixel);

class FUpPS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FUpPS);
	SHADER_USE_PARAMETER_STRUCT(FUpPS, FGlobalShader);
	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
		SHADER_PARAMETER(FScreenTransform, SvPositionToInputTextureUV)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};
IMPLEMENT_GLOBAL_SHADER(FUpPS, "/Plugin/Pyramid/Pyramid.usf", "UpPS", SF_Pixel);

} // namespace PyramidShaders

class FPyramidExtension : public FSceneViewExtensionBase
{
public:
	FPyramidExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void BeginRenderViewFamily(FSceneViewFamily& InViewFamily) override
	{
		for (TActorIterator<APyramidActor> It(InViewFamily.Scene->GetWorld()); It; ++It)
		{
			NumLevels = It->Component->Levels;
		}
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FPyramidExtension::Run));
		}
	}

private:
	FScreenPassTexture Run(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		RDG_EVENT_SCOPE(GraphBuilder, "Pyramid of %d", NumLevels);
		const FScreenPassTexture SceneColor = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
		FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(View.GetFeatureLevel());
		FRHISamplerState* Bilinear = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();

		FScreenPassTexture Current = SceneColor;
		for (int32 Level = 1; Level <= NumLevels; ++Level)
		{
			const FScreenPassTextureViewport Half =
				GetDownscaledViewport(FScreenPassTextureViewport(Current), FIntPoint(2, 2));
			FRDGTextureDesc Desc = Current.Texture->Desc;
			Desc.Reset();
			Desc.Extent = Half.Extent;
			const FString Name = FString::Printf(TEXT("Pyramid%d"), Level);
			FRDGTextureRef Texture = GraphBuilder.CreateTexture(Desc, Level == 1 ? TEXT("Pyramid1") : TEXT("Pyramid2"));
			auto* Parameters = GraphBuilder.AllocParameters<PyramidShaders::FDownPS::FParameters>();
			Parameters->Input = GetScreenPassTextureInput(Current, Bilinear);
			Parameters->RenderTargets[0] = FRenderTargetBinding(Texture, ERenderTargetLoadAction::ENoAction);
			AddDrawScreenPass(GraphBuilder, RDG_EVENT_NAME("Down %s", *Name), View, Half,
				FScreenPassTextureViewport(Current), TShaderMapRef<PyramidShaders::FDownPS>(ShaderMap), Parameters);
			Current = FScreenPassTexture(Texture, Half.Rect);
		}

		FScreenPassRenderTarget Output = FScreenPassRenderTarget::CreateFromInput(
			GraphBuilder, SceneColor, View.GetOverwriteLoadAction(), TEXT("PyramidOutput"));
		auto* Parameters = GraphBuilder.AllocParameters<PyramidShaders::FUpPS::FParameters>();
		Parameters->InputTexture = Current.Texture;
		Parameters->InputSampler = TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
		Parameters->SvPositionToInputTextureUV =
			FScreenTransform::ChangeTextureBasisFromTo(FScreenPassTextureViewport(Output),
				FScreenTransform::ETextureBasis::TexelPosition, FScreenTransform::ETextureBasis::ViewportUV) *
			FScreenTransform::ChangeTextureBasisFromTo(FScreenPassTextureViewport(Current),
				FScreenTransform::ETextureBasis::ViewportUV, FScreenTransform::ETextureBasis::TextureUV);
		Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, ShaderMap, RDG_EVENT_NAME("Up"),
			TShaderMapRef<PyramidShaders::FUpPS>(ShaderMap), Parameters, Output.ViewRect);
		return MoveTemp(Output);
	}

	int32 NumLevels = 0;
};

class FPyramidModule : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
		Extension = FSceneViewExtensions::NewExtension<FPyramidExtension>();
		Actor = GWorld->SpawnActor<APyramidActor>();
	}
	virtual void ShutdownModule() override { Actor->Destroy(); }

private:
	TSharedPtr<FPyramidExtension, ESPMode::ThreadSafe> Extension;
	APyramidActor* Actor = nullptr;
};
IMPLEMENT_MODULE(FPyramidModule, Pyramid)
