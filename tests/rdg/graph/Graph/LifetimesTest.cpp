// From which pass to which a resource is held.
#include <gtest/gtest.h>

#include "GraphDescriptionBuilder.h"
#include "RenderGraphCompile.h"
#include "RenderGraphLifetimes.h"

using namespace Drydock;

namespace
{

FRDGLifetime FindLifetime(
	FDescribedGraph& Graph, const std::string& Name, bool bExtend = false, std::vector<bool> bCulled = {})
{
	const FRDGGraphDescription Description = Graph.Get();
	bCulled = bCulled.empty() ? Graph.KeepAll() : bCulled;
	const std::vector<FRDGAsyncWindow> Windows = FindAsyncWindows(Description, FindDependencies(Description), bCulled);
	return FindLifetimes(Description, bCulled, Windows, bExtend)[size_t(Graph.GetIndex(Name))];
}

std::string ExplainUnused(FDescribedGraph& Graph, const std::string& Name)
{
	const FRDGCompiledGraph Compiled = CompileGraph(Graph.Get(), FRDGCompileOptions());
	return Compiled.DescribeUnused(Compiled.Resources[size_t(Graph.GetIndex(Name))]);
}

void AddThree(FDescribedGraph& Graph)
{
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Write("Y")});
	Graph.Pass("C", {Read("X"), Write("Z")});
}

} // namespace

TEST(Lifetimes, RunFromTheFirstPassToTheLast)
{
	FDescribedGraph Graph;
	AddThree(Graph);
	EXPECT_EQ(1, FindLifetime(Graph, "X").First);
	EXPECT_EQ(3, FindLifetime(Graph, "X").Last);
	EXPECT_EQ(2, FindLifetime(Graph, "X").NumUses);
}

TEST(Lifetimes, AnExtractedResourceLivesToTheEpilogue)
{
	FDescribedGraph Graph;
	AddThree(Graph);
	Graph.Resource("Y").bExtracted = true;
	EXPECT_EQ(2, FindLifetime(Graph, "Y").First);
	EXPECT_EQ(4, FindLifetime(Graph, "Y").Last);
}

TEST(Lifetimes, CulledPassesDoNotCount)
{
	FDescribedGraph Graph;
	AddThree(Graph);
	EXPECT_EQ(1, FindLifetime(Graph, "X", false, {false, false, false, true, false}).Last);
}

TEST(Lifetimes, AnUnusedResourceHasNoneAndSaysWhy)
{
	FDescribedGraph Graph;
	AddThree(Graph);
	Graph.Resource("Unused");
	EXPECT_EQ(-1, FindLifetime(Graph, "Unused").First);
	EXPECT_EQ("no pass uses it", ExplainUnused(Graph, "Unused"));
}

TEST(Lifetimes, ManyCulledPassesThatUseAResourceAreCounted)
{
	FDescribedGraph Graph;
	for (int32_t Pass = 0; Pass < 100; ++Pass)
	{
		Graph.Pass("P" + std::to_string(Pass), {Read("X"), Write("Y")});
	}
	EXPECT_EQ("all passes that use it are culled: P0, P1, P2, P3, P4, P5, P6, P7, P8, P9, P10, P11, P12, P13, P14 and "
			  "85 more",
		ExplainUnused(Graph, "X"));
}

TEST(Lifetimes, AResourceOfCulledPassesNamesThem)
{
	FDescribedGraph Graph;
	AddThree(Graph);
	const FRDGLifetime Lifetime = FindLifetime(Graph, "X", false, {false, true, false, true, false});
	EXPECT_EQ(-1, Lifetime.First);
	EXPECT_EQ(std::vector<int32_t>({1, 3}), Lifetime.CulledUsers);
	EXPECT_EQ("all passes that use it are culled: A, C", ExplainUnused(Graph, "X")); // nothing is extracted
}

TEST(Lifetimes, ExtendedTheySpanTheGraph)
{
	FDescribedGraph Graph;
	AddThree(Graph);
	EXPECT_EQ(0, FindLifetime(Graph, "Y", true).First);
	EXPECT_EQ(4, FindLifetime(Graph, "Y", true).Last);
}

TEST(Lifetimes, ExtendedAnUnusedResourceStaysUnused)
{
	FDescribedGraph Graph;
	AddThree(Graph);
	Graph.Resource("Unused");
	EXPECT_EQ(-1, FindLifetime(Graph, "Unused", true).First);
}

TEST(Lifetimes, AnAsyncPassHoldsItsResourcesFromForkToJoin)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Write("Y")});
	Graph.Pass("C", {Read("X"), Write("Z")}, ERDGPassFlags::AsyncCompute);
	Graph.Pass("D", {Write("W")});
	Graph.Pass("E", {Read("Z"), Write("V")});
	EXPECT_EQ(1, FindLifetime(Graph, "X").First);
	EXPECT_EQ(5, FindLifetime(Graph, "X").Last);
	EXPECT_EQ(1, FindLifetime(Graph, "Z").First);
}

TEST(Lifetimes, SeveralParametersOfOnePassAreOneUse)
{
	FDescribedGraph Graph;
	Graph.Resource("X").NumMips = 2;
	Graph.Pass("A", {ReadMip("X", 0), WriteMip("X", 1)});
	EXPECT_EQ(1, FindLifetime(Graph, "X").NumUses);
}
