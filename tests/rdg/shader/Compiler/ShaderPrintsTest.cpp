// What becomes of DrydockPrint, DrydockAssert and quoted texts in a shader.
#include <gtest/gtest.h>

#include "ShaderPrints.h"

#include <algorithm>

namespace
{

using Drydock::DeclarePrints;
using Drydock::RewritePrints;

using FStrings = std::vector<std::string>;

TEST(ShaderPrints, KernelsAreMadeWithoutThem)
{
	FStrings Strings;
	EXPECT_EQ("if (a) ; else ;\nb();",
		RewritePrints("if (a) DrydockPrint(\"x, %f)\", f(1, 2)); else DrydockAssert(a[0] > 1);\nb();", false, Strings));
	EXPECT_EQ("", DeclarePrints("if (a) ; else ;"));
}

TEST(ShaderPrints, KeptOnesAreOneStatementOfCalls)
{
	FStrings Strings;
	const std::string Kept = RewritePrints("DrydockPrint(\"sum \\\"%f\\\"\\n\", f(1, 2), g);", true, Strings);
	EXPECT_EQ("do { DrydockPrintText(0u); DrydockPrintValue(f(1, 2)); DrydockPrintValue(g); DrydockPrintEnd(); } while "
			  "(false);",
		Kept);
	EXPECT_EQ(FStrings{"sum \"%f\"\n"}, Strings);
	EXPECT_NE(std::string::npos, DeclarePrints(Kept).find("void DrydockPrintValue(float3 Value) {}"));
}

TEST(ShaderPrints, LinesStayWhereTheyAre)
{
	FStrings Strings;
	for (const bool bKeep : {false, true})
	{
		const std::string Text =
			RewritePrints("a\nDrydockPrint(\n\"x\",\n  y);\nDrydockAssert(a\n&& b); c", bKeep, Strings);
		EXPECT_EQ(5, std::count(Text.begin(), Text.end(), '\n')) << Text;
		EXPECT_EQ("c", Text.substr(Text.rfind(' ') + 1));
	}
}

TEST(ShaderPrints, AnAssertionKeepsItsText)
{
	FStrings Strings;
	EXPECT_EQ(
		"DrydockAssertValue(0u, (all(a > 0), b));", RewritePrints("DrydockAssert(all(a > 0), b);", true, Strings));
	EXPECT_EQ(FStrings{"all(a > 0), b"}, Strings);
}

TEST(ShaderPrints, TextsOfShaderPrintAreNumbersAndItsOwnFunctionStays)
{
	FStrings Strings;
	EXPECT_EQ("F DrydockText(uint Index) {} Print(C, DrydockText(0u)); Print(C, DrydockText(1u));",
		RewritePrints("F DrydockText(uint Index) {} Print(C, DrydockText(\"a\")); Print(C, DrydockText(\"b\"));", false,
			Strings));
	EXPECT_EQ((FStrings{"a", "b"}), Strings);
}

TEST(ShaderPrints, LeavesOtherWordsAndBrokenCallsAlone)
{
	FStrings Strings;
	for (const char* const Text :
		{"MyDrydockPrint(\"a\", b);", "DrydockPrint;", "DrydockPrint(\"a\", b", "\"DrydockPrint(1)\"", ""})
	{
		EXPECT_EQ(Text, RewritePrints(Text, true, Strings));
	}
	EXPECT_EQ(FStrings{}, Strings);
}

} // namespace
