// The state changes a GPU would need barriers for.
#include <gtest/gtest.h>

#include "GraphDescriptionBuilder.h"
#include "RenderGraphTransitions.h"

using namespace Drydock;

namespace
{

/** "X 1->2 UAVCompute>SRVCompute; ..." of one resource, "all" joined boxes marked by their mips. */
std::string Describe(FDescribedGraph& Graph, const std::string& Name, bool bTransient = true, bool bOverlapUAVs = true)
{
	const FRDGGraphDescription Description = Graph.Get();
	FRDGTransitionOptions Options;
	Options.bOverlapUAVs = bOverlapUAVs;
	Options.bTransient.assign(Description.Resources.size(), bTransient);
	std::string Text;
	for (const FRDGTransition& Transition : FindTransitions(Description, Graph.KeepAll(), Options))
	{
		if (Transition.Resource == Graph.GetIndex(Name))
		{
			Text += (Text.empty() ? "" : "; ") + std::to_string(Transition.BeginPass) + "->" +
					std::to_string(Transition.EndPass) + " " + *GetRHIAccessName(Transition.Before) + ">" +
					*GetRHIAccessName(Transition.After) + (Transition.bUAVBarrier ? "!" : "");
			Text += Graph.Resource(Name).NumMips > 1
						? " mips " + std::to_string(Transition.FirstMip) + "+" + std::to_string(Transition.NumMips)
						: "";
		}
	}
	return Text;
}

} // namespace

TEST(Transitions, ATransientResourceStartsAsDiscard)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	EXPECT_EQ("0->1 Discard>UAVCompute", Describe(Graph, "X"));
}

TEST(Transitions, APooledResourceStartsUnknown)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	EXPECT_EQ("0->1 Unknown>UAVCompute", Describe(Graph, "X", false));
}

TEST(Transitions, WriteThenReadBeginsAfterTheWriterAndEndsBeforeTheReader)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("Other", {Write("Z")});
	Graph.Pass("B", {Read("X"), Write("Y")});
	EXPECT_EQ("0->1 Discard>UAVCompute; 1->3 UAVCompute>SRVCompute", Describe(Graph, "X"));
}

TEST(Transitions, ReadersShareOneState)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Read("X"), Write("Y")});
	Graph.Pass("C", {{"X", ERHIAccess::SRVGraphics}, Render("Z")}, ERDGPassFlags::Raster);
	EXPECT_EQ("0->1 Discard>UAVCompute; 1->2 UAVCompute>SRVCompute|SRVGraphics", Describe(Graph, "X"));
}

TEST(Transitions, AnUnorderedWriteAfterAnotherGetsABarrier)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Write("X")});
	EXPECT_EQ("0->1 Discard>UAVCompute; 1->2 UAVCompute>UAVCompute!", Describe(Graph, "X"));
}

TEST(Transitions, TheSameSkipBarrierViewNeedsNone)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {{"X", ERHIAccess::UAVCompute, 0, -1, 7}});
	Graph.Pass("B", {{"X", ERHIAccess::UAVCompute, 0, -1, 7}});
	EXPECT_EQ("0->1 Discard>UAVCompute", Describe(Graph, "X"));
}

TEST(Transitions, AnotherSkipBarrierViewNeedsOne)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {{"X", ERHIAccess::UAVCompute, 0, -1, 7}});
	Graph.Pass("B", {{"X", ERHIAccess::UAVCompute, 0, -1, 8}});
	EXPECT_EQ("0->1 Discard>UAVCompute; 1->2 UAVCompute>UAVCompute!", Describe(Graph, "X"));
}

TEST(Transitions, WithoutOverlapSkipBarrierIsIgnored)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {{"X", ERHIAccess::UAVCompute, 0, -1, 7}});
	Graph.Pass("B", {{"X", ERHIAccess::UAVCompute, 0, -1, 7}});
	EXPECT_EQ("0->1 Discard>UAVCompute; 1->2 UAVCompute>UAVCompute!", Describe(Graph, "X", true, false));
}

TEST(Transitions, RenderTargetAfterRenderTargetNeedsNone)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X");
	Graph.RasterPass("B", "X");
	EXPECT_EQ("0->1 Discard>RTV", Describe(Graph, "X"));
}

TEST(Transitions, AnExternalResourceComesAndGoesReadable)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.Pass("A", {Write("X")});
	EXPECT_EQ(
		"0->1 SRVCompute|SRVGraphics>UAVCompute; 1->2 UAVCompute>SRVCompute|SRVGraphics", Describe(Graph, "X", false));
}

TEST(Transitions, AFinalAccessIsObeyed)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExtracted = true;
	Graph.Resource("X").AccessFinal = ERHIAccess::CopySrc;
	Graph.Pass("A", {Write("X")});
	EXPECT_EQ("0->1 Unknown>UAVCompute; 1->2 UAVCompute>CopySrc", Describe(Graph, "X", false));
}

TEST(Transitions, MipsChangeStateOneByOne)
{
	FDescribedGraph Graph;
	Graph.Resource("X").NumMips = 2;
	Graph.Pass("A", {WriteMip("X", 0)});
	Graph.Pass("B", {ReadMip("X", 0), WriteMip("X", 1)});
	EXPECT_EQ("0->1 Discard>UAVCompute mips 0+1; 1->2 UAVCompute>SRVCompute mips 0+1; 0->2 Discard>UAVCompute mips 1+1",
		Describe(Graph, "X"));
}

TEST(Transitions, MipsThatChangeAlikeAreOneTransition)
{
	FDescribedGraph Graph;
	Graph.Resource("X").NumMips = 3;
	Graph.Pass("A", {Write("X")});
	EXPECT_EQ("0->1 Discard>UAVCompute mips 0+3", Describe(Graph, "X"));
}

TEST(Transitions, SkipTrackingHasNone)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.Resource("X").bSkipTracking = true;
	Graph.Pass("A", {Read("X"), Write("Y")});
	EXPECT_EQ("", Describe(Graph, "X", false));
}

TEST(Transitions, CulledPassesHaveNone)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	FRDGTransitionOptions Options;
	Options.bTransient = {true};
	EXPECT_TRUE(FindTransitions(Graph.Get(), {false, true, false}, Options).empty());
}

TEST(Transitions, ReadsOnBothPipelinesShareAStateThatBothKnow)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Read("X"), Write("Y")});
	Graph.Pass("C", {Read("X"), Write("Z")}, ERDGPassFlags::AsyncCompute);
	EXPECT_EQ("0->1 Discard>UAVCompute; 1->2 UAVCompute>SRVCompute", Describe(Graph, "X"));
}
