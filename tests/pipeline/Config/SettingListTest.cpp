// `drydock list settings`: what is found, how it reads, and the JSON of it.
#include <gtest/gtest.h>

#include "Config/SettingList.h"
#include "Text/Json.h"

#include <sstream>

using namespace Drydock;

namespace
{

FJsonValue Parse(const std::string& Text)
{
	std::vector<FDiagnostic> Diagnostics;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(Text, "list", Diagnostics, bSyntaxError);
	EXPECT_TRUE(Diagnostics.empty());
	return Root;
}

std::vector<std::string> NamesOf(const std::string& Pattern)
{
	std::vector<std::string> Names;
	for (const FSettingField* Field : FindSettingFields(Pattern))
	{
		Names.emplace_back(Field->Name);
	}
	return Names;
}

} // namespace

TEST(SettingList, FindsByPartAndByWildcards)
{
	EXPECT_EQ((std::vector<std::string>{"BloomDirtMask", "BloomDirtMaskIntensity", "BloomDirtMaskTint"}),
		NamesOf("dirtmask"));
	EXPECT_EQ((std::vector<std::string>{"BloomDirtMask"}), NamesOf("*DirtMask"));
	EXPECT_EQ(GetSettingFields().size(), NamesOf("").size());
	EXPECT_TRUE(NamesOf("Blom").empty());
}

TEST(SettingList, ReadsAsASentencePerFieldUnderItsCategory)
{
	EXPECT_EQ("Lens|Image Effects\n"
			  "  VignetteIntensity: float = 0.4, 0 .. 1, Lerp\n"
			  "    Darkening of the picture's corners.\n"
			  "\n"
			  "Motion Blur\n"
			  "  MotionBlurTargetFPS: int = 30, 0 .. 120, 1/s, Set\n"
			  "    Rate of frames that the amount refers to; 0: the actual one.\n",
		FormatSettings({FindSettingField("VignetteIntensity"), FindSettingField("MotionBlurTargetFPS")}));
}

TEST(SettingList, EnumsNameTheirValuesAndObjectsTheirClass)
{
	EXPECT_NE(
		std::string::npos, FormatSettings(FindSettingFields("ToonShadowBlurBlend")).find("One of Screen, Max, Add."));
	EXPECT_NE(std::string::npos,
		FormatSettings(FindSettingFields("FilmGrainTexture")).find("path of a Texture2D = None, SetIfNonZero"));
}

TEST(SettingList, LinesAreNoLongerThan80)
{
	std::istringstream Lines(FormatSettings(FindSettingFields("")));
	for (std::string Line; std::getline(Lines, Line);)
	{
		EXPECT_LE(Line.size(), 80u) << Line;
	}
}

TEST(SettingList, JsonHasValuesNotTexts)
{
	const FJsonValue Root = Parse(FormatSettingsJson(FindSettingFields("*DirtMask*")));
	ASSERT_EQ(3u, Root.Elements.size());
	EXPECT_EQ(EJsonType::Null, Root.Elements[0].Find("default")->Type);
	EXPECT_EQ("Texture", Root.Elements[0].Find("class")->String);
	EXPECT_EQ(0.0, Root.Elements[1].Find("min")->Number);
	EXPECT_EQ(EJsonType::Null, Root.Elements[1].Find("max")->Type);
	EXPECT_EQ(0.5, Root.Elements[2].Find("default")->Elements[0].Number);
}

TEST(SettingList, JsonOfAllSettingsParses)
{
	EXPECT_EQ(GetSettingFields().size(), Parse(FormatSettingsJson(FindSettingFields(""))).Elements.size());
}
