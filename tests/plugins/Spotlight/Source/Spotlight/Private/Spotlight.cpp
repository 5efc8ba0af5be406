// The most used habit: before post-processing, edit scene colour in place through a temporary texture. The shader reads
// the view's uniform buffer.
#include "CoreMinimal.h"
#include "FXRenderingUtils.h"
#include "Modules/ModuleManager.h"
#include "PostProcess/PostProcessInputs.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneViewExtension.h"
#include "SceneTextureParameters.h"
#include "ShaderParameterStruct.h"

namespace Spotlight
{

class FSpotlightCS : public FGlobalShader
{
	DECLARE_EXPORTED_SHADER_TYPE(FSpotlightCS, Global, );
	SHADER_USE_PARAMETER_STRUCT(FSpotlightCS, FGlobalShader);

public:
	static constexpr int32 THREADGROUPSIZE_X = 16;
	static constexpr int32 THREADGROUPSIZE_Y = 4;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, SceneColorTexture)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutputTexture)
	END_SHADER_PARAMETER_STRUCT()

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("THREADGROUPSIZE_X"), THREADGROUPSIZE_X);
		OutEnvironment.SetDefine(TEXT("THREADGROUPSIZE_Y"), THREADGROUPSIZE_Y);
	}
};

IMPLEMENT_SHADER_TYPE(, FSpotlightCS, TEXT("/Plugin/Spotlight/Spotlight.usf"), TEXT("SpotlightCS"), SF_Compute)

class FSpotlightExtension : public FSceneViewExtensionBase
{
public:
	FSpotlightExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void SetupViewFamily(FSceneViewFamily& InViewFamily) override {}
	virtual void SetupView(FSceneViewFamily& InViewFamily, FSceneView& InView) override {}
	virtual void BeginRenderViewFamily(FSceneViewFamily& InViewFamily) override {}
	virtual void PreRenderView_RenderThread(FRDGBuilder& GraphBuilder, FSceneView& InView) override {}
	virtual void PostRenderView_RenderThread(FRDGBuilder& GraphBuilder, FSceneView& InView) override {}

	virtual void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs) override
	{
		FSceneViewExtensionBase::PrePostProcessPass_RenderThread(GraphBuilder, View, Inputs);
		check(IsInRenderingThread());
		Inputs.Validate();
		const FIntRect ViewRect = UE::FXRenderingUtils::GetRawViewRectUnsafe(View);
		FRDGTextureRef SceneColor = Inputs.SceneTextures->GetContents()->SceneColorTexture;

		FRDGTextureDesc Desc = SceneColor->Desc;
		Desc.Flags |= TexCreate_ShaderResource | TexCreate_UAV;
		Desc.Flags &= ~(TexCreate_ResolveTargetable | TexCreate_FastVRAM);
		FRDGTextureRef Edited = GraphBuilder.CreateTexture(Desc, TEXT("Spotlight"));

		TShaderMapRef<FSpotlightCS> ComputeShader(GetGlobalShaderMap(View.GetFeatureLevel()));
		FSpotlightCS::FParameters* Parameters = GraphBuilder.AllocParameters<FSpotlightCS::FParameters>();
		Parameters->View = View.ViewUniformBuffer;
		Parameters->SceneColorTexture = SceneColor;
		Parameters->OutputTexture = GraphBuilder.CreateUAV(Edited);
		const FIntPoint GroupSize(ComputeShader->THREADGROUPSIZE_X, ComputeShader->THREADGROUPSIZE_Y);
		GraphBuilder.AddPass(RDG_EVENT_NAME("Spotlight"), Parameters, ERDGPassFlags::Compute,
			[Parameters, ComputeShader, Groups = FComputeShaderUtils::GetGroupCount(ViewRect.Size(), GroupSize)](
				FRHIComputeCommandList& RHICmdList)
			{ FComputeShaderUtils::Dispatch(RHICmdList, ComputeShader, *Parameters, Groups); });
		AddCopyTexturePass(GraphBuilder, Edited, SceneColor, ViewRect.Min, ViewRect.Min, ViewRect.Size());
	}
};

} // namespace Spotlight

class FSpotlightModule : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
		Extension = FSceneViewExtensions::NewExtension<Spotlight::FSpotlightExtension>();
	}
	virtual void ShutdownModule() override { Extension.Reset(); }

private:
	TSharedPtr<Spotlight::FSpotlightExtension, ESPMode::ThreadSafe> Extension;
};

IMPLEMENT_MODULE(FSpotlightModule, Spotlight)
