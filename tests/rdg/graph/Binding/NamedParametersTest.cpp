// Shader classes that bind their parameters one by one, in both forms of setting them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "CommonRenderResources.h"
#include "Diagnostics.h"
#include "GlobalShader.h"
#include "PipelineStateCache.h"
#include "RHIResources.h"
#include "RHIStaticStates.h"
#include "ShaderDirectories.h"
#include "ShaderParameterUtils.h"

namespace
{

using testing::HasSubstr;

class FTestNamedCS : public FGlobalShader
{
	DECLARE_SHADER_TYPE(FTestNamedCS, Global);

public:
	FTestNamedCS() = default;
	FTestNamedCS(const ShaderMetaType::CompiledShaderInitializerType& Initializer)
		: FGlobalShader(Initializer)
	{
		Tint.Bind(Initializer.ParameterMap, TEXT("Tint"), SPF_Mandatory);
		Turn.Bind(Initializer.ParameterMap, TEXT("Turn"));
		Weights.Bind(Initializer.ParameterMap, TEXT("Weights"));
		Shift.Bind(Initializer.ParameterMap, TEXT("Shift"));
		bDouble.Bind(Initializer.ParameterMap, TEXT("bDouble"));
		NotRead.Bind(Initializer.ParameterMap, TEXT("NotRead"));
		InputTexture.Bind(Initializer.ParameterMap, TEXT("InputTexture"));
		InputSampler.Bind(Initializer.ParameterMap, TEXT("InputSampler"));
		OutputTexture.Bind(Initializer.ParameterMap, TEXT("OutputTexture"));
	}
	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters&) { return true; }

	void SetParameters(FRHIBatchedShaderParameters& Batched, const FLinearColor& InTint, FRHITexture* Input,
		FRHISamplerState* Sampler, FRHIUnorderedAccessView* View)
	{
		SetShaderValue(Batched, Tint, InTint);
		SetShaderValue(Batched, Turn, FMatrix44f::Identity);
		SetShaderValue(Batched, bDouble, true);
		SetTextureParameter(Batched, InputTexture, InputSampler, Sampler, Input);
		SetUAVParameter(Batched, OutputTexture, View);
	}

	LAYOUT_FIELD(FShaderParameter, Tint)
	LAYOUT_FIELD(FShaderParameter, Turn);
	LAYOUT_FIELD(FShaderParameter, Weights);
	LAYOUT_FIELD(FShaderParameter, Shift);
	LAYOUT_FIELD(FShaderParameter, bDouble);
	LAYOUT_FIELD(FShaderParameter, NotRead);
	LAYOUT_FIELD(FShaderResourceParameter, InputTexture);
	LAYOUT_FIELD(FShaderResourceParameter, InputSampler);
	LAYOUT_FIELD(FShaderResourceParameter, OutputTexture);
};

/** As published code writes it: a base class with a layout, and one name for what is read and written. */
class FTestCountCS : public FGlobalShader
{
	DECLARE_SHADER_TYPE(FTestCountCS, Global);
	DECLARE_INLINE_TYPE_LAYOUT(FTestCountCS, NonVirtual);

public:
	FTestCountCS() = default;
	FTestCountCS(const ShaderMetaType::CompiledShaderInitializerType& Initializer)
		: FGlobalShader(Initializer)
	{
		Tint.Bind(Initializer.ParameterMap, TEXT("Tint"));
		Picture.Bind(Initializer.ParameterMap, TEXT("Picture"));
		Counts.Bind(Initializer.ParameterMap, TEXT("Counts"));
	}

	LAYOUT_FIELD(FShaderParameter, Tint);
	LAYOUT_FIELD(FRWShaderParameter, Picture);
	LAYOUT_FIELD(FShaderResourceParameter, Counts);
};

class FTestNamedPS : public FGlobalShader
{
	DECLARE_SHADER_TYPE(FTestNamedPS, Global);

public:
	FTestNamedPS() = default;
	FTestNamedPS(const ShaderMetaType::CompiledShaderInitializerType& Initializer)
		: FGlobalShader(Initializer)
	{
		Tint.Bind(Initializer.ParameterMap, TEXT("Tint"));
	}
	void SetParameters(FRHIBatchedShaderParameters& Batched, const FLinearColor& InTint)
	{
		SetShaderValue(Batched, Tint, InTint);
	}
	LAYOUT_FIELD(FShaderParameter, Tint);
};

class FTestNothingPS : public FGlobalShader
{
	DECLARE_SHADER_TYPE(FTestNothingPS, Global);

public:
	FTestNothingPS() = default;
	FTestNothingPS(const ShaderMetaType::CompiledShaderInitializerType& Initializer)
		: FGlobalShader(Initializer)
	{
	}
};

IMPLEMENT_SHADER_TYPE(, FTestNamedCS, TEXT("/DrydockTest/TestNamed.usf"), TEXT("MainCS"), SF_Compute);
IMPLEMENT_SHADER_TYPE(, FTestCountCS, TEXT("/DrydockTest/TestNamed.usf"), TEXT("CountCS"), SF_Compute);
IMPLEMENT_SHADER_TYPE(, FTestNamedPS, TEXT("/DrydockTest/TestNamed.usf"), TEXT("MainPS"), SF_Pixel);
IMPLEMENT_SHADER_TYPE(, FTestNothingPS, TEXT("/DrydockTest/TestNamed.usf"), TEXT("NothingPS"), SF_Pixel);

TRefCountPtr<FRHITexture> MakeTexture(const TCHAR* Name)
{
	return new FRHITexture(FRHITextureDesc::Create2D(FIntPoint(5, 3), PF_A32B32G32R32F, FClearValueBinding::Black,
							   TexCreate_ShaderResource | TexCreate_UAV | TexCreate_RenderTargetable),
		Name);
}

class FNamedParameters : public testing::Test
{
protected:
	static void SetUpTestSuite()
	{
		setenv("DRYDOCK_CACHE_DIR", DRYDOCK_TEST_BINARY_DIR "/test-shader-cache", 0);
		AddShaderSourceDirectoryMapping(
			TEXT("/DrydockTest"), FString(DRYDOCK_TEST_SOURCE_DIR "/tests/rdg/graph/Binding/Shaders"));
	}

	FNamedParameters()
	{
		Input->WriteTexel(2, 1, FLinearColor(1.0f, 2.0f, 3.0f, 4.0f));
		Output->EnsureMemory();
	}

	template<typename TPixelShader, typename TSet>
	FLinearColor Draw(const TSet& Set)
	{
		const TShaderMapRef<TPixelShader> PixelShader(GetGlobalShaderMap(GMaxRHIFeatureLevel));
		RHICmdList.BeginRenderPass(FRHIRenderPassInfo(Output, ERenderTargetActions::Clear_Store), TEXT("Test"));
		FGraphicsPipelineStateInitializer State;
		RHICmdList.ApplyCachedRenderTargets(State);
		State.BoundShaderState.PixelShaderRHI = PixelShader.GetPixelShader();
		SetGraphicsPipelineState(RHICmdList, State, 0);
		Set(*PixelShader.GetShader(), PixelShader.GetPixelShader());
		struct FEnd
		{
			~FEnd() { List.EndRenderPass(); }
			FRHICommandList& List;
		} const End{RHICmdList};
		RHICmdList.DrawPrimitive(0, 2, 1);
		return Output->ReadTexel(4, 2);
	}

	FRHICommandListImmediate& RHICmdList = FRHICommandListExecutor::GetImmediateCommandList();
	TRefCountPtr<FRHITexture> Input = MakeTexture(TEXT("Input"));
	TRefCountPtr<FRHITexture> Output = MakeTexture(TEXT("Output"));
	TRefCountPtr<FRHIUnorderedAccessView> OutputView = new FRHIUnorderedAccessView(Output, FRHITextureUAVCreateInfo(0));
	TShaderMapRef<FTestNamedCS> Shader{GetGlobalShaderMap(GMaxRHIFeatureLevel)};
	FRHISamplerState* Sampler = TStaticSamplerState<SF_Point>::GetRHI();
	// Moves x to y: a vector times a matrix, as HLSL's mul has it.
	FMatrix44f Turn{FPlane4f(0, 1, 0, 0), FPlane4f(1, 0, 0, 0), FPlane4f(0, 0, 1, 0), FPlane4f(0, 0, 0, 1)};
};

} // namespace

TEST_F(FNamedParameters, AreSetAtOnce)
{
	SetComputePipelineState(RHICmdList, Shader.GetComputeShader());
	FRHIComputeShader* const ShaderRHI = Shader.GetComputeShader();
	SetShaderValue(RHICmdList, ShaderRHI, Shader->Tint, FLinearColor(10, 20, 30, 40));
	SetShaderValue(RHICmdList, ShaderRHI, Shader->Turn, Turn);
	SetShaderValue(RHICmdList, ShaderRHI, Shader->Weights, FVector4f(0.5f, 0.25f, 0.125f, 0), 2);
	SetShaderValue(RHICmdList, ShaderRHI, Shader->Shift, int32(-1));
	SetShaderValue(RHICmdList, ShaderRHI, Shader->bDouble, true);
	SetShaderValue(RHICmdList, ShaderRHI, Shader->NotRead, 3.0f);
	SetTextureParameter(RHICmdList, ShaderRHI, Shader->InputTexture, Shader->InputSampler, Sampler, Input);
	SetUAVParameter(RHICmdList, ShaderRHI, Shader->OutputTexture, OutputView);
	RHICmdList.DispatchComputeShader(1, 1, 1);
	EXPECT_EQ(FLinearColor(41.0f, 40.5f, 180.25f, 320.0f), Output->ReadTexel(3, 2));
	EXPECT_TRUE(Shader->Tint.IsBound());
	EXPECT_TRUE(Shader->InputSampler.IsBound());
	EXPECT_FALSE(FShaderParameter().IsBound());
}

TEST_F(FNamedParameters, OfTheListsBoundShaderWriteSignedIntegers)
{
	FRHICommandListImmediate& List = GRHICommandList.GetImmediateCommandList();
	const TShaderMapRef<FTestCountCS> Count(GetGlobalShaderMap(GMaxRHIFeatureLevel));
	const FBufferRHIRef Buffer =
		RHICreateVertexBuffer(10 * sizeof(int32), BUF_UnorderedAccess, FRHIResourceCreateInfo(TEXT("Counts")));
	const FUnorderedAccessViewRHIRef View = RHICreateUnorderedAccessView(Buffer, PF_R32_SINT);
	List.ClearUAVUint(View, FUintVector4(0, 0, 0, 0));
	List.SetComputeShader(Count.GetComputeShader());
	FRHIComputeShader* const Bound = List.GetBoundComputeShader();
	ASSERT_EQ(Count.GetComputeShader(), Bound);
	SetShaderValue(List, Bound, Count->Tint, FLinearColor(1, 2, 3, 4));
	EXPECT_TRUE(Count->Picture.IsUAVBound());
	Count->Picture.SetTexture(List, Bound, Input, OutputView);
	SetUAVParameter(List, Bound, Count->Counts, View);
	DispatchComputeShader(List, Count, 1, 1, 1);
	Count->Picture.UnsetUAV(List, Bound);
	EXPECT_EQ(FLinearColor(1, 2, 3, 4), Output->ReadTexel(4, 2));
	const int32* const Values = static_cast<const int32*>(RHILockBuffer(Buffer, 0, 40, RLM_ReadOnly));
	EXPECT_THAT(std::vector<int32>(Values, Values + 10), testing::ElementsAre(5, 5, 5, 5, 5, -5, 5, 5, -64, -7));
	RHIUnlockBuffer(Buffer);
}

TEST_F(FNamedParameters, AreSetInABatch)
{
	SetComputePipelineState(RHICmdList, Shader.GetComputeShader());
	FRHIBatchedShaderParameters Batch = RHICmdList.GetScratchShaderParameters();
	const FVector4f Values[3] = {FVector4f(0, 0, 0, 0), FVector4f(0, 0, 0, 0), FVector4f(1, 1, 1, 1)};
	SetShaderValueArray(Batch, Shader->Weights, Values, 3);
	SetTextureParameter(Batch, Shader->InputTexture, Input);
	SetSamplerParameter(Batch, Shader->InputSampler, Sampler);
	SetUAVParameter(Batch, Shader->OutputTexture, OutputView);
	RHICmdList.SetBatchedShaderParameters(Shader.GetComputeShader(), Batch);
	RHICmdList.DispatchComputeShader(1, 1, 1);
	EXPECT_EQ(FLinearColor(1, 1, 1, 1), Output->ReadTexel(2, 1)) << "Tint was not set: it is 0";
}

TEST_F(FNamedParameters, WhatIsReadAndNotSetIsNamed)
{
	SetComputePipelineState(RHICmdList, Shader.GetComputeShader());
	SetShaderValue(RHICmdList, Shader.GetComputeShader(), Shader->Tint, FLinearColor(1, 1, 1, 1));
	SetUAVParameter(RHICmdList, Shader.GetComputeShader(), Shader->OutputTexture, OutputView);
	try
	{
		RHICmdList.DispatchComputeShader(1, 1, 1);
		FAIL();
	}
	catch (const Drydock::FError& Error)
	{
		EXPECT_THAT(Error.what(), HasSubstr("shader FTestNamedCS reads 'InputTexture', which nobody has set"));
	}
}

TEST_F(FNamedParameters, PixelShadersDrawWithThem)
{
	EXPECT_EQ(FLinearColor(1, 2, 3, 4), Draw<FTestNothingPS>([](const FTestNothingPS&, FRHIPixelShader*) {}));
	EXPECT_EQ(FLinearColor(5, 6, 7, 8),
		Draw<FTestNamedPS>([this](const FTestNamedPS& PixelShader, FRHIPixelShader* RHI)
			{ SetShaderValue(RHICmdList, RHI, PixelShader.Tint, FLinearColor(5, 6, 7, 8)); }));
	try
	{
		Draw<FTestNamedPS>([](const FTestNamedPS&, FRHIPixelShader*) {});
		FAIL();
	}
	catch (const Drydock::FError& Error)
	{
		EXPECT_THAT(Error.what(), HasSubstr("pixel shader FTestNamedPS reads 'Tint', and its parameters were not set"));
	}
}

TEST_F(FNamedParameters, AreSetByTheClassItself)
{
	SetComputePipelineState(RHICmdList, Shader.GetComputeShader());
	FRHIComputeCommandList& List = RHICmdList;
	SetShaderParametersLegacyCS(List, Shader, FLinearColor(10, 20, 30, 40), Input, Sampler, OutputView);
	List.DispatchComputeShader(1, 1, 1);
	EXPECT_EQ(FLinearColor(20, 80, 180, 320), Output->ReadTexel(2, 1));
	const FLinearColor Drawn = Draw<FTestNamedPS>(
		[this](FTestNamedPS&, FRHIPixelShader*)
		{
			const TShaderMapRef<FTestNamedPS> Named(GetGlobalShaderMap(GMaxRHIFeatureLevel));
			SetShaderParametersLegacyPS(RHICmdList, Named, FLinearColor(5, 6, 7, 8));
		});
	EXPECT_EQ(FLinearColor(5, 6, 7, 8), Drawn);
}
