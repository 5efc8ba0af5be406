// What shaders print, by DrydockPrint and by the engine's ShaderPrint.
#include <gtest/gtest.h>

#include "InspectTestUtils.h"
#include "PrintedLines.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

FPrintedLines Collect(FShaderHarness& Harness)
{
	FInspectedShader& Shader = Harness.Inspect();
	EXPECT_TRUE(DoesPrint(Shader));
	return CollectPrints(Shader, MakeBound(Harness), Harness.GetArgs(), ListThreads(InspectWhole));
}

/** "(1, 0) 6: text" of each. */
std::vector<std::string> Describe(const FPrintedLines& Printed)
{
	std::vector<std::string> Lines;
	for (const FPrintedLine& Line : Printed.Lines)
	{
		Lines.push_back("(" + std::to_string(Line.At[0]) + ", " + std::to_string(Line.At[1]) + ") " +
						std::to_string(Line.Line) + ": " + Line.Text);
	}
	return Lines;
}

using FLines = std::vector<std::string>;

TEST(PrintedLines, PrintsValuesOfEveryTypeWhereTheConditionHolds)
{
	FShaderHarness Harness =
		MakeInspectedPixel("int2 At = int2(SvPosition.xy);\nif (all(At == int2(2, 1)))\n"
						   "\tDrydockPrint(\"at %d: %.2f of %v, %x %d\", At, SvPosition.x / 3, "
						   "float3(1, 2, 0.5), 255u, At.x > 1);\nelse\n\tAt = 0;\nOutColor = At.x;");
	EXPECT_EQ((FLines{"(2, 1) 7: at (2, 1): 0.83 of (1, 2, 0.5), ff true"}), Describe(Collect(Harness)));
}

TEST(PrintedLines, GoByThreadAndThenByRound)
{
	FShaderHarness Harness =
		MakeInspectedPixel("for (int i = 0; i < 2; ++i)\n{\n\tif (SvPosition.x < 2 && SvPosition.y < 1) "
						   "{ DrydockPrint(\"round\", i, i * 0.5); }\n}\nOutColor = 0;");
	EXPECT_EQ((FLines{"(0, 0) 7: round 0 0", "(0, 0) 7: round 1 0.5", "(1, 0) 7: round 0 0", "(1, 0) 7: round 1 0.5"}),
		Describe(Collect(Harness)));
}

TEST(PrintedLines, AreBounded)
{
	FShaderHarness Harness =
		MakeInspectedPixel("for (int i = 0; i < 100; ++i)\n{\n\tDrydockPrint(\"%d\", i);\n}\nOutColor = 0;");
	const FPrintedLines Printed = Collect(Harness);
	EXPECT_EQ(MaxPrintedLines, Printed.Lines.size());
	EXPECT_EQ(2400 - MaxPrintedLines, Printed.NumMore);
	EXPECT_EQ("99", Printed.Lines.back().Text);
}

TEST(PrintedLines, AShaderWithoutPrintsHasNone)
{
	FShaderHarness Harness = MakeInspectedPixel("OutColor = 1;");
	EXPECT_FALSE(DoesPrint(Harness.Inspect()));
}

TEST(PrintedLines, ConversionsAreHeeded)
{
	const FPrintedValue Third{{1.0 / 3.0}, ESpirvType::Float};
	EXPECT_EQ("0.333", FormatPrinted("%.3f", {Third}));
	EXPECT_EQ("100 % of 5", FormatPrinted("100 %% of %d", {{{5}, ESpirvType::Int}}));
	EXPECT_EQ("a % b", FormatPrinted("a % b", {}));
	EXPECT_EQ("x 1 (2, 3)", FormatPrinted("x", {{{1}, ESpirvType::Int}, {{2, 3}, ESpirvType::Float}}));
	EXPECT_EQ("50%", FormatPrinted("%d%", {{{50}, ESpirvType::Int}}));
	EXPECT_EQ("", FormatPrinted("", {}));
}

} // namespace
