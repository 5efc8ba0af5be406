// Configs that somebody made to cost much: time stays linear, and messages few. Time is that of the processor, as a
// multiple of what parsing the text takes; it was more than a thousand times that.
#include <gtest/gtest.h>

#include "Config/ReadConfig.h"
#include "PostProcessSettingsText.h"
#include "PostProcessSettingsTextVolume.h"

#include <algorithm>
#include <ctime>

using namespace Drydock;

namespace
{

struct FOutcome
{
	FConfig Config;
	std::vector<FDiagnostic> Diagnostics;
	double TimesParsing = 0.0; // processor time of reading, in that of parsing

	bool Says(const std::string& Part) const
	{
		return std::any_of(Diagnostics.begin(), Diagnostics.end(),
			[&](const FDiagnostic& Diagnostic) { return Diagnostic.Message.find(Part) != std::string::npos; });
	}
};

FOutcome Read(const std::string& Text)
{
	FOutcome Outcome;
	const std::clock_t Begin = std::clock();
	ParseConfigDocument(Text, "a.json");
	const std::clock_t Parsed = std::clock();
	Outcome.Config = ReadConfig(Text, "a.json", Outcome.Diagnostics);
	Outcome.TimesParsing = static_cast<double>(std::clock() - Parsed) / static_cast<double>(Parsed - Begin + 1);
	return Outcome;
}

/** Members NameIndex: Value. */
std::string MakeMembers(size_t Count, const std::string& Name, const std::string& Value)
{
	std::string Text;
	for (size_t Index = 0; Index < Count; ++Index)
	{
		Text += (Index > 0 ? ",\"" : "\"") + Name + std::to_string(Index) + "\":" + Value;
	}
	return Text;
}

} // namespace

TEST(ConfigLimits, ThousandsOfUnknownNamesAreNotAllLookedUp)
{
	const std::vector<std::string> Configs = {
		"{" + MakeMembers(20'000, "volumess", "1") + "}",
		"{\"cvars\":{" + MakeMembers(20'000, "r.BloomQualty", "1") + "}}",
		"{\"showFlags\":{" + MakeMembers(20'000, "EyeAdaptaton", "true") + "}}",
		"{\"camera\":{\"Settings\":{" + MakeMembers(20'000, "BloomIntensty", "1") + "}}}",
		"{\"camera\":{\"Settings\":{" + MakeMembers(20'000, "bOverride_BloomIntensty", "true") + "}}}",
	};
	for (const std::string& Config : Configs)
	{
		const FOutcome Outcome = Read(Config);
		EXPECT_LT(Outcome.TimesParsing, 200.0) << Config.substr(0, 60);
		ASSERT_EQ(101u, Outcome.Diagnostics.size()) << Config.substr(0, 60);
		EXPECT_EQ(0u, Outcome.Diagnostics.back().ToString().find("error DD1025: and 19900 more like it (DD"));
		EXPECT_NE(std::string::npos, Outcome.Diagnostics[0].Message.find("did you mean")) << Config.substr(0, 60);
		EXPECT_NE(std::string::npos, Outcome.Diagnostics[99].Message.find("did you mean")) << Config.substr(0, 60);
	}
}

TEST(ConfigLimits, ErrorsAreNotLostBehindAHundredWarnings)
{
	std::string Volumes;
	for (int Index = 0; Index < 200; ++Index)
	{
		Volumes += "{\"bUnbound\":true,\"BlendWeight\":2},\n";
	}
	const FOutcome Outcome = Read("{\"volumes\":[" + Volumes + "{\"bUnbound\":5}]}");
	EXPECT_TRUE(HasErrors(Outcome.Diagnostics));
	EXPECT_TRUE(Outcome.Says("expected true or false"));
	EXPECT_TRUE(Outcome.Says("and 100 more like it (DD1018)"));
}

TEST(ConfigLimits, VolumesAreCounted)
{
	std::string Volumes;
	for (int Index = 0; Index < 10'001; ++Index)
	{
		Volumes += std::string(Index > 0 ? "," : "") + "{\"bUnbound\":true}";
	}
	const FOutcome Outcome = Read("{\"volumes\":[" + Volumes + "]}");
	EXPECT_EQ(10'000u, Outcome.Config.Volumes.size());
	ASSERT_EQ(1u, Outcome.Diagnostics.size());
	EXPECT_EQ("/volumes/10000", Outcome.Diagnostics[0].Where);
}

/** The place of the first is counted from the beginning of the line for each of them. */
TEST(ConfigLimits, EngineTextOfOneLineWithManyMistakesIsReadInLinearTime)
{
	std::string Text = "(BloomIntensity=1";
	for (int Index = 0; Index < 200'000; ++Index)
	{
		Text += ",BloomIntensity=1,Unknown" + std::to_string(Index) + "=2";
	}
	std::vector<FDiagnostic> Diagnostics;
	const auto Begin = std::chrono::steady_clock::now();
	const FSettingsText Read = ReadSettingsText(Text + ")", "clip.txt", Diagnostics);
	EXPECT_LT(std::chrono::steady_clock::now() - Begin, std::chrono::seconds(10));
	EXPECT_EQ(200'000u, Read.Unknown.size());
	EXPECT_LT(Diagnostics.size(), 110u);
	EXPECT_TRUE(std::any_of(Diagnostics.begin(), Diagnostics.end(),
		[](const FDiagnostic& Diagnostic) { return Diagnostic.Message == "and 199900 more fields are wrong"; }));
}

TEST(ConfigLimits, EngineTextOfManyLinesWithMistakesIsAHundredMessages)
{
	std::string Text = "Begin Map\n";
	for (int Index = 0; Index < 20'000; ++Index)
	{
		Text += "End Actor\n";
	}
	std::vector<FDiagnostic> Diagnostics;
	ReadVolumesText(Text, "clip.txt", Diagnostics);
	ASSERT_EQ(101u, Diagnostics.size());
	EXPECT_EQ("clip.txt:2:1: error DD3008: expected End Map for the Begin Map at 1:1, found End Actor",
		Diagnostics[0].ToString());
}
