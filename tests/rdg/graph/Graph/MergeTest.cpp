// Which raster passes become one render pass, and why others do not.
#include <gtest/gtest.h>

#include "GraphDescriptionBuilder.h"
#include "RenderGraphMerge.h"

#include <random>

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

namespace
{

/** Render passes of passes that draw to one of three targets, clear or not, or dispatch: by pairs of all passes. */
std::vector<FRDGRenderPass> MergePlainly(const FRDGGraphDescription& Graph, const std::vector<bool>& bCulled)
{
	const auto IsRaster = [&](size_t Pass)
	{
		return !bCulled[Pass] && EnumHasAnyFlags(Graph.Passes[Pass].Flags, ERDGPassFlags::Raster);
	};
	const auto IsCounted = [&](size_t Pass)
	{
		return !bCulled[Pass] && !Graph.Passes[Pass].bIsSentinel;
	};
	const auto Joins = [&](size_t Pass) // the counted pass before it
	{
		size_t Before = Pass - 1;
		while (Before > 0 && !IsCounted(Before))
		{
			--Before;
		}
		const FRDGTarget& Target = Graph.Passes[Pass].Targets.Colors[0];
		return IsRaster(Before) && Target.Load != ERenderTargetLoadAction::EClear &&
			   Graph.Passes[Before].Targets.Colors[0].Resource == Target.Resource;
	};
	std::vector<FRDGRenderPass> Result(Graph.Passes.size());
	for (size_t Pass = 0; Pass < Result.size(); ++Pass)
	{
		if (!IsRaster(Pass))
		{
			continue;
		}
		size_t Begin = Pass;
		while (!IsRaster(Begin) || Joins(Begin))
		{
			--Begin;
		}
		size_t End = Pass;
		for (size_t Later = Pass + 1; Later < Result.size(); ++Later)
		{
			if (IsCounted(Later))
			{
				if (!IsRaster(Later) || !Joins(Later))
				{
					break;
				}
				End = Later;
			}
		}
		Result[Pass] = {int32_t(Begin), int32_t(End), {}};
	}
	return Result;
}

} // namespace

TEST(Merge, RandomGraphsMergeAsPlainlyWrittenOnesDo)
{
	for (uint32_t Seed = 0; Seed < 100; ++Seed)
	{
		std::mt19937 Random(Seed);
		FDescribedGraph Graph;
		std::vector<bool> bCulled = {false};
		for (int Pass = 0; Pass < 80; ++Pass)
		{
			const std::string Target = "X" + std::to_string(Random() % 8 / 3);
			if (Random() % 12 == 0)
			{
				Graph.Pass("P" + std::to_string(Pass), {Write(Target)});
			}
			else
			{
				Graph.RasterPass("P" + std::to_string(Pass), Target,
					Random() % 10 == 0 ? ERenderTargetLoadAction::EClear : ERenderTargetLoadAction::ELoad);
			}
			bCulled.push_back(Random() % 9 == 0);
		}
		bCulled.push_back(false);
		const FRDGGraphDescription Description = Graph.Get();
		const std::vector<FRDGRenderPass> Expected = MergePlainly(Description, bCulled);
		const std::vector<FRDGRenderPass> Result = MergeRenderPasses(Description, bCulled, true);
		for (size_t Pass = 0; Pass < Result.size(); ++Pass)
		{
			ASSERT_EQ(Expected[Pass].Begin, Result[Pass].Begin) << "seed " << Seed << ", pass " << Pass;
			ASSERT_EQ(Expected[Pass].End, Result[Pass].End) << "seed " << Seed << ", pass " << Pass;
		}
	}
}
