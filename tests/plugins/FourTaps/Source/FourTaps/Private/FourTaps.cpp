// Passes with vertex shaders of the plugin's own, drawn as the engine's samples draw: a rectangle whose taps are
// computed per vertex, and a triangle over the viewport from SV_VertexID.
#include "CommonRenderResources.h"
#include "Modules/ModuleManager.h"
#include "PipelineStateCache.h"
#include "PostProcess/DrawRectangle.h"
#include "PostProcess/PostProcessing.h"
#include "PostProcess/SceneFilterRendering.h"

BEGIN_SHADER_PARAMETER_STRUCT(FTapsParameters, )
	SHADER_PARAMETER_STRUCT(FScreenPassTextureInput, Input)
	SHADER_PARAMETER(FVector2f, TapOffset)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

class FTapsVS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTapsVS);
	SHADER_USE_PARAMETER_STRUCT(FTapsVS, FGlobalShader);
	using FParameters = FTapsParameters;
};

class FTapsPS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTapsPS);
	SHADER_USE_PARAMETER_STRUCT(FTapsPS, FGlobalShader);
	using FParameters = FTapsParameters;
};

class FTriangleVS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTriangleVS);

public:
	FTriangleVS() = default;
	FTriangleVS(const ShaderMetaType::CompiledShaderInitializerType& Initializer)
		: FGlobalShader(Initializer)
	{
	}
};

class FRampPS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FRampPS);
	SHADER_USE_PARAMETER_STRUCT(FRampPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FTapsVS, "/Plugin/FourTaps/FourTaps.usf", "TapsVS", SF_Vertex);
IMPLEMENT_GLOBAL_SHADER(FTapsPS, "/Plugin/FourTaps/FourTaps.usf", "TapsPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FTriangleVS, "/Plugin/FourTaps/FourTaps.usf", "TriangleVS", SF_Vertex);
IMPLEMENT_GLOBAL_SHADER(FRampPS, "/Plugin/FourTaps/FourTaps.usf", "RampPS", SF_Pixel);

class FFourTapsExtension : public FSceneViewExtensionBase
{
public:
	FFourTapsExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			InOutPassCallbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FFourTapsExtension::Draw));
		}
	}

private:
	static void SetStates(FRHICommandList& RHICmdList, FRHIVertexDeclaration* VertexDeclaration,
		FRHIVertexShader* VertexShader, FRHIPixelShader* PixelShader, FRHIBlendState* BlendState, const FIntRect& Rect)
	{
		FGraphicsPipelineStateInitializer GraphicsPSOInit;
		RHICmdList.ApplyCachedRenderTargets(GraphicsPSOInit);
		GraphicsPSOInit.BlendState = BlendState;
		GraphicsPSOInit.RasterizerState = TStaticRasterizerState<>::GetRHI();
		GraphicsPSOInit.DepthStencilState = TStaticDepthStencilState<false, CF_Always>::GetRHI();
		GraphicsPSOInit.BoundShaderState.VertexDeclarationRHI = VertexDeclaration;
		GraphicsPSOInit.BoundShaderState.VertexShaderRHI = VertexShader;
		GraphicsPSOInit.BoundShaderState.PixelShaderRHI = PixelShader;
		GraphicsPSOInit.PrimitiveType = PT_TriangleList;
		SetGraphicsPipelineState(RHICmdList, GraphicsPSOInit, 0);
		RHICmdList.SetViewport(Rect.Min.X, Rect.Min.Y, 0.0f, Rect.Max.X, Rect.Max.Y, 1.0f);
	}

	FScreenPassTexture Draw(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture SceneColor =
			FScreenPassTexture::CopyFromSlice(GraphBuilder, Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
		FRDGTextureDesc Desc = SceneColor.Texture->Desc;
		Desc.Reset();
		FScreenPassRenderTarget Output(
			GraphBuilder.CreateTexture(Desc, TEXT("FourTaps")), SceneColor.ViewRect, ERenderTargetLoadAction::EClear);
		const FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(GMaxRHIFeatureLevel);
		const FIntRect Rect = SceneColor.ViewRect;

		TShaderMapRef<FTapsVS> TapsVS(ShaderMap);
		TShaderMapRef<FTapsPS> TapsPS(ShaderMap);
		FTapsParameters* Taps = GraphBuilder.AllocParameters<FTapsParameters>();
		Taps->Input =
			GetScreenPassTextureInput(SceneColor, TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp>::GetRHI());
		Taps->TapOffset = FVector2f(1.0f, 1.0f);
		Taps->RenderTargets[0] = Output.GetRenderTargetBinding();
		ClearUnusedGraphResources(TapsVS, TapsPS, Taps);
		const FIntPoint Extent = SceneColor.Texture->Desc.Extent;
		GraphBuilder.AddPass(RDG_EVENT_NAME("FourTaps"), Taps, ERDGPassFlags::Raster,
			[Taps, TapsVS, TapsPS, Rect, Extent](FRHICommandList& RHICmdList)
			{
				SetStates(RHICmdList, GFilterVertexDeclaration.VertexDeclarationRHI, TapsVS.GetVertexShader(),
					TapsPS.GetPixelShader(), TStaticBlendState<>::GetRHI(), Rect);
				SetShaderParameters(RHICmdList, TapsVS, TapsVS.GetVertexShader(), *Taps);
				SetShaderParameters(RHICmdList, TapsPS, TapsPS.GetPixelShader(), *Taps);
				UE::Renderer::PostProcess::DrawRectangle(RHICmdList, TapsVS, 0, 0, Rect.Width(), Rect.Height(),
					Rect.Min.X, Rect.Min.Y, Rect.Width(), Rect.Height(), Rect.Size(), Extent);
			});

		TShaderMapRef<FTriangleVS> TriangleVS(ShaderMap);
		TShaderMapRef<FRampPS> RampPS(ShaderMap);
		FRampPS::FParameters* Ramp = GraphBuilder.AllocParameters<FRampPS::FParameters>();
		Ramp->RenderTargets[0] = FRenderTargetBinding(Output.Texture, ERenderTargetLoadAction::ELoad);
		GraphBuilder.AddPass(RDG_EVENT_NAME("BlueRamp"), Ramp, ERDGPassFlags::Raster,
			[Ramp, TriangleVS, RampPS, Rect](FRHICommandList& RHICmdList)
			{
				SetStates(RHICmdList, GEmptyVertexDeclaration.VertexDeclarationRHI, TriangleVS.GetVertexShader(),
					RampPS.GetPixelShader(), TStaticBlendState<CW_BLUE>::GetRHI(), Rect);
				SetShaderParameters(RHICmdList, RampPS, RampPS.GetPixelShader(), *Ramp);
				RHICmdList.SetStreamSource(0, nullptr, 0);
				RHICmdList.DrawPrimitive(0, 1, 1);
			});
		return Output;
	}
};

class FFourTapsModule : public IModuleInterface
{
public:
	virtual void StartupModule() override { Extension = FSceneViewExtensions::NewExtension<FFourTapsExtension>(); }

private:
	TSharedPtr<FFourTapsExtension, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FFourTapsModule, FourTaps)
