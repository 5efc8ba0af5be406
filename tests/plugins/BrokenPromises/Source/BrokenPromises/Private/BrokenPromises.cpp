// Passes each of which breaks one of the promises that `drydock prove` puts to the test; r.BrokenPromises says which.
#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "RenderGraphUtils.h"
#include "SceneViewExtension.h"

#include <memory>

namespace
{

TAutoConsoleVariable<int32> CVarFault(TEXT("r.BrokenPromises"), 0,
	TEXT("0: none; 1: reads a half that was not drawn; 2: reads what a compute shader did not store; 3: keeps a ")
		TEXT("texture's memory; 4: sums up in the order of the threads; 5: ignores the view's rect; 6: counts frames"));

class FBrokenFillPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FBrokenFillPS);
	SHADER_USE_PARAMETER_STRUCT(FBrokenFillPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Source)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

class FBrokenFillCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FBrokenFillCS);
	SHADER_USE_PARAMETER_STRUCT(FBrokenFillCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float>, Output)
	END_SHADER_PARAMETER_STRUCT()
};

class FBrokenSumCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FBrokenSumCS);
	SHADER_USE_PARAMETER_STRUCT(FBrokenSumCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Source)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float>, Output)
	END_SHADER_PARAMETER_STRUCT()
};

class FBrokenPromisesPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FBrokenPromisesPS);
	SHADER_USE_PARAMETER_STRUCT(FBrokenPromisesPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Source)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Helper)
		SHADER_PARAMETER(FVector2f, Middle)
		SHADER_PARAMETER(int32, Fault)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

BEGIN_SHADER_PARAMETER_STRUCT(FReadParameters, )
	RDG_TEXTURE_ACCESS(Read, ERHIAccess::CopySrc)
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FCopyParameters, )
	RDG_TEXTURE_ACCESS(Read, ERHIAccess::CopySrc)
	RDG_TEXTURE_ACCESS(Written, ERHIAccess::CopyDest)
END_SHADER_PARAMETER_STRUCT()

IMPLEMENT_GLOBAL_SHADER(FBrokenFillPS, "/Plugin/BrokenPromises/BrokenPromises.usf", "FillPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FBrokenFillCS, "/Plugin/BrokenPromises/BrokenPromises.usf", "FillEvenCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FBrokenSumCS, "/Plugin/BrokenPromises/BrokenPromises.usf", "SumCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FBrokenPromisesPS, "/Plugin/BrokenPromises/BrokenPromises.usf", "MainPS", SF_Pixel);

class FBrokenPromisesExtension : public FSceneViewExtensionBase
{
public:
	FBrokenPromisesExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FBrokenPromisesExtension::Draw));
		}
	}

private:
	FScreenPassTexture Draw(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture SceneColor(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
		const int32 Fault = CVarFault.GetValueOnRenderThread();
		if (Fault == 3)
		{
			return KeepMemory(GraphBuilder, SceneColor);
		}
		FRDGTextureRef Target = CreateLike(GraphBuilder, SceneColor.Texture, PF_FloatRGBA, TEXT("BrokenPromises"));
		auto* Parameters = GraphBuilder.AllocParameters<FBrokenPromisesPS::FParameters>();
		Parameters->Source = SceneColor.Texture;
		Parameters->Helper = MakeHelper(GraphBuilder, SceneColor, Fault);
		Parameters->Middle =
			FVector2f(0.5f * SceneColor.Texture->Desc.Extent.X, 0.5f * SceneColor.Texture->Desc.Extent.Y);
		Parameters->Fault = Fault;
		Parameters->RenderTargets[0] = FRenderTargetBinding(Target, ERenderTargetLoadAction::ENoAction);
		if (Fault == 6)
		{
			static int NumFrames = 0;
			Parameters->Middle.X = float(++NumFrames);
			Parameters->Fault = 5;
		}
		const FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(GMaxRHIFeatureLevel);
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, ShaderMap, RDG_EVENT_NAME("BrokenPromises"),
			TShaderMapRef<FBrokenPromisesPS>(ShaderMap), Parameters, SceneColor.ViewRect);
		return FScreenPassTexture(Target, SceneColor.ViewRect);
	}

	static FRDGTextureRef CreateLike(
		FRDGBuilder& GraphBuilder, FRDGTextureRef Texture, EPixelFormat Format, const TCHAR* Name)
	{
		FRDGTextureDesc Desc = Texture->Desc;
		Desc.Format = Format;
		Desc.Flags = TexCreate_ShaderResource | TexCreate_RenderTargetable | TexCreate_UAV;
		return GraphBuilder.CreateTexture(Desc, Name);
	}

	static void Fill(FRDGBuilder& GraphBuilder, FRDGTextureRef Source, FRDGTextureRef Target, const FIntRect& Rect)
	{
		auto* Parameters = GraphBuilder.AllocParameters<FBrokenFillPS::FParameters>();
		Parameters->Source = Source;
		Parameters->RenderTargets[0] = FRenderTargetBinding(Target, ERenderTargetLoadAction::ENoAction);
		const FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(GMaxRHIFeatureLevel);
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, ShaderMap, RDG_EVENT_NAME("BrokenFill"),
			TShaderMapRef<FBrokenFillPS>(ShaderMap), Parameters, Rect);
	}

	/** What MainPS adds. */
	static FRDGTextureRef MakeHelper(FRDGBuilder& GraphBuilder, const FScreenPassTexture& SceneColor, int32 Fault)
	{
		const FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(GMaxRHIFeatureLevel);
		if (Fault == 1)
		{
			FRDGTextureRef Half = CreateLike(GraphBuilder, SceneColor.Texture, PF_FloatRGBA, TEXT("BrokenHalf"));
			FIntRect Rect = SceneColor.ViewRect;
			Rect.Max.X = Rect.Min.X + Rect.Width() / 2;
			Fill(GraphBuilder, SceneColor.Texture, Half, Rect);
			return Half;
		}
		if (Fault != 2 && Fault != 4)
		{
			return SceneColor.Texture;
		}
		FRDGTextureRef Helper = CreateLike(GraphBuilder, SceneColor.Texture, PF_R32_FLOAT, TEXT("BrokenHelper"));
		FRDGTextureUAVRef Output = GraphBuilder.CreateUAV(Helper);
		const FIntVector NumGroups =
			FComputeShaderUtils::GetGroupCount(SceneColor.Texture->Desc.Extent, FIntPoint(8, 8));
		if (Fault == 2)
		{
			auto* Parameters = GraphBuilder.AllocParameters<FBrokenFillCS::FParameters>();
			Parameters->Output = Output;
			FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("BrokenFillEven"),
				TShaderMapRef<FBrokenFillCS>(ShaderMap), Parameters, NumGroups);
			return Helper;
		}
		AddClearUAVPass(GraphBuilder, Output, 0.0f);
		auto* Parameters = GraphBuilder.AllocParameters<FBrokenSumCS::FParameters>();
		Parameters->Source = SceneColor.Texture;
		Parameters->Output = Output;
		FComputeShaderUtils::AddPass(
			GraphBuilder, RDG_EVENT_NAME("BrokenSum"), TShaderMapRef<FBrokenSumCS>(ShaderMap), Parameters, NumGroups);
		return Helper;
	}

	/** A texture's memory, used after the last pass that declares it. */
	static FScreenPassTexture KeepMemory(FRDGBuilder& GraphBuilder, const FScreenPassTexture& SceneColor)
	{
		const EPixelFormat Format = SceneColor.Texture->Desc.Format;
		FRDGTextureRef First = CreateLike(GraphBuilder, SceneColor.Texture, Format, TEXT("BrokenKept"));
		FRDGTextureRef Second = CreateLike(GraphBuilder, SceneColor.Texture, Format, TEXT("BrokenSecond"));
		FRDGTextureRef Result = CreateLike(GraphBuilder, SceneColor.Texture, Format, TEXT("BrokenResult"));
		AddCopyTexturePass(GraphBuilder, SceneColor.Texture, First);
		const auto Kept = std::make_shared<FTextureRHIRef>();
		auto* Read = GraphBuilder.AllocParameters<FReadParameters>();
		Read->Read = First;
		GraphBuilder.AddPass(RDG_EVENT_NAME("BrokenKeep"), Read, ERDGPassFlags::Copy | ERDGPassFlags::NeverCull,
			[Kept, First](FRHICommandList&) { *Kept = First->GetRHI(); });
		Fill(GraphBuilder, SceneColor.Texture, Second, SceneColor.ViewRect);
		auto* Copy = GraphBuilder.AllocParameters<FCopyParameters>();
		Copy->Read = Second;
		Copy->Written = Result;
		GraphBuilder.AddPass(RDG_EVENT_NAME("BrokenCopy"), Copy, ERDGPassFlags::Copy,
			[Kept, Second, Result](FRHICommandList& RHICmdList)
			{
				Second->MarkResourceAsUsed();
				RHICmdList.CopyTexture(*Kept, Result->GetRHI(), {});
			});
		return FScreenPassTexture(Result, SceneColor.ViewRect);
	}
};

TSharedRef<FBrokenPromisesExtension, ESPMode::ThreadSafe> GBrokenPromises =
	FSceneViewExtensions::NewExtension<FBrokenPromisesExtension>();

} // namespace
