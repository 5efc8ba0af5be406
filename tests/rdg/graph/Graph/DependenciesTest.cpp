// Who depends on whom: last writers, subresources, pipelines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "GraphDescriptionBuilder.h"
#include "RenderGraphDependencies.h"

using namespace Drydock;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(Dependencies, AReaderDependsOnTheLastWriter)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Write("X")});
	Graph.Pass("C", {Read("X")});
	EXPECT_THAT(FindDependencies(Graph.Get()).Producers[3], ElementsAre(2));
}

TEST(Dependencies, AWriterDependsOnTheWriterBefore)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Write("X")});
	EXPECT_THAT(FindDependencies(Graph.Get()).Producers[2], ElementsAre(1));
}

TEST(Dependencies, AWriteAfterAReadAddsNoEdgeToTheReader)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Read("X"), Write("Y")});
	Graph.Pass("C", {Write("X")});
	EXPECT_THAT(FindDependencies(Graph.Get()).Producers[3], ElementsAre(1));
}

TEST(Dependencies, TwoReadersDoNotDependOnEachOther)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Read("X"), Write("Y")});
	Graph.Pass("C", {Read("X"), Write("Z")});
	EXPECT_THAT(FindDependencies(Graph.Get()).Producers[3], ElementsAre(1));
}

TEST(Dependencies, APassThatReadsAndWritesDoesNotDependOnItself)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X"), Read("X")});
	EXPECT_THAT(FindDependencies(Graph.Get()).Producers[1], IsEmpty());
}

TEST(Dependencies, OtherMipsMakeNoEdge)
{
	FDescribedGraph Graph;
	Graph.Resource("X").NumMips = 2;
	Graph.Pass("A", {WriteMip("X", 0)});
	Graph.Pass("B", {WriteMip("X", 1)});
	Graph.Pass("C", {ReadMip("X", 0), Write("Y")});
	EXPECT_THAT(FindDependencies(Graph.Get()).Producers[2], IsEmpty());
	EXPECT_THAT(FindDependencies(Graph.Get()).Producers[3], ElementsAre(1));
}

TEST(Dependencies, AReadOfAllMipsDependsOnEachMipsWriter)
{
	FDescribedGraph Graph;
	Graph.Resource("X").NumMips = 2;
	Graph.Pass("A", {WriteMip("X", 0)});
	Graph.Pass("B", {WriteMip("X", 1)});
	Graph.Pass("C", {Read("X"), Write("Y")});
	EXPECT_THAT(FindDependencies(Graph.Get()).Producers[3], ElementsAre(1, 2));
}

TEST(Dependencies, LastWritersAreKeptPerMip)
{
	FDescribedGraph Graph;
	Graph.Resource("X").NumMips = 2;
	Graph.Pass("A", {WriteMip("X", 0)});
	Graph.Pass("B", {WriteMip("X", 1)});
	Graph.Pass("C", {WriteMip("X", 1)});
	EXPECT_THAT(FindDependencies(Graph.Get()).GetLastWriters(0), ElementsAre(1, 3));
}

TEST(Dependencies, DepthAndStencilPlanesAreApart)
{
	FDescribedGraph Graph;
	Graph.Resource("D").NumPlanes = 2;
	Graph.Pass("A", {Write("D")}).Uses[0].NumPlanes = 1;
	FRDGUse& Stencil = Graph.Pass("B", {Write("D")}).Uses[0];
	Stencil.Plane = 1;
	Stencil.NumPlanes = 1;
	EXPECT_THAT(FindDependencies(Graph.Get()).Producers[2], IsEmpty());
}

TEST(Dependencies, AWriterOnEachPipelineIsRemembered)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Write("X")}, ERDGPassFlags::AsyncCompute);
	Graph.Pass("C", {Read("X"), Write("Y")});
	EXPECT_THAT(FindDependencies(Graph.Get()).Producers[3], ElementsAre(1, 2));
}

TEST(Dependencies, DeclaredProducersCount)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Write("Y")}).DeclaredProducers = {1};
	EXPECT_THAT(FindDependencies(Graph.Get()).Producers[2], ElementsAre(1));
}
