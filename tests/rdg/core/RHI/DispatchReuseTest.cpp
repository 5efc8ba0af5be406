// Draws and dispatches are taken from the cache when all that decides their results is the same, and give the same
// bits.
#include "DispatchObserver.h"
#include "DispatchReuseTestHelpers.h"

using namespace Drydock;
using namespace Drydock::Tests;

namespace
{

/** The change of one part of a draw. */
struct FChange
{
	const char* Name;
	void (*Make)(FPass& Pass);
};

void PrintTo(const FChange& Change, std::ostream* Stream)
{
	*Stream << Change.Name;
}

class DispatchReuseChange : public DispatchReuse, public testing::WithParamInterface<FChange>
{
};

} // namespace

TEST_F(DispatchReuse, TheSameDispatchIsTakenFromTheCache)
{
	EXPECT_TRUE(Runs([&] { Dispatch({.Input = In}, *Out); }));
	const std::vector<float> First = Read(*Out);
	Out->Fill(FLinearColor(9, 9, 9, 9));
	Out->Fill(FLinearColor(0, 0, 0, 0)); // as before the first
	RHICmdList.ResetCounters();
	EXPECT_TRUE(Runs([&] { Dispatch({.Input = In}, *Out); })) << "zeros by a fill have another hash than by a look";
	Out->Fill(FLinearColor(0, 0, 0, 0));
	RHICmdList.ResetCounters();
	EXPECT_FALSE(Runs([&] { Dispatch({.Input = In}, *Out); }));
	EXPECT_EQ(First, Read(*Out));
	EXPECT_EQ(1.0f + 39.0f, Out->ReadTexel(39, 23).R);
	EXPECT_EQ(1u, RHICmdList.GetCounters().Dispatches);
	EXPECT_EQ(1u, RHICmdList.GetCounters().Reused);
}

TEST_F(DispatchReuse, CountersAreThoseOfTheFirst)
{
	const auto Frame = [&]
	{
		Draw({.Input = In}, *Out);
	};
	Runs(Frame);
	const FPassCounters First = RHICmdList.GetCounters();
	RHICmdList.ResetCounters();
	EXPECT_FALSE(Runs(Frame));
	const FPassCounters& Second = RHICmdList.GetCounters();
	EXPECT_EQ(First.Taps, Second.Taps);
	EXPECT_EQ(First.TapCount, Second.TapCount);
	EXPECT_EQ(First.Ran, Second.Ran);
	EXPECT_EQ(First.Pixels, Second.Pixels);
	EXPECT_EQ(First.BytesRead, Second.BytesRead);
	EXPECT_EQ(First.BytesWritten, Second.BytesWritten);
	EXPECT_EQ(First.Writes.size(), Second.Writes.size());
}

TEST_P(DispatchReuseChange, RunsTheDrawAgainAndGivesTheBitsOfARunWithoutACache)
{
	FPass Pass;
	Pass.Input = In;
	EXPECT_TRUE(Runs([&] { Draw(Pass, *Out); }));
	EXPECT_FALSE(Runs([&] { Draw(Pass, *Out); }));
	GetParam().Make(Pass);
	EXPECT_TRUE(Runs([&] { Draw(Pass, *Out); }));
	const std::vector<float> Cached = Read(*Out);

	const FTextureRHIRef Plain = MakeTexture(FIntPoint(40, 24), PF_R32_FLOAT);
	FPass First;
	First.Input = In;
	Draw(First, *Plain);
	Draw(Pass, *Plain);
	EXPECT_EQ(Read(*Plain), Cached);
}

INSTANTIATE_TEST_SUITE_P(Each, DispatchReuseChange,
	testing::Values(FChange{"Constant",
						[](FPass& Pass)
						{
							Pass.Constant = 2;
						}},
		FChange{"Shader",
			[](FPass& Pass)
			{
				Pass.Key = "another";
			}},
		FChange{"Sampler",
			[](FPass& Pass)
			{
				Pass.Sampler.AddressU = EKernelAddress::Mirror;
			}},
		FChange{"SamplerBias",
			[](FPass& Pass)
			{
				Pass.Sampler.MipBias = 1;
			}},
		FChange{"Rect",
			[](FPass& Pass)
			{
				Pass.Rect.Max.X = 39;
			}},
		FChange{"Blend",
			[](FPass& Pass)
			{
				Pass.bBlend = true;
			}},
		FChange{"Discard",
			[](FPass& Pass)
			{
				Pass.bDiscards = true;
			}},
		FChange{"Interpolant",
			[](FPass& Pass)
			{
				Pass.Interpolant.X = 1;
			}},
		FChange{"NoInput",
			[](FPass& Pass)
			{
				Pass.Input = nullptr;
			}}),
	[](const testing::TestParamInfo<FChange>& Info) { return Info.param.Name; });

TEST_F(DispatchReuse, EveryWayOfWritingAnInputIsSeen)
{
	const auto Frame = [&]
	{
		Draw({.Input = In}, *Out);
	};
	const FTextureRHIRef Other = MakeTexture(FIntPoint(40, 24), PF_R32_FLOAT);
	Other->WriteTexel(3, 3, FLinearColor(5, 5, 5, 5));
	const float Four = 4;
	uint32 Stride = 0;
	const std::pair<const char*, std::function<void()>> Ways[] = {
		{"the first frame",
			[] {
			}},
		{"WriteTexel",
			[&]
			{
				In->WriteTexel(1, 2, FLinearColor(1, 1, 1, 1));
			}},
		{"WriteRow",
			[&]
			{
				In->WriteRow(2, 2, TArray<FLinearColor>({FLinearColor(2, 2, 2, 2)}));
			}},
		{"Fill",
			[&]
			{
				In->Fill(FLinearColor(3, 3, 3, 3));
			}},
		{"a part filled",
			[&]
			{
				In->FillRect(&Four, FIntRect(0, 0, 1, 1), 0);
			}},
		{"a copy",
			[&]
			{
				RHICmdList.CopyTexture(Other, In, FRHICopyTextureInfo());
			}},
		{"CopyFrom",
			[&]
			{
				Other->WriteTexel(4, 4, FLinearColor(6, 6, 6, 6));
				In->CopyFrom(*Other);
			}},
		{"a lock",
			[&]
			{
				void* const Texels = RHICmdList.LockTexture2D(In, 0, RLM_WriteOnly, Stride);
				In->GetMipHash(0); // as a pass that reads it meanwhile
				std::memcpy(static_cast<uint8*>(Texels) + Stride, &Four, sizeof(Four));
				RHICmdList.UnlockTexture2D(In, 0);
			}},
		{"an update",
			[&]
			{
				RHICmdList.UpdateTexture2D(
					In, 0, FUpdateTextureRegion2D(7, 7, 0, 0, 1, 1), 4, reinterpret_cast<const uint8*>(&Four));
			}},
		{"a clear",
			[&]
			{
				RHICmdList.ClearUAVFloat(RHICreateUnorderedAccessView(In), FVector4f(8, 0, 0, 0));
			}},
		{"a dispatch that is not known",
			[&]
			{
				FBoundShader Shader = Bind({.Constant = 20}, EShaderStage::Compute, &Store);
				Shader.RWTextures.push_back(In->GetKernelView());
				RHICmdList.SetBoundComputeShader(std::move(Shader));
				RHICmdList.DispatchComputeShader(5, 3, 1);
			}},
		{"a dispatch",
			[&]
			{
				Dispatch({.Constant = 30}, *In);
			}},
		{"other memory",
			[&]
			{
				alignas(64) static uint8 Memory[64 * 1024] = {};
				std::fill(std::begin(Memory), std::end(Memory), uint8(1));
				In->PlaceAt(Memory);
			}},
	};
	for (const auto& [Name, Write] : Ways)
	{
		Write();
		EXPECT_TRUE(Runs(Frame)) << Name;
		const std::vector<float> Cached = Read(*Out);
		Frame();
		EXPECT_EQ(Read(*Out), Cached) << Name;
		EXPECT_FALSE(Runs(Frame)) << Name;
		EXPECT_EQ(Read(*Out), Cached) << Name;
	}
}

TEST_F(DispatchReuse, TheSameContentIsTheSameWhoeverWroteIt)
{
	In->WriteTexel(1, 1, FLinearColor(7, 7, 7, 7));
	const FTextureRHIRef Like = In->Clone();
	EXPECT_TRUE(Runs([&] { Draw({.Input = In}, *Out); }));
	EXPECT_FALSE(Runs([&] { Draw({.Input = Like}, *Out); }));
	In->WriteTexel(1, 1, FLinearColor(7, 7, 7, 7));
	EXPECT_FALSE(Runs([&] { Draw({.Input = In}, *Out); }));
}

TEST_F(DispatchReuse, WhatIsWrittenInPlaceDependsOnWhatWasThere)
{
	const auto Frame = [&]
	{
		Dispatch({}, *Out, &AddToSome);
	};
	EXPECT_TRUE(Runs(Frame));
	EXPECT_EQ(1.0f, Out->ReadTexel(0, 0).R);
	EXPECT_TRUE(Runs(Frame));
	EXPECT_EQ(2.0f, Out->ReadTexel(0, 0).R);
	Out->Fill(FLinearColor(0, 0, 0, 0));
	EXPECT_TRUE(Runs(Frame));
	EXPECT_FALSE(Runs(Frame)) << "it has been done to ones before";
	EXPECT_EQ(2.0f, Out->ReadTexel(0, 0).R);
	Out->Fill(FLinearColor(0, 0, 0, 0));
	EXPECT_FALSE(Runs(Frame));
	EXPECT_FALSE(Runs(Frame));
	EXPECT_EQ(2.0f, Out->ReadTexel(0, 0).R);
	EXPECT_EQ(0.0f, Out->ReadTexel(1, 0).R);
}

TEST_F(DispatchReuse, ADrawOfAPartLeavesTheRest)
{
	FPass Part;
	Part.Rect = FIntRect(3, 2, 17, 9);
	EXPECT_TRUE(Runs([&] { Draw(Part, *Out); }));
	const std::vector<float> First = Read(*Out);
	Out->Fill(FLinearColor(50, 0, 0, 0));
	EXPECT_TRUE(Runs([&] { Draw(Part, *Out); }));
	EXPECT_EQ(50.0f, Out->ReadTexel(0, 0).R);
	EXPECT_EQ(First[2 * 40 + 3], Out->ReadTexel(3, 2).R);
	Out->Fill(FLinearColor(50, 0, 0, 0));
	EXPECT_FALSE(Runs([&] { Draw(Part, *Out); }));
	EXPECT_EQ(50.0f, Out->ReadTexel(0, 0).R);
	EXPECT_EQ(First[2 * 40 + 3], Out->ReadTexel(3, 2).R);
}

TEST_F(DispatchReuse, AMipIsKeptByItself)
{
	const FTextureRHIRef Mips = MakeTexture(Make2D(FIntPoint(40, 24), PF_R32_FLOAT, 2));
	const auto Frame = [&]
	{
		Dispatch({.Constant = 3}, *Mips, &Store, 0);
		Dispatch({.Constant = 4}, *Mips, &Store, 1);
	};
	Mips->Fill(FLinearColor(0, 0, 0, 0));
	EXPECT_TRUE(Runs(Frame));
	const std::vector<float> Large = Read(*Mips, 0), Small = Read(*Mips, 1);
	EXPECT_EQ(3.0f, Large[0]);
	EXPECT_EQ(4.0f, Small[0]);
	Mips->Fill(FLinearColor(0, 0, 0, 0));
	EXPECT_FALSE(Runs(Frame));
	EXPECT_EQ(Large, Read(*Mips, 0));
	EXPECT_EQ(Small, Read(*Mips, 1));
}

TEST_F(DispatchReuse, BuffersAreComparedByTheirBytes)
{
	const FBufferRHIRef Buffer = RHICreateStructuredBuffer(4, 64, BUF_UnorderedAccess, TEXT("Counts"));
	auto* const Value = reinterpret_cast<uint32*>(Buffer->GetData());
	const auto Frame = [&]
	{
		FBoundShader Shader = Bind({}, EShaderStage::Compute, &Count);
		Shader.RWBuffers.push_back(Buffer->GetKernelView());
		RHICmdList.SetBoundComputeShader(std::move(Shader));
		RHICmdList.DispatchComputeShader(1, 1, 1);
	};
	EXPECT_TRUE(Runs(Frame));
	EXPECT_TRUE(Runs(Frame));
	EXPECT_EQ(2u, *Value);
	*Value = 0;
	EXPECT_FALSE(Runs(Frame));
	EXPECT_EQ(1u, *Value);
	Value[15] = 1;
	EXPECT_TRUE(Runs(Frame));
	EXPECT_EQ(2u, *Value);
}

TEST_F(DispatchReuse, AShaderWithoutAKeyAlwaysRuns)
{
	const auto Frame = [&]
	{
		Draw({.Key = ""}, *Out);
	};
	EXPECT_TRUE(Runs(Frame));
	EXPECT_TRUE(Runs(Frame));
	EXPECT_EQ("the shader has no key", RHICmdList.GetCounters().NotReusable);
}

TEST_F(DispatchReuse, AnObserverSwitchesItOffUnlessItAllows)
{
	struct FLook : IDispatchObserver
	{
		explicit FLook(bool bInAllows)
			: bAllows(bInAllows)
		{
		}
		bool AllowsReuse() const override { return bAllows; }
		void AfterDispatch(const FBoundShader&, const FKernelArgs& Args, const FKernelTile&) override
		{
			Seen = *GetFloats(Args.Targets[0].Texture, 39, 23);
		}
		const bool bAllows;
		float Seen = 0;
	};
	const auto Frame = [&]
	{
		Draw({}, *Out);
	};
	Runs(Frame);
	{
		FLook Look(false);
		const FScopedDispatchObserver Scope(Look);
		EXPECT_TRUE(Runs(Frame));
		EXPECT_EQ(40.0f, Look.Seen);
	}
	Out->Fill(FLinearColor(0, 0, 0, 0));
	FLook Look(true);
	const FScopedDispatchObserver Scope(Look);
	EXPECT_FALSE(Runs(Frame));
	EXPECT_EQ(40.0f, Look.Seen);
}

TEST_F(DispatchReuse, ResultsThatNoFrameUsesGo)
{
	const auto Frame = [&]
	{
		Draw({.Constant = 1}, *Out);
	};
	EXPECT_TRUE(Runs(Frame));
	EXPECT_TRUE(Runs([&] { Draw({.Constant = 2}, *Out); }));
	for (uint64 Number = 0; Number < FReuseCache::KeptFrames; ++Number)
	{
		EXPECT_EQ(2u, Cache.GetNumResults());
		EXPECT_FALSE(Runs(Frame));
	}
	EXPECT_FALSE(Runs(Frame));
	EXPECT_EQ(1u, Cache.GetNumResults());
	EXPECT_EQ(uint64(40 * 24 * 4), Cache.GetBytes());
}

TEST_F(DispatchReuse, MemoryIsBoundedAndTheOldestGoesFirst)
{
	constexpr uint64 OneResult = 40 * 24 * 4;
	FReuseCache Small(3 * OneResult);
	const auto RunsIn = [&](float Constant)
	{
		const FScopedReuse Scope(&Small);
		const int32 Before = GNumTexels;
		Draw({.Constant = Constant}, *Out);
		EXPECT_LE(Small.GetBytes(), 3 * OneResult);
		return GNumTexels != Before;
	};
	for (const float Constant : {1.0f, 2.0f, 3.0f})
	{
		Small.BeginFrame();
		EXPECT_TRUE(RunsIn(Constant));
	}
	Small.BeginFrame();
	EXPECT_FALSE(RunsIn(1));
	Small.BeginFrame();
	EXPECT_TRUE(RunsIn(4)); // 2 goes
	EXPECT_FALSE(RunsIn(1));
	EXPECT_FALSE(RunsIn(3));
	EXPECT_EQ(3u, Small.GetNumResults());
	EXPECT_TRUE(RunsIn(2)) << "all others are of this frame, so there is no room";
	EXPECT_EQ("there is no memory for its result", RHICmdList.GetCounters().NotReusable);
	EXPECT_TRUE(RunsIn(2));
	Small.BeginFrame();
	EXPECT_TRUE(RunsIn(2));
	EXPECT_FALSE(RunsIn(2));
}
