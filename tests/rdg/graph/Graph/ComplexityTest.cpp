// The work of a graph grows as the number of its passes: 20,000 passes of one shape against 2,000 of it.
#include <gtest/gtest.h>

#include "GraphDescriptionBuilder.h"
#include "GraphTestBuilder.h"
#include "RenderGraphCompile.h"
#include "RenderGraphDump.h"
#include "RenderGraphNotes.h"
#include "RenderGraphValidate.h"

#include <ctime>
#include <functional>

using namespace Drydock;

namespace
{

constexpr int32 Few = 2'000;
constexpr int32 Many = 20'000;

/** Seconds of this process's own, so that what else runs on the machine does not count. */
double Measure(const std::function<void()>& Work)
{
	const std::clock_t Begin = std::clock();
	Work();
	return static_cast<double>(std::clock() - Begin) / CLOCKS_PER_SEC;
}

/** Ten times the passes: ten times the time, a hundred where each looks at all others. A tenth of a second is free: the
 * few may take next to none. */
void ExpectLinear(const std::function<void(int32)>& Work)
{
	const double OfFew = Measure([&] { Work(Few); });
	const double OfMany = Measure([&] { Work(Many); });
	EXPECT_LT(OfMany, 40.0 * OfFew + 0.1) << "for " << Few << " passes: " << OfFew << " s";
}

std::string Number(const char* Name, int32 Index)
{
	return Name + std::to_string(Index);
}

/** Compiles and prints it. */
void CheckShape(const std::function<void(FDescribedGraph&, int32 Num)>& Declare)
{
	ExpectLinear(
		[&](int32 Num)
		{
			FDescribedGraph Graph;
			Declare(Graph, Num);
			const FRDGGraphDescription Description = Graph.Get();
			ValidateGraph(Description, true);
			const FRDGCompiledGraph Compiled = CompileGraph(Description, FRDGCompileOptions());
			EXPECT_EQ(static_cast<size_t>(Num) + 2, Compiled.Passes.size());
			EXPECT_LT(DumpText(Compiled).size(), 2000u * static_cast<size_t>(Num));
			DumpDot(Compiled);
			DumpTransitions(Compiled);
		});
}

} // namespace

TEST(GraphComplexity, AChain)
{
	CheckShape(
		[](FDescribedGraph& Graph, int32 Num)
		{
			for (int32 Pass = 0; Pass < Num; ++Pass)
			{
				Graph.Pass(Number("Pass", Pass), {Read(Number("X", Pass)), Write(Number("X", Pass + 1))});
			}
			Graph.Resource(Number("X", Num)).bExtracted = true;
		});
}

TEST(GraphComplexity, AChainThatNobodyReads)
{
	CheckShape(
		[](FDescribedGraph& Graph, int32 Num)
		{
			for (int32 Pass = 0; Pass < Num; ++Pass)
			{
				Graph.Pass(Number("Pass", Pass), {Read(Number("X", Pass)), Write(Number("X", Pass + 1))});
			}
		});
}

TEST(GraphComplexity, OneRenderPass)
{
	CheckShape(
		[](FDescribedGraph& Graph, int32 Num)
		{
			for (int32 Pass = 0; Pass < Num; ++Pass)
			{
				Graph.RasterPass(Number("Pass", Pass), "X");
			}
			Graph.Resource("X").bExtracted = true;
		});
}

TEST(GraphComplexity, ResourcesThatAllLiveAtOnce)
{
	CheckShape(
		[](FDescribedGraph& Graph, int32 Num)
		{
			for (int32 Pass = 0; Pass < Num / 2; ++Pass)
			{
				Graph.Pass(Number("Pass", Pass), {Write(Number("X", Pass))});
				Graph.Resource(Number("X", Pass)).Bytes = static_cast<uint64_t>(256 * (1 + Pass % 7));
			}
			for (int32 Pass = Num / 2; Pass < Num; ++Pass)
			{
				Graph.Pass(Number("Pass", Pass), {Read(Number("X", Num - Pass - 1)), Write("Sum")});
			}
			Graph.Resource("Sum").bExtracted = true;
		});
}

TEST(GraphComplexity, MipsOfOneTexture)
{
	CheckShape(
		[](FDescribedGraph& Graph, int32 Num)
		{
			Graph.Resource("X").NumMips = 3;
			for (int32 Pass = 0; Pass < Num; ++Pass)
			{
				Graph.Pass(Number("Pass", Pass), {ReadMip("X", Pass % 2), WriteMip("X", 1 - Pass % 2)});
			}
			Graph.Resource("X").bExtracted = true;
		});
}

TEST(GraphComplexity, OneName)
{
	CheckShape(
		[](FDescribedGraph& Graph, int32 Num)
		{
			for (int32 Pass = 0; Pass < Num; ++Pass)
			{
				Graph.Pass("Pass", {Read(Number("X", Pass)), Write(Number("X", Pass + 1))});
			}
			for (int32 Resource = 0; Resource <= Num; ++Resource)
			{
				Graph.Resource(Number("X", Resource)).Name = "X";
			}
			Graph.Resource(Number("X", Num)).bExtracted = true;
		});
}

namespace
{

/** Through the builder, with lambdas that do nothing. */
void RunChain(int32 Num)
{
	FGraphTest Graph;
	for (int32 Pass = 0; Pass < Num; ++Pass)
	{
		Graph.Pass("Pass")
			.Reads(Number("X", Pass % 2))
			.Writes(Number("X", 1 - Pass % 2))
			.Does([](FRHICommandListImmediate&) {});
	}
	Graph.Extract("X0");
	Graph.Run();
}

} // namespace

TEST(GraphComplexity, ARun)
{
	ExpectLinear(&RunChain);
}

TEST(GraphComplexity, ARunInImmediateMode)
{
	const FScopedConsoleVariable Immediate(TEXT("r.RDG.ImmediateMode"), 1);
	ExpectLinear(&RunChain);
}

TEST(GraphComplexity, NotesOfPasses)
{
	ExpectLinear(
		[](int32 Num)
		{
			FGraphTest Graph;
			for (int32 Pass = 0; Pass < Num; ++Pass)
			{
				FDiagnostic Note;
				Note.Message = Number("of ", Pass);
				AddGraphNote(*Graph.Builder, Note);
				AddGraphNote(*Graph.Builder, Note);
			}
			EXPECT_EQ(static_cast<size_t>(Num), GetGraphNotes(*Graph.Builder).size());
		});
}
