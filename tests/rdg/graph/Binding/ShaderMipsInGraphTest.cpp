// A pixel shader that says no level, in a pass of the graph: of a texture with mips it takes the mip that its
// derivatives choose, of one mip it runs as ever.
#include <gtest/gtest.h>

#include <cstdlib>

#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "RenderTargetPool.h"

namespace
{

class FTestMipsPS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTestMipsPS);
	SHADER_USE_PARAMETER_STRUCT(FTestMipsPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(float, Scale)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Source)
		SHADER_PARAMETER_SAMPLER(SamplerState, SourceSampler)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FTestMipsPS, "/DrydockTest/Mips.usf", "MipsPS", SF_Pixel);

class FShaderMipsInGraph : public testing::Test
{
protected:
	static void SetUpTestSuite()
	{
		setenv("DRYDOCK_CACHE_DIR", DRYDOCK_TEST_BINARY_DIR "/test-shader-cache", 0);
		AddShaderSourceDirectoryMapping(
			TEXT("/DrydockTest"), FString(DRYDOCK_TEST_SOURCE_DIR "/tests/rdg/graph/Binding/Shaders"));
	}

	/** Samples a texture whose mips hold 10, 11, 12 ..., at steps of Scale texels. */
	static float Run(uint8 NumMips, float Scale)
	{
		FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
		const FRDGTextureRef Source =
			GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(FIntPoint(16, 16), PF_A32B32G32R32F,
										   FClearValueBinding::None, TexCreate_UAV | TexCreate_ShaderResource, NumMips),
				TEXT("Source"));
		for (uint8 Mip = 0; Mip < NumMips; ++Mip)
		{
			AddClearUAVPass(GraphBuilder, GraphBuilder.CreateUAV(FRDGTextureUAVDesc(Source, Mip)),
				FLinearColor(10 + float(Mip), 0, 0, 0));
		}
		const FRDGTextureRef Output = GraphBuilder.CreateTexture(
			FRDGTextureDesc::Create2D(FIntPoint(9, 5), PF_A32B32G32R32F, FClearValueBinding::None,
				TexCreate_RenderTargetable | TexCreate_ShaderResource),
			TEXT("Output"));
		FTestMipsPS::FParameters* const Parameters = GraphBuilder.AllocParameters<FTestMipsPS::FParameters>();
		Parameters->Scale = Scale;
		Parameters->Source = Source;
		Parameters->SourceSampler = TStaticSamplerState<SF_Trilinear, AM_Wrap, AM_Wrap>::GetRHI();
		Parameters->RenderTargets[0] = FRenderTargetBinding(Output, ERenderTargetLoadAction::ENoAction);
		const TShaderMapRef<FTestMipsPS> Shader(GetGlobalShaderMap(GMaxRHIFeatureLevel));
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, GetGlobalShaderMap(GMaxRHIFeatureLevel),
			RDG_EVENT_NAME("Mips"), Shader, Parameters, FIntRect(0, 0, 9, 5));
		TRefCountPtr<IPooledRenderTarget> Result;
		GraphBuilder.QueueTextureExtraction(Output, &Result);
		GraphBuilder.Execute();
		const float First = Result->GetRHI()->ReadTexel(0, 0).R;
		EXPECT_EQ(First, Result->GetRHI()->ReadTexel(8, 4).R);
		return First;
	}
};

} // namespace

TEST_F(FShaderMipsInGraph, TheBoundViewDecides)
{
	EXPECT_EQ(10.0f, Run(1, 4));
	EXPECT_EQ(12.0f, Run(5, 4));
	EXPECT_EQ(13.0f, Run(5, 8));
	EXPECT_EQ(10.0f, Run(5, 1));
	EXPECT_EQ(10.0f, Run(1, 4));
}
