// A pass whose shader makes one of several mistakes, for the tools that find them.
#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "RenderGraphUtils.h"
#include "SceneViewExtension.h"

namespace
{

TAutoConsoleVariable<int32> CVarFault(
	TEXT("r.PlantedFaults"), 0, TEXT("Which mistake the pass PlantedFaults makes; 0: none."));

class FPlantedFaultsPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FPlantedFaultsPS);
	SHADER_USE_PARAMETER_STRUCT(FPlantedFaultsPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Source)
		SHADER_PARAMETER(int32, Fault)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FPlantedFaultsPS, "/Plugin/PlantedFaults/PlantedFaults.usf", "MainPS", SF_Pixel);

class FPlantedOverlapCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FPlantedOverlapCS);
	SHADER_USE_PARAMETER_STRUCT(FPlantedOverlapCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Source)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, Out)
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FPlantedOverlapCS, "/Plugin/PlantedFaults/PlantedOverlap.usf", "MainCS", SF_Compute);

class FPlantedCopyCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FPlantedCopyCS);
	SHADER_USE_PARAMETER_STRUCT(FPlantedCopyCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Source)
		SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<FPlantedItem>, Items)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, Out)
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FPlantedCopyCS, "/Plugin/PlantedFaults/PlantedSizes.usf", "MainCS", SF_Compute);

/** The fault of PlantedOverlap.usf, and those of this file. */
constexpr int32 Overlap = 11;
constexpr int32 OnStack = 12;
constexpr int32 OtherStride = 13;
constexpr int32 ThreadsAsGroups = 14;
constexpr int32 SubscribesNothing = 15;
constexpr int32 GroupsRoundedDown = 16;

class FPlantedFaultsExtension : public FSceneViewExtensionBase
{
public:
	FPlantedFaultsExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur && CVarFault.GetValueOnAnyThread() != SubscribesNothing)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FPlantedFaultsExtension::Draw));
		}
	}

private:
	FScreenPassTexture Draw(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture SceneColor = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
		FRDGTextureDesc Desc = SceneColor.Texture->Desc;
		Desc.Format = PF_FloatRGBA;
		Desc.Flags |= TexCreate_RenderTargetable | TexCreate_UAV;
		FRDGTextureRef Target = GraphBuilder.CreateTexture(Desc, TEXT("PlantedFaults"));
		if (CVarFault.GetValueOnRenderThread() == Overlap)
		{
			auto* Parameters = GraphBuilder.AllocParameters<FPlantedOverlapCS::FParameters>();
			Parameters->Source = SceneColor.Texture;
			Parameters->Out = GraphBuilder.CreateUAV(Target);
			FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("PlantedOverlap"),
				TShaderMapRef<FPlantedOverlapCS>(GetGlobalShaderMap(GMaxRHIFeatureLevel)), Parameters,
				FComputeShaderUtils::GetGroupCount(SceneColor.ViewRect.Size(), FIntPoint(8, 8)));
			return FScreenPassTexture(Target, SceneColor.ViewRect);
		}
		if (CVarFault.GetValueOnRenderThread() >= OtherStride)
		{
			AddCopy(GraphBuilder, SceneColor, Target);
			return FScreenPassTexture(Target, SceneColor.ViewRect);
		}
		FPlantedFaultsPS::FParameters Local;
		auto* Parameters = CVarFault.GetValueOnRenderThread() == OnStack
							   ? &Local
							   : GraphBuilder.AllocParameters<FPlantedFaultsPS::FParameters>();
		Parameters->Source = SceneColor.Texture;
		Parameters->Fault = CVarFault.GetValueOnRenderThread();
		Parameters->RenderTargets[0] = FRenderTargetBinding(Target, ERenderTargetLoadAction::ENoAction);
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, GetGlobalShaderMap(GMaxRHIFeatureLevel),
			RDG_EVENT_NAME("PlantedFaults"), TShaderMapRef<FPlantedFaultsPS>(GetGlobalShaderMap(GMaxRHIFeatureLevel)),
			Parameters, SceneColor.ViewRect);
		return FScreenPassTexture(Target, SceneColor.ViewRect);
	}

	static void AddCopy(FRDGBuilder& GraphBuilder, const FScreenPassTexture& SceneColor, FRDGTextureRef Target)
	{
		const int32 Fault = CVarFault.GetValueOnRenderThread();
		const FIntPoint Size = SceneColor.ViewRect.Size();
		const uint32 Stride = Fault == OtherStride ? 4 : 16;
		const float Nothing[4] = {};
		auto* Parameters = GraphBuilder.AllocParameters<FPlantedCopyCS::FParameters>();
		Parameters->Source = SceneColor.Texture;
		Parameters->Items = GraphBuilder.CreateSRV(CreateStructuredBuffer(
			GraphBuilder, TEXT("PlantedItems"), Stride, sizeof(Nothing) / Stride, Nothing, sizeof(Nothing)));
		Parameters->Out = GraphBuilder.CreateUAV(Target);
		FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("PlantedCopy"),
			TShaderMapRef<FPlantedCopyCS>(GetGlobalShaderMap(GMaxRHIFeatureLevel)), Parameters,
			Fault == ThreadsAsGroups ? FIntVector(Size.X, Size.Y, 1) : FIntVector(Size.X / 8, Size.Y / 8, 1));
	}
};

TSharedRef<FPlantedFaultsExtension, ESPMode::ThreadSafe> GPlantedFaults =
	FSceneViewExtensions::NewExtension<FPlantedFaultsExtension>();

} // namespace
