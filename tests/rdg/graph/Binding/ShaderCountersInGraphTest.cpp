// Append and consume buffers in passes of the graph: where the counter of a view lives, and what a view without one is
// told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "Diagnostics.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "ShaderTypes.h"

namespace
{

using testing::HasSubstr;

constexpr uint32 NumNumbers = 64;

uint32 GetNumber(uint32 Index)
{
	return Index * 37 % 100;
}

class FShaderCountersInGraph : public testing::Test
{
protected:
	static void SetUpTestSuite()
	{
		setenv("DRYDOCK_CACHE_DIR", DRYDOCK_TEST_BINARY_DIR "/test-shader-cache", 0);
		AddShaderSourceDirectoryMapping(
			TEXT("/DrydockTest"), FString(DRYDOCK_TEST_SOURCE_DIR "/tests/rdg/graph/Binding/Shaders"));
	}

	static FRDGBufferRef MakeBuffer(FRDGBuilder& GraphBuilder, const TCHAR* Name)
	{
		const FRDGBufferRef Buffer =
			GraphBuilder.CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(sizeof(uint32), 2 * NumNumbers), Name);
		AddClearUAVPass(GraphBuilder, GraphBuilder.CreateUAV(Buffer), 7u);
		return Buffer;
	}

	static FRDGBufferUAVRef MakeView(FRDGBuilder& GraphBuilder, FRDGBufferRef Buffer, bool bAppend, bool bCounter)
	{
		FRDGBufferUAVDesc Desc(Buffer);
		Desc.bSupportsAppendBuffer = bAppend;
		Desc.bSupportsAtomicCounter = bCounter;
		return GraphBuilder.CreateUAV(Desc);
	}

	static void AddKeepPass(FRDGBuilder& GraphBuilder, FRDGBufferUAVRef Kept, uint32 Limit)
	{
		uint32 Numbers[NumNumbers];
		for (uint32 i = 0; i < NumNumbers; ++i)
		{
			Numbers[i] = GetNumber(i);
		}
		FTestKeepCS::FParameters* const Parameters = GraphBuilder.AllocParameters<FTestKeepCS::FParameters>();
		Parameters->Numbers = GraphBuilder.CreateSRV(CreateStructuredBuffer(
			GraphBuilder, TEXT("Numbers"), sizeof(uint32), NumNumbers, Numbers, sizeof(Numbers)));
		Parameters->Kept = Kept;
		Parameters->Limit = Limit;
		const TShaderMapRef<FTestKeepCS> Shader(GetGlobalShaderMap(GMaxRHIFeatureLevel));
		FComputeShaderUtils::AddPass(
			GraphBuilder, RDG_EVENT_NAME("Keep"), Shader, Parameters, FIntVector(NumNumbers / 16, 1, 1));
	}

	static void AddTakePass(FRDGBuilder& GraphBuilder, FRDGBufferUAVRef Taken, FRDGBufferUAVRef Places, uint32 Count)
	{
		FTestTakeCS::FParameters* const Parameters = GraphBuilder.AllocParameters<FTestTakeCS::FParameters>();
		Parameters->Taken = Taken;
		Parameters->Places = Places;
		Parameters->Count = Count;
		const TShaderMapRef<FTestTakeCS> Shader(GetGlobalShaderMap(GMaxRHIFeatureLevel));
		FComputeShaderUtils::AddPass(
			GraphBuilder, RDG_EVENT_NAME("Take"), Shader, Parameters, FIntVector(NumNumbers / 16, 1, 1));
	}

	/** The message of a graph whose Kept and Places are seen through views with these flags. */
	static std::string ErrorOf(bool bKeptAppends, bool bKeptCounts, bool bPlacesCount)
	{
		try
		{
			FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
			const FRDGBufferRef Kept = MakeBuffer(GraphBuilder, TEXT("Kept"));
			const FRDGBufferRef Places = MakeBuffer(GraphBuilder, TEXT("Places"));
			AddKeepPass(GraphBuilder, MakeView(GraphBuilder, Kept, bKeptAppends, bKeptCounts), 50);
			AddTakePass(GraphBuilder, MakeView(GraphBuilder, Kept, true, false),
				MakeView(GraphBuilder, Places, false, bPlacesCount), 1);
			TRefCountPtr<FRDGPooledBuffer> Result;
			GraphBuilder.QueueBufferExtraction(Places, &Result);
			GraphBuilder.Execute();
		}
		catch (const Drydock::FError& Error)
		{
			return Error.what();
		}
		return {};
	}
};

} // namespace

TEST_F(FShaderCountersInGraph, PassesAndGraphsGoOnWhereTheLastOneStopped)
{
	std::vector<uint32> Kept; // in the order of threads
	for (uint32 i = 0; i < NumNumbers; ++i)
	{
		if (GetNumber(i) > 50)
		{
			Kept.push_back(GetNumber(i));
		}
	}
	ASSERT_GT(Kept.size(), 20u);
	const uint32 NumTaken = uint32(Kept.size()) - 3;
	for (int32 Time = 0; Time < 2; ++Time) // the second time in the buffers of the first one, which the pool has back
	{
		TRefCountPtr<FRDGPooledBuffer> KeptBuffer;
		TRefCountPtr<FRDGPooledBuffer> PlacesBuffer;
		{
			FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
			const FRDGBufferRef Buffer = MakeBuffer(GraphBuilder, TEXT("Kept"));
			const FRDGBufferRef Places = MakeBuffer(GraphBuilder, TEXT("Places"));
			AddKeepPass(GraphBuilder, MakeView(GraphBuilder, Buffer, true, false), 50);
			AddTakePass(GraphBuilder, MakeView(GraphBuilder, Buffer, true, false),
				MakeView(GraphBuilder, Places, false, true), NumTaken);
			GraphBuilder.QueueBufferExtraction(Buffer, &KeptBuffer);
			GraphBuilder.QueueBufferExtraction(Places, &PlacesBuffer);
			GraphBuilder.Execute();
		}
		{
			FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
			AddTakePass(GraphBuilder,
				MakeView(GraphBuilder, GraphBuilder.RegisterExternalBuffer(KeptBuffer), true, false),
				MakeView(GraphBuilder, GraphBuilder.RegisterExternalBuffer(PlacesBuffer), false, true), 2);
			GraphBuilder.Execute();
		}
		const uint32* const Values = reinterpret_cast<const uint32*>(PlacesBuffer->GetRHI()->GetData());
		for (uint32 i = 0; i < NumTaken + 2; ++i)
		{
			EXPECT_EQ(Kept[Kept.size() - 1 - i], Values[i]) << i;
		}
		EXPECT_EQ(7u, Values[NumTaken + 2]);
	}
}

TEST_F(FShaderCountersInGraph, ViewsWithOtherFlagsHaveACounterOfTheirOwn)
{
	const FBufferRHIRef Buffer =
		RHICreateStructuredBuffer(4, 16, BUF_UnorderedAccess, FRHIResourceCreateInfo(TEXT("B")));
	const FUnorderedAccessViewRHIRef Appends = RHICreateUnorderedAccessView(Buffer, false, true);
	const FUnorderedAccessViewRHIRef Counts = RHICreateUnorderedAccessView(Buffer, true, false);
	const FUnorderedAccessViewRHIRef Same = RHICreateUnorderedAccessView(Buffer, true, false);
	EXPECT_TRUE(Appends->SupportsAppendBuffer());
	EXPECT_FALSE(Appends->SupportsAtomicCounter());
	EXPECT_NE(Appends->GetKernelCounter().Data, Counts->GetKernelCounter().Data);
	EXPECT_EQ(Same->GetKernelCounter().Data, Counts->GetKernelCounter().Data);
	EXPECT_EQ(4u, Counts->GetKernelCounter().SizeInBytes);
}

TEST_F(FShaderCountersInGraph, AViewWithoutACounterIsNamed)
{
	EXPECT_EQ("", ErrorOf(true, false, true));
	EXPECT_THAT(ErrorOf(false, true, true),
		testing::AllOf(HasSubstr("pass Keep, parameter Kept"),
			HasSubstr("FTestKeepCS: 'Kept' is read by /DrydockTest/Counters.usf:11 as an AppendStructuredBuffer or "
					  "ConsumeStructuredBuffer, and the UAV was created without FRDGBufferUAVDesc::"
					  "bSupportsAppendBuffer")));
	EXPECT_THAT(ErrorOf(true, false, false),
		testing::AllOf(HasSubstr("pass Take, parameter Places"),
			HasSubstr("FTestTakeCS: 'Places' is read by /DrydockTest/Counters.usf:24 as a RWStructuredBuffer with a "
					  "counter, and the UAV was created without FRDGBufferUAVDesc::bSupportsAtomicCounter")));
}

TEST_F(FShaderCountersInGraph, OnlyStructuredBuffersHaveCounters)
{
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	const FRDGBufferRef Buffer =
		GraphBuilder.CreateBuffer(FRDGBufferDesc::CreateBufferDesc(sizeof(uint32), 4), TEXT("Typed"));
	FRDGBufferUAVDesc Desc(Buffer, PF_R32_UINT);
	Desc.bSupportsAppendBuffer = true;
	try
	{
		GraphBuilder.CreateUAV(Desc);
		ADD_FAILURE() << "no message";
	}
	catch (const Drydock::FError& Error)
	{
		EXPECT_THAT(
			Error.what(), HasSubstr("a UAV was created with bSupportsAppendBuffer of a buffer that is not structured"));
	}
}
