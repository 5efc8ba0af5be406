// Numbers of printed texts.
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
