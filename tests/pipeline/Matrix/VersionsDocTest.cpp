// docs/versions.md: its table is the program's own, and holds every difference between versions once. Set
// DRYDOCK_BLESS=1 to write the table anew after changing a version.
#include <gtest/gtest.h>

#include "Extensions/EngineHooks.h"
#include "VersionTable.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

using namespace Drydock;

namespace
{

const char* const Page = DRYDOCK_TEST_SOURCE_DIR "/docs/versions.md";
const std::string Begin = "<!-- made by VersionsDoc.TableIsTheProgramsOwn -->\n";
const std::string End = "<!-- end -->\n";

std::string ReadPage()
{
	std::ostringstream Text;
	Text << std::ifstream(Page).rdbuf();
	return Text.str();
}

/** What stands between the two marks. */
std::string ReadTable(const std::string& Text)
{
	const size_t From = Text.find(Begin) + Begin.size();
	return Text.substr(From, Text.find(End, From) - From);
}

/** The lines of the table that hold Part. */
std::vector<std::string> FindRows(const std::string& Part)
{
	std::vector<std::string> Rows;
	std::istringstream Lines(MakeVersionTable());
	for (std::string Line; std::getline(Lines, Line);)
	{
		if (Line.find(Part) != std::string::npos)
		{
			Rows.push_back(Line);
		}
	}
	return Rows;
}

} // namespace

TEST(VersionsDoc, TableIsTheProgramsOwn)
{
	const std::string Text = ReadPage();
	ASSERT_NE(std::string::npos, Text.find(Begin));
	if (std::getenv("DRYDOCK_BLESS") != nullptr)
	{
		const size_t From = Text.find(Begin) + Begin.size();
		std::ofstream(Page, std::ios::binary)
			<< Text.substr(0, From) << MakeVersionTable() << Text.substr(Text.find(End, From));
	}
	EXPECT_EQ(MakeVersionTable(), ReadTable(ReadPage())) << "run with DRYDOCK_BLESS=1 and commit";
}

// By hand: what is known of two of them.
TEST(VersionsDoc, RowsSayWhichVersions)
{
	EXPECT_EQ((std::vector<std::string>{"| hook `SubscribeToPostProcessingPass(EPostProcessingPass, "
										"FAfterPassCallbackDelegateArray&, bool)` | yes | yes | yes | yes | | | | |"}),
		FindRows("FAfterPassCallbackDelegateArray&"));
	const std::vector<std::string> Ramp = FindRows("`BloomThreshold`");
	ASSERT_EQ(1u, Ramp.size());
	EXPECT_TRUE(Ramp[0].ends_with("| yes | yes | yes | | | | | |")) << Ramp[0];
}

TEST(VersionsDoc, WhatDiffersHasARowAndNothingElseHas)
{
	for (const FHookVersions& Hook : GetHookVersions())
	{
		int NumCalling = 0;
		for (const FEngineProfile& Profile : GetEngineProfiles())
		{
			NumCalling += Profile.Minor >= Hook.First && Profile.Minor <= Hook.Last ? 1 : 0;
		}
		const bool bDiffers = NumCalling > 0 && NumCalling < static_cast<int>(GetEngineProfiles().size());
		EXPECT_EQ(bDiffers ? 1u : 0u, FindRows(std::string("`") + Hook.Signature + "`").size()) << Hook.Signature;
	}
	for (const FInsertionPoint& Point : GetInsertionPoints())
	{
		EXPECT_EQ(Point.First > GetEngineProfiles().front().Minor ? 1u : 0u, FindRows(Point.Doc).size()) << Point.Doc;
	}
}
