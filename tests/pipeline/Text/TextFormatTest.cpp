// Numbers and columns of printed texts.
#include <gtest/gtest.h>

#include "Text/TextFormat.h"

using namespace Drydock;

TEST(TextFormat, NumbersAreTheShortestThatReadBack)
{
	EXPECT_EQ("0.1", NumberText(0.1f));
	EXPECT_EQ("0.1", NumberText(0.1));
	EXPECT_EQ("0.10000000149011612", NumberText(static_cast<double>(0.1f)));
	EXPECT_EQ("-1", NumberText(-1.0f));
	EXPECT_EQ("1e+30", NumberText(1e30));
}

TEST(TextFormat, ColumnsAreAsWideAsTheirWidestCell)
{
	const auto IsFirst = [](size_t Column)
	{
		return Column == 0;
	};
	EXPECT_EQ("> name      ms\n> a       1.50\n> longer   2.0\n",
		AlignColumns({{"name", "ms"}, {"a", "1.50"}, {"longer", "2.0"}}, IsFirst, "> "));
}

TEST(TextFormat, LinesOfColumnsEndWithoutBlanks)
{
	EXPECT_EQ("a\nab  c\n", AlignColumns({{"a", ""}, {"ab", "c"}}, [](size_t) { return true; }));
}
