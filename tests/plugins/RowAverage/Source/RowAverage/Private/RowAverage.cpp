// Structured buffers: a pass sums each row, a second one reads the sums; a readback brings them to the next frame's CPU
// side.
#include "GlobalShader.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "RHIGPUReadback.h"
#include "RenderGraphUtils.h"
#include "SceneViewExtension.h"

namespace
{

class FRowSumCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FRowSumCS);
	SHADER_USE_PARAMETER_STRUCT(FRowSumCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Source)
		SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float>, Weights)
		SHADER_PARAMETER_RDG_BUFFER_UAV(RWStructuredBuffer<float>, RowSums)
		SHADER_PARAMETER(FIntPoint, Size)
	END_SHADER_PARAMETER_STRUCT()
};

class FRowAverageCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FRowAverageCS);
	SHADER_USE_PARAMETER_STRUCT(FRowAverageCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float>, RowSumsIn)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, Target)
		SHADER_PARAMETER(FIntPoint, Size)
		SHADER_PARAMETER(float, ReadBack)
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FRowSumCS, "/Plugin/RowAverage/RowAverage.usf", "SumCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FRowAverageCS, "/Plugin/RowAverage/RowAverage.usf", "AverageCS", SF_Compute);

class FRowAverageExtension : public FSceneViewExtensionBase
{
public:
	FRowAverageExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
		, Readback(MakeUnique<FRHIGPUBufferReadback>(TEXT("RowAverage.Readback")))
	{
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FRowAverageExtension::Average));
		}
	}

private:
	FScreenPassTexture Average(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture SceneColor = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
		const FIntPoint Size = SceneColor.ViewRect.Size();
		FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(GMaxRHIFeatureLevel);

		TArray<float> Weights;
		Weights.Init(2.0f, Size.X);
		FRDGBufferRef WeightBuffer = CreateStructuredBuffer(GraphBuilder, TEXT("Weights"), sizeof(float), Weights.Num(),
			Weights.GetData(), Weights.Num() * sizeof(float));
		FRDGBufferRef RowSums =
			GraphBuilder.CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(sizeof(float), Size.Y), TEXT("RowSums"));
		AddClearUAVPass(GraphBuilder, GraphBuilder.CreateUAV(RowSums), 0u);
		{
			auto* Parameters = GraphBuilder.AllocParameters<FRowSumCS::FParameters>();
			Parameters->Source = SceneColor.Texture;
			Parameters->Weights = GraphBuilder.CreateSRV(WeightBuffer);
			Parameters->RowSums = GraphBuilder.CreateUAV(RowSums);
			Parameters->Size = Size;
			FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("RowSums"), TShaderMapRef<FRowSumCS>(ShaderMap),
				Parameters, FComputeShaderUtils::GetGroupCount(Size.Y, 64));
		}

		// What the frame before enqueued.
		float FirstRowBefore = 0.0f;
		if (Readback->IsReady())
		{
			const float* Values = static_cast<const float*>(Readback->Lock(sizeof(float)));
			FirstRowBefore = Values[0];
			Readback->Unlock();
		}
		AddEnqueueCopyPass(GraphBuilder, Readback.Get(), RowSums, Size.Y * sizeof(float));

		FRDGTextureDesc Desc = SceneColor.Texture->Desc;
		Desc.Flags |= TexCreate_UAV;
		FRDGTextureRef Target = GraphBuilder.CreateTexture(Desc, TEXT("RowAverage"));
		auto* Parameters = GraphBuilder.AllocParameters<FRowAverageCS::FParameters>();
		Parameters->RowSumsIn = GraphBuilder.CreateSRV(RowSums);
		Parameters->Target = GraphBuilder.CreateUAV(Target);
		Parameters->Size = Size;
		Parameters->ReadBack = FirstRowBefore;
		FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("RowAverage"), ERDGPassFlags::AsyncCompute,
			TShaderMapRef<FRowAverageCS>(ShaderMap), Parameters,
			FComputeShaderUtils::GetGroupCount(Size, FIntPoint(8, 8)));
		return FScreenPassTexture(Target, SceneColor.ViewRect);
	}

	TUniquePtr<FRHIGPUBufferReadback> Readback;
};

TSharedRef<FRowAverageExtension, ESPMode::ThreadSafe> GRowAverage =
	FSceneViewExtensions::NewExtension<FRowAverageExtension>();

} // namespace
