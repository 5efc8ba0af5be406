// Compiled graphs as text and as dot.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "GraphTestBuilder.h"
#include "RenderGraphDump.h"
#include "ScreenPass.h"

using namespace Drydock;
using testing::HasSubstr;
using testing::Not;

namespace
{

/** Three passes, one of them culled. */
FRDGCompiledGraph CompileThree()
{
	FGraphTest Graph("Frame");
	FRDGPassRef A = nullptr;
	Graph.External("Scene");
	Graph.Pass("Down").Reads("Scene").Writes("Half").Into(A);
	Graph.Pass("Waste").Reads("Half").Writes("Nowhere");
	Graph.Pass("Up").Reads("Half").Writes("Final");
	A->SetShader(*TShaderMapRef<FCopyRectPS>(GetGlobalShaderMap(GMaxRHIFeatureLevel)).GetShader());
	Graph.Extract("Final");
	return Graph.Builder->Compile();
}

} // namespace

TEST(Dump, ListsPassesWithShadersReadsAndWrites)
{
	const std::string Text = DumpText(CompileThree());
	EXPECT_THAT(Text, HasSubstr("graph Frame: 2 passes run, 1 culled"));
	EXPECT_THAT(Text, HasSubstr("   1  Down\n        shader   FCopyRectPS (CopyRectPS), runs as shader\n        reads  "
								"  Scene\n        writes   Half\n"));
}

TEST(Dump, ListsResourcesWithTheirPasses)
{
	const std::string Text = DumpText(CompileThree());
	EXPECT_THAT(Text, testing::ContainsRegex("Scene +.*4x4.* 1\\.\\.1 +external"));
	EXPECT_THAT(Text, testing::ContainsRegex("Half +.*4x4.* 1\\.\\.3 +heap at 0"));
	EXPECT_THAT(Text, testing::ContainsRegex("Final +.*4x4.* 3\\.\\.4 +extracted"));
}

TEST(Dump, ListsWhatIsLeftOutWithTheReason)
{
	const std::string Text = DumpText(CompileThree());
	EXPECT_THAT(Text,
		HasSubstr(
			"   2  Waste\n        no reader: output Nowhere is neither read by a surviving pass nor extracted\n"));
	EXPECT_THAT(Text, HasSubstr("all passes that use it are culled: Waste"));
}

TEST(Dump, StatesTheMemory)
{
	EXPECT_THAT(DumpText(CompileThree()),
		testing::ContainsRegex("transient +[0-9.]+ (B|KiB) with aliasing, [0-9.]+ (B|KiB) without"));
}

TEST(Dump, IsTheSameEveryTime)
{
	EXPECT_EQ(DumpText(CompileThree()), DumpText(CompileThree()));
	EXPECT_EQ(DumpDot(CompileThree()), DumpDot(CompileThree()));
}

TEST(Dump, DotHasANodeForEachAndEdgesForUses)
{
	const std::string Text = DumpDot(CompileThree());
	EXPECT_THAT(Text, HasSubstr("digraph \"Frame\" {"));
	EXPECT_THAT(Text, HasSubstr("p1 [shape=box"));
	EXPECT_THAT(Text, HasSubstr("\tr0 -> p1;\n\tp1 -> r1;\n"));
	EXPECT_THAT(Text, HasSubstr("\tp2 -> r2 [color=grey, style=dashed];\n"));
}

TEST(Dump, DotEscapesNames)
{
	FGraphTest Graph("A \"quoted\" name");
	Graph.Pass("A").Writes("X");
	EXPECT_THAT(DumpDot(Graph.Builder->Compile()), HasSubstr("digraph \"A \\\"quoted\\\" name\""));
}

TEST(Dump, TransitionsAreOneLineEach)
{
	const std::string Text = DumpTransitions(CompileThree());
	EXPECT_THAT(Text, HasSubstr("0 -> 1  Half: Discard -> UAVCompute\n"));
	EXPECT_THAT(Text, HasSubstr("1 -> 3  Half: UAVCompute -> SRVCompute\n"));
	EXPECT_THAT(Text, Not(HasSubstr("Nowhere")));
}

TEST(Dump, BytesAreReadable)
{
	EXPECT_EQ("640 B", DescribeBytes(640));
	EXPECT_EQ("1.5 KiB", DescribeBytes(1536));
	EXPECT_EQ("2.50 MiB", DescribeBytes(2621440));
}

TEST(Dump, FlagsAreNamed)
{
	EXPECT_EQ("Compute|NeverCull", DescribePassFlags(ERDGPassFlags::Compute | ERDGPassFlags::NeverCull));
	EXPECT_EQ("None", DescribePassFlags(ERDGPassFlags::None));
}

TEST(Dump, ResourcesOfOneNameAreNumbered)
{
	FGraphTest Graph;
	FRDGTextureRef First = Graph.Builder->CreateTexture(FGraphTest::MakeDesc(), TEXT("Blur"));
	FRDGTextureRef Second = Graph.Builder->CreateTexture(FGraphTest::MakeDesc(), TEXT("Blur"));
	Graph.Textures["First"] = First;
	Graph.Textures["Second"] = Second;
	Graph.Pass("A").Writes("First");
	Graph.Pass("B").Reads("First").Writes("Second");
	Graph.Extract("Second");
	EXPECT_THAT(DumpText(Graph.Builder->Compile()), HasSubstr("reads    Blur\n        writes   Blur #2\n"));
}
