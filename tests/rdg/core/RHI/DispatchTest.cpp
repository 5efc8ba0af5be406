// Compute dispatches run every thread and refuse what does not fit.
#include <atomic>
#include <cstring>
#include <limits>

#include "RHITestHelpers.h"

using namespace Drydock;
using namespace Drydock::Tests;

namespace
{

/** Adds one to the texel of every thread that has one; counts the others, and tiles that cut a group. */
std::atomic<int32> GOutside{0};
std::atomic<int32> GCutGroups{0};

void Increment(const FKernelArgs& Args, const FKernelTile& Tile)
{
	GCutGroups += Tile.MinX % 8 != 0 || Tile.MaxX % 8 != 0 || Tile.MinY % 4 != 0 || Tile.MaxY % 4 != 0;
	const FKernelTexture& Target = Args.RWTextures[0];
	for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
	{
		for (int32 X = Tile.MinX; X < Tile.MaxX; ++X)
		{
			if (X < Target.Mips[0].SizeX && Y < Target.Mips[0].SizeY)
			{
				*GetFloats(Target, X, Y) += 1;
			}
			else
			{
				++GOutside;
			}
		}
	}
	if (Args.Counters)
	{
		Args.Counters->Samples += uint64(Tile.MaxX - Tile.MinX);
		Args.Counters->Loads += 1;
	}
}

void StoreHalfOfSmallestNormal(const FKernelArgs& Args, const FKernelTile&)
{
	volatile float Value = std::numeric_limits<float>::min();
	*GetFloats(Args.RWTextures[0], 0, 0) = Value * 0.5f;
}

class Dispatch : public testing::Test
{
protected:
	Dispatch()
	{
		GOutside = 0;
		GCutGroups = 0;
	}

	FBoundShader Bind(FKernelFunction Kernel, FIntVector GroupSize = FIntVector(8, 4, 1))
	{
		FBoundShader Shader = MakeShader(EShaderStage::Compute, Kernel, GroupSize);
		Shader.RWTextures.push_back(Texture->GetKernelView());
		return Shader;
	}

	FTextureRHIRef Texture = MakeTexture(FIntPoint(300, 41), PF_R32_FLOAT);
	FRHICommandListImmediate RHICmdList;
};

} // namespace

TEST_F(Dispatch, EveryThreadRunsOnceInWholeGroups)
{
	RHICmdList.SetBoundComputeShader(Bind(Increment));
	RHICmdList.DispatchComputeShader(38, 11, 1);
	for (int32 Index = 0; Index < 300 * 41; ++Index)
	{
		ASSERT_EQ(1.0f, Texture->ReadTexel(Index % 300, Index / 300).R);
	}
	EXPECT_EQ(38 * 8 * 11 * 4 - 300 * 41, GOutside);
	EXPECT_EQ(0, GCutGroups);
}

TEST_F(Dispatch, AGroupWiderThanATileIsNotCut)
{
	RHICmdList.SetBoundComputeShader(Bind(Increment, FIntVector(1024, 1, 1)));
	RHICmdList.DispatchComputeShader(1, 41, 1);
	EXPECT_EQ(1.0f, Texture->ReadTexel(299, 40).R);
}

TEST_F(Dispatch, WithoutAShaderIsChecked)
{
	EXPECT_THROW(RHICmdList.DispatchComputeShader(1, 1, 1), FCheckFailure);
}

TEST_F(Dispatch, APixelShaderIsChecked)
{
	RHICmdList.SetBoundComputeShader(MakeShader(EShaderStage::Pixel, Increment));
	EXPECT_THROW(RHICmdList.DispatchComputeShader(1, 1, 1), FCheckFailure);
}

TEST_F(Dispatch, APipelineStateForgetsTheShader)
{
	RHICmdList.SetBoundComputeShader(Bind(Increment));
	RHICmdList.SetComputePipelineState(nullptr);
	EXPECT_THROW(RHICmdList.DispatchComputeShader(1, 1, 1), FCheckFailure);
}

TEST_F(Dispatch, NoGroupsRunNothing)
{
	RHICmdList.SetBoundComputeShader(Bind(Increment));
	RHICmdList.DispatchComputeShader(4, 0, 1);
	EXPECT_EQ(0.0f, Texture->ReadTexel(0, 0).R);
	EXPECT_EQ(0u, RHICmdList.GetCounters().Pixels);
}

TEST_F(Dispatch, TooManyGroupsAreChecked)
{
	RHICmdList.SetBoundComputeShader(Bind(Increment));
	EXPECT_THROW(RHICmdList.DispatchComputeShader(65536, 1, 1), FCheckFailure);
}

TEST_F(Dispatch, IndirectReadsItsCounts)
{
	const FBufferRHIRef Arguments = RHICreateStructuredBuffer(4, 16, BUF_DrawIndirect, TEXT("Arguments"));
	const uint32 Counts[4] = {99, 1, 2, 1};
	std::memcpy(Arguments->GetData(), Counts, sizeof(Counts));
	RHICmdList.SetBoundComputeShader(Bind(Increment));
	RHICmdList.DispatchIndirectComputeShader(Arguments, 4);
	EXPECT_EQ(1.0f, Texture->ReadTexel(7, 7).R);
	EXPECT_EQ(0.0f, Texture->ReadTexel(8, 0).R);
}

TEST_F(Dispatch, FloatShadersFlushDenormalsAndDoubleOnesDoNot)
{
	FBoundShader Float = Bind(StoreHalfOfSmallestNormal);
	FBoundShader Double = Bind(StoreHalfOfSmallestNormal);
	Double.bDouble = true;
	RHICmdList.SetBoundComputeShader(std::move(Float));
	RHICmdList.DispatchComputeShader(1, 1, 1);
	EXPECT_EQ(0.0f, Texture->ReadTexel(0, 0).R);
	RHICmdList.SetBoundComputeShader(std::move(Double));
	RHICmdList.DispatchComputeShader(1, 1, 1);
	EXPECT_EQ(std::numeric_limits<float>::min() / 2, Texture->ReadTexel(0, 0).R);
}

TEST_F(Dispatch, CountersNameTheShaderAndCountItsThreads)
{
	RHICmdList.SetBoundComputeShader(Bind(Increment));
	RHICmdList.DispatchComputeShader(2, 1, 1);
	const FPassCounters& Counters = RHICmdList.GetCounters();
	EXPECT_EQ("FTestShader", Counters.Shader);
	EXPECT_EQ("Main", Counters.Entry);
	EXPECT_EQ(64u, Counters.Pixels);
	EXPECT_EQ(3u * 64, Counters.Taps);
	EXPECT_EQ(4u * 64, Counters.BytesWritten);
}

TEST_F(Dispatch, CountersCountViewsBoundForReading)
{
	const FTextureRHIRef Source = MakeTexture(Make2D(FIntPoint(8, 8), PF_FloatRGBA, 2));
	FBoundShader Shader = Bind(Increment);
	Shader.Textures.push_back(Source->GetKernelView());
	RHICmdList.SetBoundComputeShader(std::move(Shader));
	RHICmdList.DispatchComputeShader(1, 1, 1);
	EXPECT_EQ(8u * (64 + 16), RHICmdList.GetCounters().BytesRead);
	RHICmdList.ResetCounters();
	EXPECT_EQ(0u, RHICmdList.GetCounters().BytesRead);
}

TEST_F(Dispatch, WhatTheTextDoesNotSayIsMeasured)
{
	FBoundShader Shader = Bind(Increment);
	FShaderReflection Reflection = Shader.GetReflection();
	Reflection.StaticSamples = -1;
	Shader.Reflection = std::make_shared<const FShaderReflection>(Reflection);
	RHICmdList.SetBoundComputeShader(std::move(Shader));
	RHICmdList.DispatchComputeShader(1, 1, 1);
	EXPECT_EQ(8u + 1, RHICmdList.GetCounters().Taps);
	EXPECT_EQ(ETapCount::Measured, RHICmdList.GetCounters().TapCount);

	RHICmdList.SetBoundComputeShader(Bind(Increment)); // 3 in each thread, by its text
	RHICmdList.DispatchComputeShader(1, 1, 1);
	EXPECT_EQ(8u + 1 + 3 * 32, RHICmdList.GetCounters().Taps);
	EXPECT_EQ(ETapCount::Measured, RHICmdList.GetCounters().TapCount);
}

TEST_F(Dispatch, TapsOfAHandWrittenKernelAreThoseOfTheTextOrUnknown)
{
	FBoundShader Shader = Bind(Increment);
	Shader.Native = [](const FNativeKernelArgs& Args, const FKernelTile&)
	{
		EXPECT_EQ(nullptr, Args.GetArgs().Counters);
	};
	RHICmdList.SetBoundComputeShader(std::move(Shader));
	RHICmdList.DispatchComputeShader(1, 1, 1);
	EXPECT_EQ(3u * 32, RHICmdList.GetCounters().Taps);
	EXPECT_EQ(ETapCount::Static, RHICmdList.GetCounters().TapCount);

	Shader = Bind(Increment);
	FShaderReflection Reflection = Shader.GetReflection();
	Reflection.StaticSamples = -1;
	Shader.Reflection = std::make_shared<const FShaderReflection>(Reflection);
	Shader.Native = [](const FNativeKernelArgs&, const FKernelTile&) {
	};
	RHICmdList.SetBoundComputeShader(std::move(Shader));
	RHICmdList.DispatchComputeShader(1, 1, 1);
	EXPECT_EQ(ETapCount::Unknown, RHICmdList.GetCounters().TapCount);
}
