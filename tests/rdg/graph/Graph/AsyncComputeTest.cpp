// Fork and join of async-compute passes.
#include <gtest/gtest.h>

#include "GraphDescriptionBuilder.h"
#include "RenderGraphAsyncCompute.h"

using namespace Drydock;

namespace
{

constexpr ERDGPassFlags Async = ERDGPassFlags::AsyncCompute;

std::vector<FRDGAsyncWindow> FindWindows(const FDescribedGraph& Graph)
{
	const FRDGGraphDescription Description = Graph.Get();
	return FindAsyncWindows(Description, FindDependencies(Description), Graph.KeepAll());
}

} // namespace

TEST(AsyncCompute, AGraphicsPassHasNoWindow)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	EXPECT_EQ(-1, FindWindows(Graph)[1].Fork);
	EXPECT_EQ(-1, FindWindows(Graph)[1].Join);
}

TEST(AsyncCompute, AloneItSpansTheGraph)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")}, Async);
	EXPECT_EQ(0, FindWindows(Graph)[1].Fork);
	EXPECT_EQ(2, FindWindows(Graph)[1].Join);
}

TEST(AsyncCompute, ForksAfterItsLatestGraphicsProducer)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Write("Y")});
	Graph.Pass("Other", {Write("Z")});
	Graph.Pass("C", {Read("X"), Read("Y"), Write("W")}, Async);
	EXPECT_EQ(2, FindWindows(Graph)[4].Fork);
}

TEST(AsyncCompute, JoinsBeforeItsEarliestGraphicsConsumer)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")}, Async);
	Graph.Pass("Other", {Write("Z")});
	Graph.Pass("B", {Read("X"), Write("Y")});
	Graph.Pass("C", {Read("X"), Write("W")});
	EXPECT_EQ(3, FindWindows(Graph)[1].Join);
}

TEST(AsyncCompute, DoesNotForkBeforeTheAsyncPassBefore)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Read("X"), Write("Y")}, Async);
	Graph.Pass("C", {Write("Z")}, Async);
	EXPECT_EQ(1, FindWindows(Graph)[3].Fork);
}

TEST(AsyncCompute, DoesNotJoinAfterTheAsyncPassAfter)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")}, Async);
	Graph.Pass("B", {Write("Y")}, Async);
	Graph.Pass("C", {Read("Y"), Write("Z")});
	EXPECT_EQ(3, FindWindows(Graph)[1].Join);
}

TEST(AsyncCompute, ACulledConsumerDoesNotCount)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")}, Async);
	Graph.Pass("B", {Read("X"), Write("Y")});
	std::vector<bool> bCulled = Graph.KeepAll();
	bCulled[2] = true;
	const FRDGGraphDescription Description = Graph.Get();
	EXPECT_EQ(3, FindAsyncWindows(Description, FindDependencies(Description), bCulled)[1].Join);
}
