// Return protocol 1: a compute pass into a texture of its own, copied back into the scene colour, which is returned.
#include "CoreMinimal.h"
#include "GlobalShader.h"
#include "Modules/ModuleManager.h"
#include "PostProcess/PostProcessing.h"
#include "PostProcess/PostProcessMaterial.h"
#include "RenderGraphUtils.h"
#include "SceneViewExtension.h"
#include "ScreenPass.h"
#include "ShaderParameterStruct.h"

#define SWAP_THREADS 8

class FSwapChannelsCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FSwapChannelsCS);
	SHADER_USE_PARAMETER_STRUCT(FSwapChannelsCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, OriginalSceneColor)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, Output)
		SHADER_PARAMETER(FIntRect, ViewRect)
	END_SHADER_PARAMETER_STRUCT()

	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters& Parameters)
	{
		return IsFeatureLevelSupported(Parameters.Platform, ERHIFeatureLevel::SM5);
	}
	static inline void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("THREADS_X"), SWAP_THREADS);
		OutEnvironment.SetDefine(TEXT("THREADS_Y"), SWAP_THREADS);
		OutEnvironment.SetDefine(TEXT("THREADS_Z"), 1);
	}
};

IMPLEMENT_GLOBAL_SHADER(FSwapChannelsCS, "/Plugin/SwapChannels/SwapChannels.usf", "MainCS", SF_Compute);

class FSwapChannelsExtension : public FSceneViewExtensionBase
{
public:
	FSwapChannelsExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void SetupViewFamily(FSceneViewFamily& InViewFamily) override{};
	virtual void SetupView(FSceneViewFamily& InViewFamily, FSceneView& InView) override{};
	virtual void BeginRenderViewFamily(FSceneViewFamily& InViewFamily) override{};
	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass PassId, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled) override
	{
		if (PassId == EPostProcessingPass::MotionBlur)
		{
			InOutPassCallbacks.Add(
				FAfterPassCallbackDelegate::CreateRaw(this, &FSwapChannelsExtension::PostProcessPass));
		}
	}

private:
	FScreenPassTexture PostProcessPass(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture& SceneColor =
			FScreenPassTexture::CopyFromSlice(GraphBuilder, Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
		if (!SceneColor.IsValid())
		{
			return SceneColor;
		}
		RDG_EVENT_SCOPE(GraphBuilder, "SwapChannels");
		{
			FRDGTextureDesc Desc = SceneColor.Texture->Desc;
			Desc.Reset();
			Desc.Flags |= TexCreate_UAV;
			FRDGTextureRef Output = GraphBuilder.CreateTexture(Desc, TEXT("SwapChannels Output"));

			FSwapChannelsCS::FParameters* Parameters = GraphBuilder.AllocParameters<FSwapChannelsCS::FParameters>();
			Parameters->OriginalSceneColor = SceneColor.Texture;
			Parameters->Output = GraphBuilder.CreateUAV(FRDGTextureUAVDesc(Output));
			Parameters->ViewRect = SceneColor.ViewRect;

			const FIntPoint Threads = SceneColor.ViewRect.Size();
			const FIntVector GroupCount = FComputeShaderUtils::GetGroupCount(
				FIntVector(Threads.X, Threads.Y, 1), FIntVector(SWAP_THREADS, SWAP_THREADS, 1));
			TShaderMapRef<FSwapChannelsCS> Shader(GetGlobalShaderMap(GMaxRHIFeatureLevel));
			FComputeShaderUtils::AddPass(
				GraphBuilder, RDG_EVENT_NAME("SwapChannels"), ERDGPassFlags::Compute, Shader, Parameters, GroupCount);
			AddCopyTexturePass(GraphBuilder, Output, SceneColor.Texture);
		}
		return SceneColor;
	}
};

class FSwapChannelsModule : public IModuleInterface
{
public:
	virtual void StartupModule() override { Extension = FSceneViewExtensions::NewExtension<FSwapChannelsExtension>(); }
	virtual void ShutdownModule() override { Extension.Reset(); }

private:
	TSharedPtr<FSwapChannelsExtension, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FSwapChannelsModule, SwapChannels)
