// A shader whose threads work together, in a pass of the graph: groups in their stated order on any number of threads,
// waves of the size that the console variable says.
#include <gtest/gtest.h>

#include <cstdlib>

#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "RenderTargetPool.h"
#include "ShaderTypes.h"

#include "HAL/IConsoleManager.h"

namespace
{

class FShaderGroupsInGraph : public testing::Test
{
protected:
	static void SetUpTestSuite()
	{
		setenv("DRYDOCK_CACHE_DIR", DRYDOCK_TEST_BINARY_DIR "/test-shader-cache", 0);
		AddShaderSourceDirectoryMapping(
			TEXT("/DrydockTest"), FString(DRYDOCK_TEST_SOURCE_DIR "/tests/rdg/graph/Binding/Shaders"));
	}

	static TRefCountPtr<IPooledRenderTarget> Run(FIntPoint Size)
	{
		FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
		const FRDGTextureRef Output = GraphBuilder.CreateTexture(
			FRDGTextureDesc::Create2D(FIntPoint(64, 3), PF_R32_UINT, FClearValueBinding::None, TexCreate_UAV),
			TEXT("Output"));
		AddClearUAVPass(GraphBuilder, GraphBuilder.CreateUAV(Output), uint32(0));
		FTestGroupsCS::FParameters* const Parameters = GraphBuilder.AllocParameters<FTestGroupsCS::FParameters>();
		Parameters->Output = GraphBuilder.CreateUAV(Output);
		Parameters->Size = FUintVector2(uint32(Size.X), uint32(Size.Y));
		const TShaderMapRef<FTestGroupsCS> Shader(GetGlobalShaderMap(GMaxRHIFeatureLevel));
		FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("Groups"), Shader, Parameters,
			FComputeShaderUtils::GetGroupCount(Size, FIntPoint(16, 8)));
		TRefCountPtr<IPooledRenderTarget> Result;
		GraphBuilder.QueueTextureExtraction(Output, &Result);
		GraphBuilder.Execute();
		return Result;
	}
};

} // namespace

TEST_F(FShaderGroupsInGraph, AHistogramAndTheOrderOfGroups)
{
	constexpr int32 Width = 123;
	constexpr int32 Height = 57;
	const TRefCountPtr<IPooledRenderTarget> Result = Run(FIntPoint(Width, Height));
	uint32 Expected[16] = {};
	for (uint32 x = 0; x < Width; ++x)
	{
		Expected[x * 7 % 16] += Height;
	}
	for (int32 Bin = 0; Bin < 16; ++Bin)
	{
		EXPECT_EQ(float(Expected[Bin]), Result->GetRHI()->ReadTexel(Bin, 0).R) << Bin;
	}
	constexpr int32 NumGroups = 8 * 8;
	for (int32 Group = 0; Group < NumGroups; ++Group)
	{
		EXPECT_EQ(float(Group), Result->GetRHI()->ReadTexel(Group, 1).R) << Group;
	}
	EXPECT_EQ(float(NumGroups), Result->GetRHI()->ReadTexel(0, 2).R);
	EXPECT_EQ(32.0f, Result->GetRHI()->ReadTexel(1, 2).R);
}

TEST_F(FShaderGroupsInGraph, WavesHaveTheSizeThatTheVariableSays)
{
	IConsoleVariable* const WaveSize = IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.WaveSize"));
	ASSERT_NE(nullptr, WaveSize);
	WaveSize->Set(8);
	const TRefCountPtr<IPooledRenderTarget> Result = Run(FIntPoint(16, 8));
	WaveSize->Set(32);
	EXPECT_EQ(8.0f, Result->GetRHI()->ReadTexel(1, 2).R);
}
