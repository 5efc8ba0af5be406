// A shader in a pass of the graph: textures, views and uniform buffers of the graph reach the kernel.
#include <gtest/gtest.h>

#include <cstdlib>

#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "RenderTargetPool.h"
#include "ShaderTypes.h"

namespace
{

class FShaderGraphResources : public testing::Test
{
protected:
	static void SetUpTestSuite()
	{
		setenv("DRYDOCK_CACHE_DIR", DRYDOCK_TEST_BINARY_DIR "/test-shader-cache", 0);
		AddShaderSourceDirectoryMapping(
			TEXT("/DrydockTest"), FString(DRYDOCK_TEST_SOURCE_DIR "/tests/rdg/graph/Binding/Shaders"));
	}

	static FRDGTextureRef MakeTexture(
		FRDGBuilder& GraphBuilder, const TCHAR* Name, const FLinearColor& Value, EPixelFormat Format = PF_A32B32G32R32F)
	{
		const FRDGTextureRef Texture =
			GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(FIntPoint(9, 5), Format, FClearValueBinding::None,
										   TexCreate_ShaderResource | TexCreate_UAV),
				Name);
		AddClearUAVPass(GraphBuilder, GraphBuilder.CreateUAV(Texture), Value);
		return Texture;
	}

	/** What the shader leaves in the last texel of a 9x5 texture. */
	static FLinearColor Run(bool bUseScene, EPixelFormat Format = PF_A32B32G32R32F)
	{
		FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
		const FRDGTextureRef Output = MakeTexture(GraphBuilder, TEXT("Output"), FLinearColor::Transparent, Format);
		FTestSceneUniforms* const Scene = GraphBuilder.AllocParameters<FTestSceneUniforms>();
		Scene->SceneColorTexture = MakeTexture(GraphBuilder, TEXT("Scene"), FLinearColor(1.0f, 2.0f, 3.0f, 4.0f));
		Scene->Tint = FVector4f(10.0f, 10.0f, 10.0f, 10.0f);

		FTestGraphCS::FParameters* const Parameters = GraphBuilder.AllocParameters<FTestGraphCS::FParameters>();
		Parameters->InputTexture = MakeTexture(GraphBuilder, TEXT("Input"), FLinearColor(0.5f, 0.25f, 0.125f, 1.0f));
		Parameters->OutputTexture = GraphBuilder.CreateUAV(Output);
		Parameters->Scene = GraphBuilder.CreateUniformBuffer(Scene);
		const TShaderMapRef<FTestGraphCS> Shader(GetGlobalShaderMap(GMaxRHIFeatureLevel), bUseScene ? 1 : 0);
		FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("Graph"), Shader, Parameters,
			FComputeShaderUtils::GetGroupCount(FIntPoint(9, 5), FComputeShaderUtils::kGolden2DGroupSize));

		TRefCountPtr<IPooledRenderTarget> Result;
		GraphBuilder.QueueTextureExtraction(Output, &Result);
		GraphBuilder.Execute();
		return Result->GetRHI()->ReadTexel(8, 4);
	}
};

} // namespace

TEST_F(FShaderGraphResources, TexturesAndViewsReachTheKernel)
{
	EXPECT_EQ(FLinearColor(0.5f, 0.25f, 0.125f, 1.0f), Run(false));
}

TEST_F(FShaderGraphResources, UniformBuffersReachTheKernelWithTheirTextures)
{
	EXPECT_EQ(FLinearColor(10.5f, 20.25f, 30.125f, 41.0f), Run(true));
}

TEST_F(FShaderGraphResources, ComponentsThatTheFormatDropsAreRemarkedOnce)
{
	testing::internal::CaptureStderr();
	Run(false, PF_R16F);
	Run(false, PF_R16F);
	EXPECT_EQ(
		"note DD2055 at FTestGraphCS, parameter OutputTexture: the shader stores 4 components, and Output is R16F, "
		"which keeps 1\n",
		testing::internal::GetCapturedStderr());

	testing::internal::CaptureStderr();
	Run(false, PF_FloatR11G11B10); // as is usual
	EXPECT_EQ("", testing::internal::GetCapturedStderr());
}
