// Running graphs: order, contents, what leaves the graph, memory. A little past 500 lines: the cases share one set of
// helpers, which no other file needs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "GraphTestBuilder.h"

using namespace Drydock;

// Order -------------------------------------------------------------------------------------------------------------

TEST(Execute, PassesRunInTheOrderTheyWereAdded)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	Graph.Pass("B").Writes("Y");
	Graph.Pass("C").Reads("Y").Reads("X").Writes("Z");
	Graph.Extract("Z");
	EXPECT_EQ("A B C", Graph.Run());
}

TEST(Execute, LambdasRunInExecuteOnly)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	Graph.Extract("X");
	EXPECT_EQ("", Graph.Log);
	EXPECT_EQ("A", Graph.Run());
}

TEST(Execute, CulledPassesDoNotRun)
{
	FGraphTest Graph;
	FRDGPassRef Unread = nullptr;
	Graph.Pass("A").Writes("X");
	Graph.Pass("B").Writes("Y").Into(Unread);
	Graph.Extract("X");
	EXPECT_EQ("A", Graph.Run());
	EXPECT_TRUE(Unread->IsCulled());
	EXPECT_TRUE(Graph.Textures["Y"]->IsCulled());
}

TEST(Execute, WithoutCullingAllRun)
{
	const FScopedConsoleVariable Off(TEXT("r.RDG.CullPasses"), 0);
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	Graph.Pass("B").Writes("Y");
	Graph.Extract("X");
	EXPECT_EQ("A B", Graph.Run());
}

TEST(Execute, AManualDependencyKeepsAPass)
{
	FGraphTest Graph;
	FRDGPassRef A = nullptr;
	FRDGPassRef B = nullptr;
	Graph.Pass("A").Writes("X").Into(A);
	Graph.Pass("B").Writes("Y").Into(B);
	Graph.Builder->AddPassDependency(A, B);
	Graph.Extract("Y");
	EXPECT_EQ("A B", Graph.Run());
}

TEST(Execute, APassWithoutParametersAlwaysRuns)
{
	FGraphTest Graph;
	bool bRan = false;
	Graph.Builder->AddPass(
		RDG_EVENT_NAME("Note"), ERDGPassFlags::None, [&bRan](FRHICommandListImmediate&) { bRan = true; });
	Graph.Run();
	EXPECT_TRUE(bRan);
}

TEST(Execute, LambdasMayTakeEachKindOfCommandList)
{
	FGraphTest Graph;
	int32 NumRuns = 0;
	Graph.Builder->AddPass(RDG_EVENT_NAME("A"), ERDGPassFlags::None, [&](FRHIComputeCommandList&) { ++NumRuns; });
	Graph.Builder->AddPass(RDG_EVENT_NAME("B"), ERDGPassFlags::None, [&](FRHICommandList&) { ++NumRuns; });
	Graph.Builder->AddPass(RDG_EVENT_NAME("C"), ERDGPassFlags::None, [&](FRHICommandListImmediate&) { ++NumRuns; });
	Graph.Builder->AddPass(
		RDG_EVENT_NAME("D"), ERDGPassFlags::None, [&](FRDGAsyncTask, FRHIComputeCommandList&) { ++NumRuns; });
	Graph.Run();
	EXPECT_EQ(4, NumRuns);
}

TEST(Execute, MoveOnlyCapturesAreTaken)
{
	FGraphTest Graph;
	int32 Seen = 0;
	Graph.Builder->AddPass(RDG_EVENT_NAME("A"), ERDGPassFlags::None,
		[Owned = std::make_unique<int32>(5), &Seen](FRHICommandList&) { Seen = *Owned; });
	Graph.Run();
	EXPECT_EQ(5, Seen);
}

TEST(Execute, AnExceptionOfALambdaLeavesTheListUsable)
{
	{
		FGraphTest Graph;
		Graph.Pass("A").Renders("X").Does([](FRHICommandListImmediate&) { throw std::runtime_error("in the pass"); });
		Graph.Extract("X");
		EXPECT_THROW(Graph.Run(), std::runtime_error);
	}
	EXPECT_TRUE(FRHICommandListExecutor::GetImmediateCommandList().IsOutsideRenderPass());
	FGraphTest Next;
	Next.Pass("B").Renders("X").Value(2);
	Next.Extract("X");
	Next.Run();
	EXPECT_EQ(2.0f, Next.Pixel("X"));
}

// Contents ----------------------------------------------------------------------------------------------------------

TEST(Execute, ValuesFlowFromPassToPass)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X").Value(2);
	Graph.Pass("B").Reads("X").Writes("Y").Value(3);
	Graph.Pass("C").Reads("X").Reads("Y").Writes("Z").Value(4);
	Graph.Extract("Z");
	Graph.Run();
	EXPECT_EQ(2.0f + (2.0f + 3.0f) + 4.0f, Graph.Pixel("Z", 3, 3));
}

TEST(Execute, MipsAreWrittenAndReadOneByOne)
{
	FGraphTest Graph;
	Graph.Texture("X", 2);
	Graph.Pass("A").Writes("X", 0).Value(2);
	Graph.Pass("B").ReadsMip("X", 0).Writes("X", 1).Value(3);
	Graph.Extract("X");
	Graph.Run();
	EXPECT_EQ(2.0f, Graph.Pixel("X", 3, 3, 0));
	EXPECT_EQ(5.0f, Graph.Pixel("X", 1, 1, 1));
}

TEST(Execute, AClearGivesTheTexturesClearValue)
{
	FGraphTest Graph;
	Graph.Pass("A").Renders("X", ERenderTargetLoadAction::EClear).Does([](FRHICommandListImmediate&) {});
	Graph.Extract("X");
	Graph.Run();
	EXPECT_EQ(0.25f, Graph.Pixel("X", 2, 1));
}

TEST(Execute, ALoadKeepsWhatWasThere)
{
	FGraphTest Graph;
	Graph.Pass("A").Renders("X").Value(7);
	Graph.Pass("B").Renders("X", ERenderTargetLoadAction::ELoad).Does([](FRHICommandListImmediate&) {});
	Graph.Extract("X");
	EXPECT_EQ("A B", Graph.Run());
	EXPECT_EQ(7.0f, Graph.Pixel("X"));
}

TEST(Execute, ARasterPassRunsInsideARenderPass)
{
	FGraphTest Graph;
	bool bInside = false;
	Graph.Pass("A").Renders("X").Does(
		[&](FRHICommandListImmediate& RHICmdList) { bInside = RHICmdList.IsInsideRenderPass(); });
	Graph.Extract("X");
	Graph.Run();
	EXPECT_TRUE(bInside);
}

TEST(Execute, SkipRenderPassLeavesItToTheLambda)
{
	FGraphTest Graph;
	bool bInside = true;
	Graph.Pass("A")
		.Renders("X")
		.AddFlags(ERDGPassFlags::SkipRenderPass)
		.Does([&](FRHICommandListImmediate& RHICmdList) { bInside = RHICmdList.IsInsideRenderPass(); });
	Graph.Extract("X");
	Graph.Run();
	EXPECT_FALSE(bInside);
}

// What comes and goes -----------------------------------------------------------------------------------------------

TEST(Execute, ExtractionIsWrittenAtTheEnd)
{
	FGraphTest Graph;
	bool bWrittenEarly = true;
	Graph.Pass("A").Writes("X").Does([&](FRHICommandListImmediate&) { bWrittenEarly = Graph.Pooled["X"].IsValid(); });
	Graph.Extract("X");
	EXPECT_FALSE(Graph.Pooled["X"].IsValid());
	Graph.Run();
	EXPECT_FALSE(bWrittenEarly);
	EXPECT_TRUE(Graph.Pooled["X"].IsValid());
}

TEST(Execute, ATextureMayBeExtractedTwice)
{
	FGraphTest Graph;
	TRefCountPtr<IPooledRenderTarget> Second;
	Graph.Pass("A").Writes("X");
	Graph.Extract("X");
	Graph.Builder->QueueTextureExtraction(Graph.Texture("X"), &Second);
	Graph.Run();
	EXPECT_EQ(Graph.Pooled["X"].GetReference(), Second.GetReference());
	EXPECT_TRUE(Second.IsValid());
}

TEST(Execute, WhatWasExtractedOutlivesTheGraphAndTheNextOne)
{
	TRefCountPtr<IPooledRenderTarget> Kept;
	{
		FGraphTest Graph;
		Graph.Pass("A").Writes("X").Value(9);
		Graph.Extract("X");
		Graph.Run();
		Kept = Graph.Pooled["X"];
	}
	FGraphTest Next;
	Next.Pass("B").Writes("X").Value(1);
	Next.Pass("C").Reads("X").Writes("Y");
	Next.Extract("Y");
	Next.Run();
	EXPECT_EQ(9.0f, Kept->GetRHI()->ReadTexel(0, 0).R);
}

TEST(Execute, AnExternalTextureIsReadAndWrittenInPlace)
{
	FGraphTest Graph;
	Graph.External("History", 5);
	Graph.Pass("A").Reads("History").Writes("X").Value(1);
	Graph.Pass("B").Reads("X").Writes("History").Value(10);
	EXPECT_EQ("A B", Graph.Run());
	EXPECT_EQ(16.0f, Graph.Pixel("History"));
}

TEST(Execute, RegisteringOneTextureTwiceGivesOneResource)
{
	FGraphTest Graph;
	FRDGTextureRef First = Graph.External("X");
	FRDGTextureRef Second = Graph.Builder->RegisterExternalTexture(Graph.Pooled["X"], TEXT("Other"));
	EXPECT_EQ(First, Second);
	EXPECT_STREQ("X", Second->Name);
}

TEST(Execute, AnExternalTextureIsFoundByItsRHITexture)
{
	FGraphTest Graph;
	FRDGTextureRef X = Graph.External("X");
	EXPECT_EQ(X, Graph.Builder->FindExternalTexture(Graph.Pooled["X"]->GetRHI()));
	EXPECT_EQ(X, Graph.Builder->FindExternalTexture(Graph.Pooled["X"].GetReference()));
	EXPECT_EQ(nullptr, Graph.Builder->FindExternalTexture(static_cast<FRHITexture*>(nullptr)));
}

TEST(Execute, AnExternalTextureMayBeExtracted)
{
	FGraphTest Graph;
	Graph.External("X", 3);
	TRefCountPtr<IPooledRenderTarget> Out;
	Graph.Builder->QueueTextureExtraction(Graph.Texture("X"), &Out);
	Graph.Run();
	EXPECT_EQ(Graph.Pooled["X"].GetReference(), Out.GetReference());
}

TEST(Execute, ConvertingToExternalGivesTheTextureAtOnceAndKeepsItsWriter)
{
	FGraphTest Graph;
	const TRefCountPtr<IPooledRenderTarget> Pooled = Graph.Builder->ConvertToExternalTexture(Graph.Texture("X"));
	ASSERT_TRUE(Pooled.IsValid());
	Graph.Pass("A").Writes("X").Value(8);
	EXPECT_EQ("A", Graph.Run());
	EXPECT_EQ(8.0f, Pooled->GetRHI()->ReadTexel(0, 0).R);
}

TEST(Execute, GetPooledTextureIsOfExternalTexturesOnly)
{
	FGraphTest Graph;
	Graph.External("X");
	EXPECT_EQ(Graph.Pooled["X"].GetReference(), Graph.Builder->GetPooledTexture(Graph.Texture("X")).GetReference());
	EXPECT_THROW(Graph.Builder->GetPooledTexture(Graph.Texture("Y")), FError);
}

TEST(Execute, ExternalAccessModeOpensAResourceToCodeThatDoesNotDeclareIt)
{
	FGraphTest Graph;
	float Seen = 0;
	Graph.Pass("A").Writes("X").Value(6);
	FRDGTextureRef X = Graph.Texture("X");
	Graph.Builder->UseExternalAccessMode(X, ERHIAccess::SRVMask);
	Graph.Builder->AddPass(RDG_EVENT_NAME("Peek"), ERDGPassFlags::None,
		[&, X](FRHICommandList&) { Seen = X->GetRHI()->ReadTexel(0, 0).R; });
	Graph.Run();
	EXPECT_EQ(6.0f, Seen);
}

TEST(Execute, InternalAccessModeClosesItAgain)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	FRDGTextureRef X = Graph.Texture("X");
	Graph.Builder->UseExternalAccessMode(X, ERHIAccess::SRVMask);
	Graph.Builder->UseInternalAccessMode(X);
	Graph.Builder->AddPass(RDG_EVENT_NAME("Peek"), ERDGPassFlags::None, [X](FRHICommandList&) { X->GetRHI(); });
	EXPECT_EQ("2030", Graph.RunForErrors());
}

// Buffers -----------------------------------------------------------------------------------------------------------

namespace
{

/** Runs a pass that copies a buffer's first words. */
std::vector<uint32> ReadWords(FGraphTest& Graph, FRDGBufferRef Buffer, int32 Count)
{
	std::vector<uint32> Words;
	Graph.Pass("Read")
		.AccessesBuffer(Buffer, ERHIAccess::SRVCompute)
		.AddFlags(ERDGPassFlags::NeverCull)
		.Does(
			[&Words, Buffer, Count](FRHICommandListImmediate&)
			{
				const auto* Data = reinterpret_cast<const uint32*>(Buffer->GetRHI()->GetData());
				Words.assign(Data, Data + Count);
			});
	Graph.Run();
	return Words;
}

} // namespace

TEST(Execute, AnUploadIsCopiedWhenItIsQueued)
{
	FGraphTest Graph;
	std::vector<uint32> Data = {1, 2, 3};
	FRDGBufferRef Buffer = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 3), TEXT("B"));
	Graph.Builder->QueueBufferUpload(Buffer, Data.data(), 12);
	Data = {7, 7, 7};
	EXPECT_THAT(ReadWords(Graph, Buffer, 3), testing::ElementsAre(1, 2, 3));
}

TEST(Execute, AnUploadWithoutCopyIsReadWhenTheGraphRuns)
{
	FGraphTest Graph;
	std::vector<uint32> Data = {1, 2, 3};
	FRDGBufferRef Buffer = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 3), TEXT("B"));
	Graph.Builder->QueueBufferUpload(Buffer, Data.data(), 12, ERDGInitialDataFlags::NoCopy);
	Data = {7, 8, 9};
	EXPECT_THAT(ReadWords(Graph, Buffer, 3), testing::ElementsAre(7, 8, 9));
}

TEST(Execute, AShortUploadLeavesZeros)
{
	FGraphTest Graph;
	const uint32 Data[] = {1};
	FRDGBufferRef Buffer = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 3), TEXT("B"));
	Graph.Builder->QueueBufferUpload(Buffer, Data, 4);
	EXPECT_THAT(ReadWords(Graph, Buffer, 3), testing::ElementsAre(1, 0, 0));
}

TEST(Execute, TheElementCountOfABufferIsAskedForWhenTheGraphRuns)
{
	FGraphTest Graph;
	uint32 Count = 1;
	FRDGBufferRef Buffer =
		Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 1), TEXT("B"), [&Count] { return Count; });
	Count = 5;
	uint32 Size = 0;
	Graph.Pass("A")
		.AccessesBuffer(Buffer, ERHIAccess::UAVCompute)
		.AddFlags(ERDGPassFlags::NeverCull)
		.Does([&Size, Buffer](FRHICommandListImmediate&) { Size = Buffer->GetRHI()->GetSize(); });
	Graph.Run();
	EXPECT_EQ(20u, Size);
}

TEST(Execute, ABufferIsExtractedAndRegisteredAgain)
{
	TRefCountPtr<FRDGPooledBuffer> Kept;
	{
		FGraphTest Graph;
		FRDGBufferRef Buffer = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 2), TEXT("B"));
		Graph.Pass("A")
			.AccessesBuffer(Buffer, ERHIAccess::UAVCompute)
			.Does([Buffer](FRHICommandListImmediate&)
				{ reinterpret_cast<uint32*>(Buffer->GetRHI()->GetData())[1] = 42; });
		Graph.Builder->QueueBufferExtraction(Buffer, &Kept);
		Graph.Run();
	}
	ASSERT_TRUE(Kept.IsValid());
	FGraphTest Next;
	EXPECT_EQ(42u, ReadWords(Next, Next.Builder->RegisterExternalBuffer(Kept), 2)[1]);
}

// Memory ------------------------------------------------------------------------------------------------------------

TEST(Execute, TransientTexturesThatNeverMeetShareMemory)
{
	FGraphTest Graph;
	const uint8* First = nullptr;
	const uint8* Second = nullptr;
	FRDGTextureRef X = Graph.Texture("X");
	FRDGTextureRef Y = Graph.Texture("Y");
	Graph.Pass("A")
		.Writes("X")
		.AddFlags(ERDGPassFlags::NeverCull)
		.Does([&, X](FRHICommandListImmediate&) { First = X->GetRHI()->GetTexel(0, 0); });
	Graph.Pass("B")
		.Writes("Y")
		.AddFlags(ERDGPassFlags::NeverCull)
		.Does([&, Y](FRHICommandListImmediate&) { Second = Y->GetRHI()->GetTexel(0, 0); });
	Graph.Run();
	EXPECT_EQ(First, Second);
	EXPECT_TRUE(X->IsTransient());
}

TEST(Execute, WithLifetimesExtendedTheyDoNot)
{
	for (const TCHAR* Name :
		{TEXT("r.RDG.Debug.ExtendResourceLifetimes"), TEXT("r.RDG.Debug.DisableTransientResources")})
	{
		const FScopedConsoleVariable Apart(Name, 1);
		FGraphTest Graph;
		const uint8* First = nullptr;
		const uint8* Second = nullptr;
		FRDGTextureRef X = Graph.Texture("X");
		FRDGTextureRef Y = Graph.Texture("Y");
		Graph.Pass("A")
			.Writes("X")
			.AddFlags(ERDGPassFlags::NeverCull)
			.Does([&, X](FRHICommandListImmediate&) { First = X->GetRHI()->GetTexel(0, 0); });
		Graph.Pass("B")
			.Writes("Y")
			.AddFlags(ERDGPassFlags::NeverCull)
			.Does([&, Y](FRHICommandListImmediate&) { Second = Y->GetRHI()->GetTexel(0, 0); });
		Graph.Run();
		EXPECT_NE(First, Second) << Name;
	}
}

TEST(Execute, WithoutTheTransientAllocatorNothingIsTransient)
{
	const FScopedConsoleVariable Off(TEXT("r.RDG.TransientAllocator"), 0);
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	Graph.Pass("B").Reads("X").Writes("Y");
	Graph.Extract("Y");
	EXPECT_EQ(0u, Graph.Builder->Compile().Memory.TransientPeakBytes);
	Graph.Run();
	EXPECT_FALSE(Graph.Textures["X"]->IsTransient());
	EXPECT_EQ(2.0f, Graph.Pixel("Y"));
}

TEST(Execute, FastVRAMAloneIsTransientInMode2)
{
	const FScopedConsoleVariable FastOnly(TEXT("r.RDG.TransientAllocator"), 2);
	FGraphTest Graph;
	FRDGTextureDesc Fast = FGraphTest::MakeDesc();
	Fast.Flags |= TexCreate_FastVRAM;
	Graph.Texture("Fast", Fast);
	Graph.Pass("A").Writes("Fast");
	Graph.Pass("B").Reads("Fast").Writes("X");
	Graph.Pass("C").Reads("X").Writes("Y");
	Graph.Extract("Y");
	const FRDGCompiledGraph Compiled = Graph.Builder->Compile();
	EXPECT_TRUE(Compiled.FindResource("Fast")->bTransient);
	EXPECT_FALSE(Compiled.FindResource("X")->bTransient);
}

TEST(Execute, SharedExternalAndExtractedTexturesAreNotTransient)
{
	FGraphTest Graph;
	FRDGTextureDesc Shared = FGraphTest::MakeDesc();
	Shared.Flags |= TexCreate_Shared;
	Graph.Texture("Shared", Shared);
	Graph.External("In");
	Graph.Pass("A").Reads("In").Writes("Shared");
	Graph.Pass("B").Reads("Shared").Writes("Y");
	Graph.Extract("Y");
	for (const FRDGCompiledResource& Resource : Graph.Builder->Compile().Resources)
	{
		EXPECT_FALSE(Resource.bTransient) << Resource.Name;
	}
}

TEST(Execute, ParametersAndObjectsLiveAsLongAsTheGraph)
{
	static int32 NumAlive = 0;
	struct FCounted
	{
		FCounted() { ++NumAlive; }
		~FCounted() { --NumAlive; }
	};
	{
		FGraphTest Graph;
		Graph.Builder->AllocObject<FCounted>();
		Graph.Run();
		EXPECT_EQ(1, NumAlive);
	}
	EXPECT_EQ(0, NumAlive);
}

TEST(Execute, GraphMemoryIsAlignedAndZeroed)
{
	FGraphTest Graph;
	for (const uint32 Alignment : {1u, 16u, 64u, 256u})
	{
		const auto* Memory = static_cast<const uint8*>(Graph.Builder->Alloc(100, Alignment));
		EXPECT_EQ(0u, reinterpret_cast<uintptr_t>(Memory) % Alignment);
		EXPECT_TRUE(std::all_of(Memory, Memory + 100, [](uint8 Byte) { return Byte == 0; }));
	}
	EXPECT_NE(nullptr, Graph.Builder->Alloc(1 << 20));
}
