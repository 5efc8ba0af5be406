// Which raster passes become one render pass, and why others do not.
#include <gtest/gtest.h>

#include "GraphDescriptionBuilder.h"
#include "RenderGraphMerge.h"

using namespace Drydock;

namespace
{

std::vector<FRDGRenderPass> Merge(const FDescribedGraph& Graph, bool bEnabled = true)
{
	return MergeRenderPasses(Graph.Get(), Graph.KeepAll(), bEnabled);
}

/** First pass of the render pass that pass 2 belongs to, when pass 1 is the raster pass before it. */
int32_t SecondBegins(const FDescribedGraph& Graph)
{
	return Merge(Graph)[2].Begin;
}

} // namespace

TEST(Merge, NeighboursWithTheSameTargetAreOneRenderPass)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X", ERenderTargetLoadAction::EClear);
	Graph.RasterPass("B", "X");
	Graph.RasterPass("C", "X");
	const std::vector<FRDGRenderPass> Result = Merge(Graph);
	EXPECT_EQ(1, Result[3].Begin);
	EXPECT_EQ(3, Result[1].End);
	EXPECT_EQ("", Result[3].Reason);
}

TEST(Merge, NoActionMergesToo)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X");
	Graph.RasterPass("B", "X", ERenderTargetLoadAction::ENoAction);
	EXPECT_EQ(1, SecondBegins(Graph));
}

TEST(Merge, APassThatClearsBeginsItsOwn)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X");
	Graph.RasterPass("B", "X", ERenderTargetLoadAction::EClear);
	EXPECT_EQ(2, SecondBegins(Graph));
	EXPECT_EQ("the pass clears its targets", Merge(Graph)[2].Reason);
}

TEST(Merge, OtherTargetsBeginTheirOwn)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X");
	Graph.RasterPass("B", "Y");
	EXPECT_EQ(2, SecondBegins(Graph));
	EXPECT_EQ("different render targets", Merge(Graph)[2].Reason);
}

TEST(Merge, AnotherMipIsAnotherTarget)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X");
	Graph.RasterPass("B", "X").Targets.Colors[0].Mip = 1;
	EXPECT_EQ(2, SecondBegins(Graph));
}

TEST(Merge, AnotherDepthTargetBeginsItsOwn)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X");
	Graph.RasterPass("B", "X").Targets.DepthStencil = Graph.GetIndex("D");
	EXPECT_EQ(2, SecondBegins(Graph));
}

TEST(Merge, NeverMergeIsObeyedOnEitherSide)
{
	for (const int32_t Flagged : {0, 1})
	{
		FDescribedGraph Graph;
		Graph.RasterPass("A", "X").Flags |= Flagged == 0 ? ERDGPassFlags::NeverMerge : ERDGPassFlags::None;
		Graph.RasterPass("B", "X").Flags |= Flagged == 1 ? ERDGPassFlags::NeverMerge : ERDGPassFlags::None;
		EXPECT_EQ(2, SecondBegins(Graph));
	}
}

TEST(Merge, SkipRenderPassIsNotMerged)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X").Flags |= ERDGPassFlags::SkipRenderPass;
	Graph.RasterPass("B", "X");
	EXPECT_EQ(2, SecondBegins(Graph));
}

TEST(Merge, APassThatAlsoWritesByUAVIsNotMerged)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X", ERenderTargetLoadAction::ELoad, {{"U", ERHIAccess::UAVGraphics}});
	Graph.RasterPass("B", "X");
	EXPECT_EQ(2, SecondBegins(Graph));
}

TEST(Merge, AComputePassInBetweenBreaksTheRun)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X");
	Graph.Pass("Work", {Write("Y")});
	Graph.RasterPass("B", "X");
	EXPECT_EQ(3, Merge(Graph)[3].Begin);
	EXPECT_EQ("Work runs in between", Merge(Graph)[3].Reason);
}

TEST(Merge, AnAsyncComputePassInBetweenDoesNot)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X");
	Graph.Pass("Work", {Write("Y")}, ERDGPassFlags::AsyncCompute);
	Graph.RasterPass("B", "X");
	EXPECT_EQ(1, Merge(Graph)[3].Begin);
}

TEST(Merge, APassWithoutParametersInBetweenDoesNot)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X");
	Graph.Pass("Note", {}, ERDGPassFlags::None).bHasParameters = false;
	Graph.RasterPass("B", "X");
	EXPECT_EQ(1, Merge(Graph)[3].Begin);
}

TEST(Merge, ACulledPassInBetweenDoesNot)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X");
	Graph.Pass("Work", {Write("Y")});
	Graph.RasterPass("B", "X");
	std::vector<bool> bCulled = Graph.KeepAll();
	bCulled[2] = true;
	EXPECT_EQ(1, MergeRenderPasses(Graph.Get(), bCulled, true)[3].Begin);
}

TEST(Merge, SwitchedOffEachPassIsItsOwn)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X");
	Graph.RasterPass("B", "X");
	EXPECT_EQ(2, Merge(Graph, false)[2].Begin);
}

TEST(Merge, OtherPassesHaveNoRenderPass)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	EXPECT_EQ(-1, Merge(Graph)[1].Begin);
}
