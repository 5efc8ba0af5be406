// Immediate mode, clobbering, compiling without running, observers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "GraphTestBuilder.h"
#include "RenderGraphObserver.h"

#include <cmath>

using namespace Drydock;

// Immediate mode ----------------------------------------------------------------------------------------------------

TEST(ImmediateMode, APassRunsInsideAddPass)
{
	const FScopedConsoleVariable Immediate(TEXT("r.RDG.ImmediateMode"), 1);
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	EXPECT_EQ("A", Graph.Log);
	Graph.Pass("B").Reads("X").Writes("Y");
	EXPECT_EQ("A B", Graph.Log);
}

TEST(ImmediateMode, NothingIsCulled)
{
	const FScopedConsoleVariable Immediate(TEXT("r.RDG.ImmediateMode"), 1);
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	EXPECT_EQ("A", Graph.Run());
}

TEST(ImmediateMode, ExtractionIsWrittenInExecute)
{
	const FScopedConsoleVariable Immediate(TEXT("r.RDG.ImmediateMode"), 1);
	FGraphTest Graph;
	Graph.Pass("A").Writes("X").Value(4);
	Graph.Extract("X");
	EXPECT_FALSE(Graph.Pooled["X"].IsValid());
	Graph.Run();
	EXPECT_EQ(4.0f, Graph.Pixel("X"));
}

TEST(ImmediateMode, AMistakeIsThrownFromItsAddPass)
{
	const FScopedConsoleVariable Immediate(TEXT("r.RDG.ImmediateMode"), 1);
	FGraphTest Graph;
	Graph.External("X");
	EXPECT_THROW(Graph.Pass("A").Reads("X"), FError);
	EXPECT_EQ("", Graph.Log);
}

TEST(ImmediateMode, AnUploadIsThereForTheFirstPass)
{
	const FScopedConsoleVariable Immediate(TEXT("r.RDG.ImmediateMode"), 1);
	FGraphTest Graph;
	const uint32 Data[] = {11};
	uint32 Seen = 0;
	FRDGBufferRef Buffer = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 1), TEXT("B"));
	Graph.Builder->QueueBufferUpload(Buffer, Data, 4);
	Graph.Pass("A")
		.AccessesBuffer(Buffer, ERHIAccess::SRVCompute)
		.AddFlags(ERDGPassFlags::NeverCull)
		.Does([&Seen, Buffer](FRHICommandListImmediate&)
			{ Seen = *reinterpret_cast<const uint32*>(Buffer->GetRHI()->GetData()); });
	EXPECT_EQ(11u, Seen);
}

TEST(ImmediateMode, IsKnownToTheBuilder)
{
	EXPECT_FALSE(FRDGBuilder::IsImmediateMode());
	const FScopedConsoleVariable Immediate(TEXT("r.RDG.ImmediateMode"), 1);
	EXPECT_TRUE(FRDGBuilder::IsImmediateMode());
}

// Clobbering --------------------------------------------------------------------------------------------------------

namespace
{

/** What a texel holds that no pass wrote. */
float ReadUnwritten(int32 Mode, EPixelFormat Format = PF_R32_FLOAT)
{
	const FScopedConsoleVariable Clobber(TEXT("r.RDG.ClobberResources"), Mode);
	FGraphTest Graph;
	FRDGTextureDesc Desc = FGraphTest::MakeDesc();
	Desc.Format = Format;
	Graph.Texture("X", Desc);
	Graph.Pass("A").Writes("X").Does([](FRHICommandListImmediate&) {});
	Graph.Extract("X");
	Graph.Run();
	return Graph.Pixel("X", 3, 2);
}

} // namespace

TEST(Clobber, Mode1Is1000)
{
	EXPECT_EQ(1000.0f, ReadUnwritten(1));
}
TEST(Clobber, Mode2IsNaN)
{
	EXPECT_TRUE(std::isnan(ReadUnwritten(2)));
}
TEST(Clobber, Mode3IsInfinity)
{
	EXPECT_EQ(std::numeric_limits<float>::infinity(), ReadUnwritten(3));
}
TEST(Clobber, ValuesAreStoredAsTheFormatStoresThem)
{
	EXPECT_EQ(1.0f, ReadUnwritten(1, PF_R8));
}

TEST(Clobber, TransientTexturesAreFilledBeforeEachFirstUse)
{
	const FScopedConsoleVariable Clobber(TEXT("r.RDG.ClobberResources"), 1);
	FGraphTest Graph;
	float Seen = 0;
	FRDGTextureRef Y = Graph.Texture("Y");
	Graph.Pass("A").Writes("X").Value(5).AddFlags(ERDGPassFlags::NeverCull);
	Graph.Pass("B")
		.Writes("Y")
		.AddFlags(ERDGPassFlags::NeverCull)
		.Does([&, Y](FRHICommandListImmediate&) { Seen = Y->GetRHI()->ReadTexel(0, 0).R; });
	Graph.Run();
	EXPECT_EQ(1000.0f, Seen);
}

TEST(Clobber, ExternalTexturesAndUploadedBuffersAreSpared)
{
	const FScopedConsoleVariable Clobber(TEXT("r.RDG.ClobberResources"), 1);
	FGraphTest Graph;
	const uint32 Data[] = {3};
	uint32 Seen = 0;
	Graph.External("In", 2);
	FRDGBufferRef Buffer = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 1), TEXT("B"));
	Graph.Builder->QueueBufferUpload(Buffer, Data, 4);
	Graph.Pass("A").Reads("In").Writes("X").Value(1);
	Graph.Pass("B")
		.AccessesBuffer(Buffer, ERHIAccess::SRVCompute)
		.AddFlags(ERDGPassFlags::NeverCull)
		.Does([&Seen, Buffer](FRHICommandListImmediate&)
			{ Seen = *reinterpret_cast<const uint32*>(Buffer->GetRHI()->GetData()); });
	Graph.Extract("X");
	Graph.Run();
	EXPECT_EQ(3.0f, Graph.Pixel("X"));
	EXPECT_EQ(3u, Seen);
}

TEST(Clobber, BuffersAreFilledToo)
{
	const FScopedConsoleVariable Clobber(TEXT("r.RDG.ClobberResources"), 1);
	FGraphTest Graph;
	float Seen = 0;
	FRDGBufferRef Buffer = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 2), TEXT("B"));
	Graph.Pass("A")
		.AccessesBuffer(Buffer, ERHIAccess::UAVCompute)
		.AddFlags(ERDGPassFlags::NeverCull)
		.Does([&Seen, Buffer](FRHICommandListImmediate&)
			{ Seen = reinterpret_cast<const float*>(Buffer->GetRHI()->GetData())[1]; });
	Graph.Run();
	EXPECT_EQ(1000.0f, Seen);
}

TEST(Clobber, DepthAndStencilHaveTheirOwnValues)
{
	const FScopedConsoleVariable Clobber(TEXT("r.RDG.ClobberResources"), 2);
	FGraphTest Graph;
	const FRDGTextureDesc Desc = FRDGTextureDesc::Create2D(FIntPoint(4, 4), PF_DepthStencil,
		FClearValueBinding::DepthFar, TexCreate_DepthStencilTargetable | TexCreate_ShaderResource);
	FRDGTextureRef Depth = Graph.Texture("D", Desc);
	float SeenDepth = 0;
	uint8 SeenStencil = 0;
	Graph.Pass("A")
		.Accesses("D", ERHIAccess::DSVWrite)
		.Flags(ERDGPassFlags::Raster | ERDGPassFlags::SkipRenderPass | ERDGPassFlags::NeverCull)
		.Does(
			[&, Depth](FRHICommandListImmediate&)
			{
				SeenDepth = Depth->GetRHI()->ReadTexel(1, 1).R;
				SeenStencil = *Depth->GetRHI()->GetTexel(1, 1, 0, 0, 1);
			});
	Graph.Run();
	EXPECT_EQ(0.123456789f, SeenDepth);
	EXPECT_EQ(123, SeenStencil);
}

TEST(Clobber, TheResourceFilterChooses)
{
	const FScopedConsoleVariable Clobber(TEXT("r.RDG.ClobberResources"), 1);
	const FScopedConsoleVariable Filter(TEXT("r.RDG.Debug.ResourceFilter"), FString("Bloom"));
	FGraphTest Graph;
	Graph.External("Zero", 0);
	Graph.Pass("A").Writes("BloomX").Does([](FRHICommandListImmediate&) {});
	Graph.Extract("BloomX");
	Graph.Pass("B").Writes("Other").Does([](FRHICommandListImmediate&) {});
	Graph.Extract("Other");
	Graph.Run();
	EXPECT_EQ(1000.0f, Graph.Pixel("BloomX"));
	EXPECT_NE(1000.0f, Graph.Pixel("Other"));
}

// Compile and observe -----------------------------------------------------------------------------------------------

TEST(Compile, RunsNothing)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	Graph.Extract("X");
	EXPECT_FALSE(Graph.Builder->Compile().FindPass("A")->bCulled);
	EXPECT_EQ("", Graph.Log);
	EXPECT_EQ("A", Graph.Run());
}

TEST(Compile, ThrowsWhatExecuteWouldThrow)
{
	FGraphTest Graph;
	Graph.External("X");
	Graph.Pass("A").Reads("X");
	EXPECT_THROW(Graph.Builder->Compile(), FError);
}

TEST(Compile, PassIndicesStartAfterThePrologue)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	const FRDGCompiledGraph Compiled = Graph.Builder->Compile();
	ASSERT_EQ(3u, Compiled.Passes.size());
	EXPECT_EQ("Graph Prologue", Compiled.Passes[0].Name);
	EXPECT_EQ("A", Compiled.Passes[1].Name);
	EXPECT_EQ("Graph Epilogue", Compiled.Passes[2].Name);
}

TEST(Compile, MemoryIsCountedWithAndWithoutAliasing)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	Graph.Pass("B").Reads("X").Writes("Y");
	Graph.Pass("C").Reads("Y").Writes("Z");
	Graph.Pass("D").Reads("Z").Writes("Out");
	Graph.Extract("Out");
	const uint64 Bytes = FRHITexture::ComputeSize(FGraphTest::MakeDesc());
	const FRDGMemory Memory = Graph.Builder->Compile().Memory;
	EXPECT_EQ(2 * Bytes, Memory.TransientPeakBytes);
	EXPECT_EQ(3 * Bytes, Memory.WithoutAliasingBytes);
	EXPECT_EQ(Bytes, Memory.PooledBytes);
}

TEST(Compile, WarningsComeWithTheGraph)
{
	FGraphTest Graph;
	Graph.Pass("A").Reads("Never").Writes("X");
	Graph.Extract("X");
	testing::internal::CaptureStderr();
	const FRDGCompiledGraph Compiled = Graph.Builder->Compile();
	testing::internal::GetCapturedStderr();
	ASSERT_EQ(1u, Compiled.Warnings.size());
	EXPECT_EQ(RDGEnsureNeverWritten, Compiled.Warnings[0].Code);
}

TEST(Compile, AllComputePassesAreAsyncInMode2)
{
	const FScopedConsoleVariable All(TEXT("r.RDG.AsyncCompute"), 2);
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	Graph.Pass("B").Renders("Y");
	EXPECT_TRUE(Graph.Builder->Compile().FindPass("A")->bAsync);
	EXPECT_FALSE(Graph.Builder->Compile().FindPass("B")->bAsync);
}

TEST(Compile, NoPassIsAsyncInMode0)
{
	const FScopedConsoleVariable None(TEXT("r.RDG.AsyncCompute"), 0);
	FGraphTest Graph;
	Graph.Pass("A").Writes("X").Flags(ERDGPassFlags::AsyncCompute);
	EXPECT_FALSE(Graph.Builder->Compile().FindPass("A")->bAsync);
}

namespace
{

/** Notes every call. */
class FNotingObserver : public IRDGObserver
{
public:
	void OnGraphCompiled(const FRDGCompiledGraph& Graph) override
	{
		Log += "compiled:" + std::to_string(Graph.Passes.size()) + " ";
	}

	void OnLoadExternals(const std::vector<FRDGExternalLoad>& Loads) override
	{
		for (const FRDGExternalLoad& Load : Loads)
		{
			FRDGTexture* const Texture = Load.Texture;
			Log += std::string("load:") + Texture->Name + " ";
			bHadMemory = bHadMemory || Texture->GetRHI()->HasMemory();
			Texture->GetRHI()->Fill(FLinearColor(LoadedValue, 0, 0, 0));
		}
	}

	void OnPassExecuted(int32_t Index, const FRDGPass& Pass, double Milliseconds, const FPassCounters&,
		const std::vector<FRDGTexture*>& Written) override
	{
		Log += std::to_string(Index) + ":" + Pass.GetName();
		EXPECT_GE(Milliseconds, 0.0);
		for (FRDGTexture* Texture : Written)
		{
			Log += std::string("(") + Texture->Name + "=" + std::to_string(int(Texture->GetRHI()->ReadTexel(0, 0).R)) +
				   ")";
		}
		Log += " ";
	}

	std::string Log;
	float LoadedValue = 20;
	bool bHadMemory = false;
};

/** A registered texture that nobody touched yet. */
void RegisterEmpty(FGraphTest& Graph, const std::string& Name)
{
	const TRefCountPtr<FRHITexture> Texture(new FRHITexture(FGraphTest::MakeDesc(), Graph.KeepName(Name)));
	Graph.Pooled[Name] = CreateRenderTarget(Texture, Graph.KeepName(Name));
	Graph.Textures[Name] = Graph.Builder->RegisterExternalTexture(Graph.Pooled[Name], Graph.KeepName(Name));
}

} // namespace

TEST(Observer, SeesTheGraphTheLoadsAndEachPass)
{
	FGraphTest Graph;
	FNotingObserver Observer;
	Graph.Builder->SetObserver(&Observer);
	RegisterEmpty(Graph, "In");
	Graph.Pass("A").Reads("In").Writes("X").Value(1);
	Graph.Pass("B").Reads("X").Writes("Y").Value(2);
	Graph.Extract("Y");
	Graph.Run();
	EXPECT_EQ("compiled:4 load:In 1:A(X=21) 2:B(Y=23) ", Observer.Log);
	EXPECT_FALSE(Observer.bHadMemory);
}

/** The sanitizer knows when it does not. */
TEST(Observer, MayReadTheCompiledGraphUntilTheBuilderGoes)
{
	class FKeepingObserver final : public FNotingObserver
	{
	public:
		void OnGraphCompiled(const FRDGCompiledGraph& Graph) override { Kept = &Graph; }
		const FRDGCompiledGraph* Kept = nullptr;
	};
	FKeepingObserver Observer;
	FGraphTest Graph;
	Graph.Builder->SetObserver(&Observer);
	Graph.Pass("A").Writes("X").Value(1);
	Graph.Extract("X");
	Graph.Run();
	ASSERT_NE(nullptr, Observer.Kept);
	ASSERT_EQ(3u, Observer.Kept->Passes.size());
	EXPECT_EQ("A", Observer.Kept->Passes[1].Name);
}

TEST(Observer, IsNotAskedOnceTheGraphHasRun)
{
	class FAskedObserver final : public FNotingObserver
	{
	public:
		bool WantsPlannedExternals() const override
		{
			++NumAsked;
			return false;
		}
		mutable int NumAsked = 0;
	};
	FAskedObserver Observer;
	FGraphTest Graph;
	Graph.Builder->SetObserver(&Observer);
	Graph.Pass("A").Writes("X").Value(1);
	Graph.Extract("X");
	Graph.Run();
	const int NumAskedInRun = Observer.NumAsked;
	Graph.Builder->Discard();
	EXPECT_EQ(NumAskedInRun, Observer.NumAsked);
}

TEST(Observer, MayHaveTexturesBeginAtZeroInUsedMemory)
{
	class FShowingObserver final : public FNotingObserver
	{
	public:
		bool WantsZeroedTextures() const override { return true; }
	};
	FShowingObserver Observer;
	FGraphTest Graph;
	Graph.Builder->SetObserver(&Observer);
	Graph.Pass("A").Writes("X").Value(5);
	Graph.Pass("B").Reads("X").Writes("Y").Value(1);
	Graph.Pass("C").Reads("Y").Writes("Z").Does([](FRHICommandListImmediate&) {}); // where X was
	Graph.Pass("D").Reads("Z").Writes("Out").Value(2);
	Graph.Extract("Out");
	Graph.Run();
	EXPECT_EQ("compiled:6 1:A(X=5) 2:B(Y=6) 3:C(Z=0) 4:D(Out=2) ", Observer.Log);
}

TEST(Observer, ThatShowsWarningsLeavesNoneToTheGraph)
{
	class FShowingObserver final : public FNotingObserver
	{
	public:
		void OnGraphCompiled(const FRDGCompiledGraph& Graph) override { Warnings = Graph.Warnings; }
		bool ShowsWarnings() const override { return bShows; }
		std::vector<FDiagnostic> Warnings;
		bool bShows = true;
	};
	const auto Run = [](bool bShows)
	{
		FShowingObserver Observer;
		Observer.bShows = bShows;
		FGraphTest Graph;
		Graph.Builder->SetObserver(&Observer);
		Graph.Pass("A").Reads("Never").Writes("X");
		Graph.Extract("X");
		testing::internal::CaptureStderr();
		Graph.Run();
		EXPECT_EQ(1u, Observer.Warnings.size());
		return testing::internal::GetCapturedStderr();
	};
	EXPECT_EQ("", Run(true));
	EXPECT_NE(std::string::npos, Run(false).find("Never"));
}

TEST(Observer, LoadsOnlyWhatSurvivingPassesTouch)
{
	FGraphTest Graph;
	FNotingObserver Observer;
	Graph.Builder->SetObserver(&Observer);
	RegisterEmpty(Graph, "Used");
	RegisterEmpty(Graph, "Unused");
	Graph.Pass("A").Reads("Unused").Writes("X");
	Graph.Pass("B").Reads("Used").Writes("Y");
	Graph.Extract("Y");
	Graph.Run();
	EXPECT_EQ("compiled:4 load:Used 2:B(Y=21) ", Observer.Log);
	EXPECT_FALSE(Graph.Pooled["Unused"]->GetRHI()->HasMemory());
}

TEST(Observer, LoadsBeforeTheFirstUseInImmediateMode)
{
	const FScopedConsoleVariable Immediate(TEXT("r.RDG.ImmediateMode"), 1);
	FGraphTest Graph;
	FNotingObserver Observer;
	Graph.Builder->SetObserver(&Observer);
	RegisterEmpty(Graph, "In");
	Graph.Pass("A").Reads("In").Writes("X");
	Graph.Pass("B").Reads("In").Writes("Y");
	Graph.Run();
	EXPECT_EQ("load:In 1:A(X=21) 2:B(Y=21) compiled:4 ", Observer.Log);
}

TEST(Observer, ConvertedTexturesAreNotLoaded)
{
	FGraphTest Graph;
	FNotingObserver Observer;
	Graph.Builder->SetObserver(&Observer);
	Graph.Builder->ConvertToExternalTexture(Graph.Texture("X"));
	Graph.Pass("A").Writes("X").Value(3);
	Graph.Run();
	EXPECT_EQ("compiled:3 1:A(X=3) ", Observer.Log);
}
