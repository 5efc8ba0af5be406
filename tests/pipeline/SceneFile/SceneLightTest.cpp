// The colour of a scene's main light, from the text in its header.
#include <gtest/gtest.h>

#include "SceneFile/SceneLight.h"

using namespace Drydock;

namespace
{

void ExpectColor(const FLinearColor& Expected, const std::string& Json)
{
	const std::optional<FLinearColor> Color = ReadSceneLightColor(Json);
	ASSERT_TRUE(Color) << Json;
	EXPECT_EQ(Expected.R, Color->R);
	EXPECT_EQ(Expected.G, Color->G);
	EXPECT_EQ(Expected.B, Color->B);
	EXPECT_EQ(1.0f, Color->A);
}

} // namespace

TEST(SceneLight, ColorIsRelativeToItsLargestComponent)
{
	ExpectColor(FLinearColor(1.0f, 0.75f, 0.5f, 1.0f), R"({"main_light_color": [8, 6, 4]})");
	ExpectColor(FLinearColor(0.5f, 0.0f, 1.0f, 1.0f), R"({"main_light_color": [0.025, 0, 0.05]})");
}

TEST(SceneLight, SceneWithoutOneSaysNone)
{
	EXPECT_FALSE(ReadSceneLightColor(""));
	EXPECT_FALSE(ReadSceneLightColor("{}"));
	EXPECT_FALSE(ReadSceneLightColor(R"({"position_uecm": [1, 2, 3]})"));
}

TEST(SceneLight, WhatIsNoColorCountsAsNone)
{
	for (const char* Color :
		{"[0, 0, 0]", "[1, 1]", "[1, 1, 1, 1]", "[1, -1, 1]", "7", "\"white\"", "[1, \"a\", 1]", "[1e999, 1, 1]"})
	{
		EXPECT_FALSE(ReadSceneLightColor(std::string(R"({"main_light_color": )") + Color + "}")) << Color;
	}
}
