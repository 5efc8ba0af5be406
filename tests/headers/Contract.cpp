// The calls that code from outside may rely on, with the types it passes. That it compiles is the test.
#include "CoreMinimal.h"
#include "DrydockFrame.h"
#include "Engine/Engine.h"
#include "Engine/Scene.h"
#include "HAL/IConsoleManager.h"
#include "PostProcess/PostProcessing.h"
#include "RHICommandList.h"
#include "RHIGPUReadback.h"
#include "RHIStaticStates.h"
#include "RenderGraphBlackboard.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphEvent.h"
#include "RenderGraphUtils.h"
#include "RenderTargetPool.h"
#include "SceneViewExtension.h"
#include "ScreenPass.h"
#include "ShaderCore.h"
#include "ShaderParameterStruct.h"

struct FPackedWeights
{
	DECLARE_SCALAR_ARRAY(float, Weights, 6);
};

BEGIN_SHADER_PARAMETER_STRUCT(FContractParameters, )
	SHADER_PARAMETER_SCALAR_ARRAY(float, Offsets, [5])
	RDG_TEXTURE_ACCESS(Copied, ERHIAccess::CopySrc)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

float UseMetadata(FContractParameters& Parameters)
{
	float Sum = 0.0f;
	for (const FShaderParametersMetadata::FMember& Member :
		FContractParameters::FTypeInfo::GetStructMetadata()->GetMembers())
	{
		const FString Name = Member.GetName();
		Sum += Member.GetOffset() + Member.GetNumRows() + Member.GetNumColumns() + Member.GetNumElements() +
			   (Member.GetBaseType() == UBMT_FLOAT32 ? 1.0f : 0.0f) + (Member.GetStructMetadata() ? 1.0f : 0.0f);
	}
	Sum += FContractParameters::FTypeInfo::GetStructMetadata()->GetSize();
	GET_SCALAR_ARRAY_ELEMENT(Parameters.Offsets, 3) = 1.0f;
	const ERHIAccess Access = Parameters.Copied.GetAccess();
	const FRenderTargetBinding& Binding = Parameters.RenderTargets[0];
	return Sum + static_cast<float>(Access == ERHIAccess::CopySrc) + Binding.GetMipIndex() +
		   (Binding.GetTexture() ? 1.0f : 0.0f) +
		   (Binding.GetLoadAction() == ERenderTargetLoadAction::ELoad ? 1.0f : 0.0f);
}

void UseGraph()
{
	FRHICommandListImmediate& RHICmdList = FRHICommandListExecutor::GetImmediateCommandList();
	FRDGBuilder GraphBuilder(RHICmdList, RDG_EVENT_NAME("Contract"));
	FRDGTextureRef Texture = GraphBuilder.CreateTexture(
		FRDGTextureDesc::Create2D({8, 8}, PF_FloatRGBA, {}, TexCreate_UAV | TexCreate_RenderTargetable),
		TEXT("Texture"));
	AddClearUAVPass(GraphBuilder, GraphBuilder.CreateUAV(Texture), FLinearColor::Red);
	AddClearRenderTargetPass(GraphBuilder, Texture);
	AddClearRenderTargetPass(GraphBuilder, Texture, FLinearColor::Black);
	AddClearRenderTargetPass(GraphBuilder, Texture, FLinearColor::Black, FIntRect(0, 0, 4, 4));
	AddCopyTexturePass(GraphBuilder, Texture, Texture, FRHICopyTextureInfo());
	AddCopyTexturePass(GraphBuilder, Texture, Texture);
	const float Data[4] = {};
	FRDGBufferRef Buffer = CreateStructuredBuffer(GraphBuilder, TEXT("Buffer"), 4, 4, Data, sizeof(Data));
	AddClearUAVPass(GraphBuilder, GraphBuilder.CreateUAV(Buffer), 7u);
	FRHIGPUBufferReadback Readback(TEXT("Readback"));
	AddEnqueueCopyPass(GraphBuilder, &Readback, Buffer, 16);
	TRefCountPtr<IPooledRenderTarget> Pooled;
	FRDGTextureRef Maybe = TryRegisterExternalTexture(GraphBuilder, Pooled);
	FContractParameters* Parameters = GraphBuilder.AllocParameters<FContractParameters>();
	Parameters->Copied = Maybe;
	FRDGPassRef First = GraphBuilder.AddPass(RDG_EVENT_NAME("Compute"), Parameters, ERDGPassFlags::Compute,
		[](FRHIComputeCommandList& InRHICmdList)
		{ InRHICmdList.ClearUAVFloat(nullptr, FVector4f(0.0f, 0.0f, 0.0f, 0.0f)); });
	FRDGPassRef Second = GraphBuilder.AddPass(RDG_EVENT_NAME("Copy"), Parameters, ERDGPassFlags::Copy,
		[Texture](FRHICommandList& InRHICmdList)
		{ InRHICmdList.CopyTexture(Texture->GetRHI(), Texture->GetRHI(), FRHICopyTextureInfo()); });
	GraphBuilder.AddPass(RDG_EVENT_NAME("Immediate"), Parameters, ERDGPassFlags::Raster | ERDGPassFlags::NeverCull,
		[](FRHICommandListImmediate&) {});
	GraphBuilder.AddPassDependency(First, Second);
	const FString Name = First->GetName();
	GraphBuilder.QueueTextureExtraction(Texture, &Pooled);
	GraphBuilder.QueueTextureExtraction(Texture, &Pooled);
	FRDGTextureRef Found = GraphBuilder.FindExternalTexture(static_cast<FRHITexture*>(nullptr));
	(void)Found;
	GraphBuilder.Execute();
	TArray<FLinearColor> Pixels;
	FReadSurfaceDataFlags Flags(RCM_MinMax);
	Flags.SetLinearToGamma(false);
	RHICmdList.ReadSurfaceData(Pooled->GetRHI(), FIntRect(0, 0, 8, 8), Pixels, Flags);
	const int32 Size = Pooled->GetDesc().Extent.X + static_cast<int32>(Pooled->GetRefCount());
	IConsoleManager::Get().FindConsoleVariable(TEXT("r.RDG.CullPasses"))->Set(Size > 0 ? 1 : 0);
}

int32 UseViewsAndFrames(const FViewInfo& View)
{
	const FScreenPassTextureViewport Half =
		GetDownscaledViewport(FScreenPassTextureViewport(View.ViewRect), FIntPoint(2, 2));
	const FScreenTransform Transform = FScreenTransform::ChangeTextureBasisFromTo(
		Half, FScreenTransform::ETextureBasis::ViewportUV, FScreenTransform::ETextureBasis::TextureUV);
	(void)Transform;
	AddShaderSourceDirectoryMapping(TEXT("/Contract"), FString(TEXT("/tmp")));
	AddShaderSourceDirectoryMapping(FString(TEXT("/Contract2")), FString(TEXT("/tmp")));
	FPostProcessSettings Settings;
	Settings.bOverride_BloomToonIntensity = true;
	Settings.BloomToonIntensity = 0.675f;
	FSceneTextureUniformParameters SceneTextures;
	SceneTextures.SceneColorTexture = nullptr;
	Drydock::FFrameDesc Desc;
	Desc.Extent = FIntPoint(1, 1);
	Desc.ViewRect = FIntRect(0, 0, 1, 1);
	Desc.SceneColor.Add(FLinearColor::White);
	Desc.ShadingModelID.Add(8);
	Desc.ShowFlags.Add(TEXT("Bloom"), false);
	const Drydock::FFrameOutput Output = Drydock::RenderFrame(Desc);
	return GEngine->ViewExtensions->GatherActiveExtensions(FSceneViewExtensionContext()).Num() + Output.Extent.X +
		   Output.Color.Num();
}
