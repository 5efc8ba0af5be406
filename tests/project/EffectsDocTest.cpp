// docs/effects.md and the table of settings agree: every setting of an effect has a row there, with its range.
#include <gtest/gtest.h>

#include "Effects/Effects.h"
#include "PostProcessSettingsReflection.h"
#include "Config/SettingList.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

using namespace Drydock;

namespace
{

std::string ReadPage()
{
	std::ostringstream Text;
	Text << std::ifstream(DRYDOCK_TEST_SOURCE_DIR "/docs/effects.md").rdbuf();
	return Text.str();
}

/** Of an effect that drydock brought; the engine's own are in the engine's documentation. */
bool HasRow(const FSettingField& Field)
{
	return FindSettingOwner(Field.Name) != nullptr && std::string(Field.Doc).starts_with("drydock:");
}

/** The table row that names it in its first cell; empty where there is none. */
std::string FindRow(const std::string& Page, const std::string& Name)
{
	std::istringstream Lines(Page);
	for (std::string Line; std::getline(Lines, Line);)
	{
		const std::string First = Line.substr(0, Line.find('|', 1));
		if (Line.starts_with("| `") && First.find("`" + Name + "`") != std::string::npos)
		{
			return Line;
		}
	}
	return "";
}

} // namespace

TEST(EffectsDoc, EverySettingHasARowWithItsRange)
{
	const std::string Page = ReadPage();
	int NumChecked = 0;
	for (const FSettingField& Field : GetSettingFields())
	{
		if (HasRow(Field))
		{
			const std::string Row = FindRow(Page, Field.Name);
			EXPECT_NE("", Row) << Field.Name;
			EXPECT_NE(std::string::npos,
				Row.find("| " + FormatSettingRange(Field) + (FormatSettingRange(Field).empty() ? "" : " |")))
				<< Field.Name << ": " << FormatSettingRange(Field) << " in " << Row;
			++NumChecked;
		}
	}
	EXPECT_GT(NumChecked, 40);
}

TEST(EffectsDoc, WhatItNamesIsThere)
{
	const std::string Page = ReadPage();
	const std::regex Cell(
		"`((?:Diffusion|SoftFocus|Glow|CharaGlow|REDDof|ToonShadowBlur|UnityBloom|DualKawaseBlur|Bloom)[A-Za-z0-9]+)`");
	for (std::sregex_iterator It(Page.begin(), Page.end(), Cell), End; It != End; ++It)
	{
		EXPECT_NE(nullptr, FindSettingField((*It)[1])) << (*It)[1];
	}
}

TEST(EffectsDoc, PicturesAndConfigsExist)
{
	const std::string Page = ReadPage();
	const std::filesystem::path Root = DRYDOCK_TEST_SOURCE_DIR;
	const std::regex Picture("\\((images/[a-z_/]+\\.png)\\)"), Config("`([a-z_]+\\.json)`");
	int NumPictures = 0;
	for (std::sregex_iterator It(Page.begin(), Page.end(), Picture), End; It != End; ++It, ++NumPictures)
	{
		const std::filesystem::path File = Root / "docs" / (*It)[1].str();
		EXPECT_TRUE(std::filesystem::exists(File)) << File;
		EXPECT_LT(std::filesystem::file_size(File), 250u * 1000) << File;
	}
	EXPECT_GE(NumPictures, 8);
	for (std::sregex_iterator It(Page.begin(), Page.end(), Config), End; It != End; ++It)
	{
		if ((*It)[1] != "timing.json" && (*It)[1] != "run.json")
		{
			EXPECT_TRUE(std::filesystem::exists(Root / "configs" / (*It)[1].str())) << (*It)[1];
		}
	}
}
