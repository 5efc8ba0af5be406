// Which passes are left out, and the reasons given.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "GraphDescriptionBuilder.h"
#include "RenderGraphCompile.h"
#include "RenderGraphCull.h"

#include <random>

using namespace Drydock;
using testing::HasSubstr;

namespace
{

FRDGCullResult Cull(const FDescribedGraph& Graph, bool bEnabled = true)
{
	const FRDGGraphDescription Description = Graph.Get();
	return CullPasses(Description, FindDependencies(Description), bEnabled);
}

/** Names of the passes that stay, without sentinels. */
std::string Survivors(const FDescribedGraph& Graph, bool bEnabled = true)
{
	const FRDGCullResult Result = Cull(Graph, bEnabled);
	std::string Names;
	for (const FRDGPassDescription& Pass : Graph.Get().Passes)
	{
		if (!Pass.bIsSentinel && !Result.bCulled[size_t(Pass.Index)])
		{
			Names += (Names.empty() ? "" : " ") + Pass.Name;
		}
	}
	return Names;
}

/** Why a pass is culled, as whoever lists a compiled graph asks. */
std::string Explain(const FDescribedGraph& Graph, size_t Pass, bool bEnabled = true)
{
	FRDGCompileOptions Options;
	Options.bCullPasses = bEnabled;
	const FRDGCompiledGraph Compiled = CompileGraph(Graph.Get(), Options);
	return Compiled.DescribeCulled(Compiled.Passes[Pass]);
}

} // namespace

TEST(Cull, APassNobodyReadsIsCulled)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	EXPECT_EQ("", Survivors(Graph));
}

TEST(Cull, ProducersOfAnExtractedResourceStay)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Read("X"), Write("Y")});
	Graph.Pass("C", {Read("X"), Write("Z")});
	Graph.Resource("Y").bExtracted = true;
	EXPECT_EQ("A B", Survivors(Graph));
}

TEST(Cull, TheLastWriterOfAnExternalResourceStaysThoughNobodyReadsIt)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Resource("X").bExternal = true;
	EXPECT_EQ("A", Survivors(Graph));
}

TEST(Cull, AnOverwrittenWriterStaysWithTheOneThatOverwrites)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Write("X")});
	Graph.Resource("X").bExtracted = true;
	EXPECT_EQ("A B", Survivors(Graph));
}

TEST(Cull, AReaderOfAnExternalResourceIsNoRoot)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.Pass("A", {Read("X"), Write("Y")});
	EXPECT_EQ("", Survivors(Graph));
}

TEST(Cull, NeverCullKeepsThePassAndItsProducers)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Read("X")}, ERDGPassFlags::Compute | ERDGPassFlags::NeverCull);
	EXPECT_EQ("A B", Survivors(Graph));
}

TEST(Cull, APassWithoutParametersStays)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {}, ERDGPassFlags::None).bHasParameters = false;
	EXPECT_EQ("A", Survivors(Graph));
}

TEST(Cull, APassThatWritesOutsideTheGraphStays)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {}).bHasExternalOutputs = true;
	EXPECT_EQ("A", Survivors(Graph));
}

TEST(Cull, OnlyTheMipThatIsReadKeepsItsWriter)
{
	FDescribedGraph Graph;
	Graph.Resource("X").NumMips = 2;
	Graph.Pass("A", {WriteMip("X", 0)});
	Graph.Pass("B", {WriteMip("X", 1)});
	Graph.Pass("C", {ReadMip("X", 0), Write("Y")});
	Graph.Resource("Y").bExtracted = true;
	EXPECT_EQ("A C", Survivors(Graph));
}

TEST(Cull, EveryMipOfAnExtractedTextureIsARoot)
{
	FDescribedGraph Graph;
	Graph.Resource("X").NumMips = 2;
	Graph.Pass("A", {WriteMip("X", 0)});
	Graph.Pass("B", {WriteMip("X", 1)});
	Graph.Resource("X").bExtracted = true;
	EXPECT_EQ("A B", Survivors(Graph));
}

TEST(Cull, ADeclaredDependencyKeepsTheProducer)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Write("Y")}).DeclaredProducers = {1};
	Graph.Resource("Y").bExtracted = true;
	EXPECT_EQ("A B", Survivors(Graph));
}

TEST(Cull, ALaterWriterThanTheReaderIsCulled)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Read("X"), Write("Y")});
	Graph.Pass("C", {Write("X")});
	Graph.Resource("Y").bExtracted = true;
	EXPECT_EQ("A B", Survivors(Graph));
}

TEST(Cull, SwitchedOffNothingIsCulled)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	EXPECT_EQ("A", Survivors(Graph, false));
	EXPECT_EQ("", Explain(Graph, 1, false));
}

TEST(Cull, TheReasonNamesTheOutputNobodyReads)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	EXPECT_EQ("no reader: output X is neither read by a surviving pass nor extracted", Explain(Graph, 1));
}

TEST(Cull, TheReasonNamesAllOutputs)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X"), Write("Y"), Write("Z")});
	EXPECT_EQ("no reader: outputs X, Y and Z are neither read by a surviving pass nor extracted", Explain(Graph, 1));
}

TEST(Cull, TheReasonFollowsTheChainOfCulledReaders)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Read("X"), Write("Y")});
	Graph.Pass("C", {Read("Y"), Write("Z")});
	EXPECT_EQ("no reader: output X is used only by culled passes (B -> C), and output Z of C is neither read by a "
			  "surviving pass nor extracted",
		Explain(Graph, 1));
}

TEST(Cull, TheReasonOfALongChainNamesItsBothEnds)
{
	FDescribedGraph Graph;
	for (int32_t Pass = 0; Pass < 30; ++Pass)
	{
		Graph.Pass(
			"P" + std::to_string(Pass), {Read("X" + std::to_string(Pass)), Write("X" + std::to_string(Pass + 1))});
	}
	EXPECT_THAT(Explain(Graph, 1),
		HasSubstr("used only by culled passes (P1 -> P2 -> P3 -> P4 -> P5 -> P6 -> P7 -> P8 -> P9 -> P10 -> P11 -> P12 "
				  "-> P13 -> P14 -> P15 -> 13 more -> P29), and output X30 of P29 is neither read"));
	EXPECT_THAT(Explain(Graph, 14), HasSubstr("(P14 -> P15 -> P16 -> P17 -> P18 -> P19 -> P20 -> P21 -> P22 -> P23 -> "
											  "P24 -> P25 -> P26 -> P27 -> P28 -> P29), and output X30 of P29 is"));
}

TEST(Cull, ASurvivorHasNoReason)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Resource("X").bExtracted = true;
	EXPECT_EQ("", Explain(Graph, 1));
}

TEST(Cull, APassThatWritesNothingSaysSo)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Read("X")});
	EXPECT_THAT(Explain(Graph, 1), HasSubstr("writes nothing"));
}

TEST(Cull, AChainIsKeptAsItsEndAndItsLength)
{
	constexpr int32_t Num = 10'000;
	FDescribedGraph Graph;
	for (int32_t Pass = 0; Pass < Num; ++Pass)
	{
		Graph.Pass(
			"P" + std::to_string(Pass), {Read("X" + std::to_string(Pass)), Write("X" + std::to_string(Pass + 1))});
	}
	const FRDGCompiledGraph Compiled = CompileGraph(Graph.Get(), FRDGCompileOptions());
	size_t NumBytes = 0;
	for (const FRDGCompiledPass& Pass : Compiled.Passes)
	{
		if (Pass.bIsSentinel)
		{
			continue;
		}
		ASSERT_EQ(Pass.Index == Num ? -1 : Pass.Index + 1, Pass.Readers.Next);
		ASSERT_EQ(Num, Pass.Readers.End);
		ASSERT_EQ(Num - Pass.Index, Pass.Readers.Length);
		NumBytes += Compiled.DescribeCulled(Pass).size();
	}
	EXPECT_LT(NumBytes, 400u * Num); // not the names of the whole chain for each
}

TEST(Cull, ChainsOfRandomGraphsAreThoseThatAWalkFinds)
{
	for (uint32_t Seed = 0; Seed < 50; ++Seed)
	{
		std::mt19937 Random(Seed);
		const auto Draw = [&Random](int32_t Num)
		{
			return std::to_string(Random() % static_cast<uint32_t>(Num));
		};
		FDescribedGraph Graph;
		for (int32_t Pass = 0; Pass < 60; ++Pass)
		{
			Graph.Pass("P" + std::to_string(Pass), {Read("X" + Draw(20)), Read("X" + Draw(20)), Write("X" + Draw(20))});
		}
		Graph.Resource("X3").bExtracted = true;
		const FRDGGraphDescription Description = Graph.Get();
		const FRDGDependencies Dependencies = FindDependencies(Description);
		const FRDGCullResult Result = CullPasses(Description, Dependencies, true);
		const auto FindFirstReader = [&](int32_t Pass)
		{
			for (int32_t Reader = Pass + 1; Reader < Description.GetEpilogue(); ++Reader)
			{
				for (const int32_t Producer : Dependencies.Producers[size_t(Reader)])
				{
					if (Producer == Pass)
					{
						return Reader;
					}
				}
			}
			return -1;
		};
		for (int32_t Pass = 1; Pass < Description.GetEpilogue(); ++Pass)
		{
			if (!Result.bCulled[size_t(Pass)])
			{
				continue;
			}
			int32_t Length = 0;
			int32_t End = Pass;
			for (int32_t Next = FindFirstReader(Pass); Next >= 0; Next = FindFirstReader(Next))
			{
				End = Next;
				++Length;
			}
			ASSERT_EQ(FindFirstReader(Pass), Result.Chains[size_t(Pass)].Next) << "seed " << Seed << ", pass " << Pass;
			ASSERT_EQ(End, Result.Chains[size_t(Pass)].End) << "seed " << Seed << ", pass " << Pass;
			ASSERT_EQ(Length, Result.Chains[size_t(Pass)].Length) << "seed " << Seed << ", pass " << Pass;
		}
	}
}
