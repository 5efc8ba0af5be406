// An engine subsystem that makes the extension; a raster lambda that names every state by hand and adds light to the
// scene colour in place.
#include "AddLightSubsystem.h"

#include "CommonRenderResources.h"
#include "Engine/Engine.h"
#include "PipelineStateCache.h"
#include "PostProcess/PostProcessInputs.h"
#include "SceneRendering.h"
#include "SceneTextureParameters.h"
#include "SceneViewExtension.h"
#include "ScreenRendering.h"

#include UE_INLINE_GENERATED_CPP_BY_NAME(AddLightSubsystem)

class FAddLightPS : public FGlobalShader
{
	DECLARE_SHADER_TYPE(FAddLightPS, Global);
	SHADER_USE_PARAMETER_STRUCT(FAddLightPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FLinearColor, Light)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};
IMPLEMENT_SHADER_TYPE(, FAddLightPS, TEXT("/Plugin/AddLight/Private/AddLight.usf"), TEXT("AddLightPS"), SF_Pixel);

class FAddLightExtension : public FSceneViewExtensionBase
{
public:
	FAddLightExtension(const FAutoRegister& AutoRegister, const UAddLightSubsystem* InSubsystem)
		: FSceneViewExtensionBase(AutoRegister)
		, Subsystem(InSubsystem)
	{
	}

	virtual void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs) override
	{
		if (!Subsystem.IsValid() || !View.Family->EngineShowFlags.PostProcessing)
		{
			return;
		}
		const FViewInfo& ViewInfo = static_cast<const FViewInfo&>(View);
		FAddLightPS::FParameters* Parameters = GraphBuilder.AllocParameters<FAddLightPS::FParameters>();
		Parameters->Light = Subsystem->GetColor();
		Parameters->RenderTargets[0] =
			FRenderTargetBinding((*Inputs.SceneTextures)->SceneColorTexture, ERenderTargetLoadAction::ELoad);
		TShaderMapRef<FScreenVS> VertexShader(ViewInfo.ShaderMap);
		TShaderMapRef<FAddLightPS> PixelShader(ViewInfo.ShaderMap);
		const FIntRect ViewRect = ViewInfo.ViewRect;
		GraphBuilder.AddPass(RDG_EVENT_NAME("AddLight"), Parameters, ERDGPassFlags::Raster,
			[Parameters, VertexShader, PixelShader, ViewRect](FRHICommandListImmediate& RHICmdList)
			{
				RHICmdList.SetViewport(ViewRect.Min.X, ViewRect.Min.Y, 0.0f, ViewRect.Max.X, ViewRect.Max.Y, 1.0f);
				FGraphicsPipelineStateInitializer GraphicsPSOInit;
				RHICmdList.ApplyCachedRenderTargets(GraphicsPSOInit);
				GraphicsPSOInit.BlendState =
					TStaticBlendState<CW_RGB, BO_Add, BF_One, BF_One, BO_Add, BF_Zero, BF_One>::GetRHI();
				GraphicsPSOInit.RasterizerState = TStaticRasterizerState<FM_Solid, CM_None>::GetRHI();
				GraphicsPSOInit.DepthStencilState = TStaticDepthStencilState<false, CF_Always>::GetRHI();
				GraphicsPSOInit.BoundShaderState.VertexDeclarationRHI = GFilterVertexDeclaration.VertexDeclarationRHI;
				GraphicsPSOInit.BoundShaderState.VertexShaderRHI = VertexShader.GetVertexShader();
				GraphicsPSOInit.BoundShaderState.PixelShaderRHI = PixelShader.GetPixelShader();
				GraphicsPSOInit.PrimitiveType = PT_TriangleList;
				SetGraphicsPipelineState(RHICmdList, GraphicsPSOInit, 0);
				SetShaderParameters(RHICmdList, PixelShader, PixelShader.GetPixelShader(), *Parameters);
				DrawRectangle(RHICmdList, 0, 0, ViewRect.Width(), ViewRect.Height(), ViewRect.Min.X, ViewRect.Min.Y,
					ViewRect.Width(), ViewRect.Height(), ViewRect.Size(), ViewRect.Size(), VertexShader);
			});
	}

private:
	TWeakObjectPtr<const UAddLightSubsystem> Subsystem;
};

void UAddLightSubsystemBase::Initialize(FSubsystemCollectionBase& Collection)
{
	Super::Initialize(Collection);
	Tint(Settings);
}

void UAddLightSubsystem::Initialize(FSubsystemCollectionBase& Collection)
{
	Super::Initialize(Collection);
	check(GEngine);
	Extension = FSceneViewExtensions::NewExtension<FAddLightExtension>(this);
}

void UAddLightSubsystem::Deinitialize()
{
	Extension.Reset();
	Super::Deinitialize();
}

void UAddLightSubsystem::Tint(FAddLightSettings& InSettings)
{
	InSettings.Color = InSettings.Color * FLinearColor(2.0f, 2.0f, 2.0f, 1.0f);
}
