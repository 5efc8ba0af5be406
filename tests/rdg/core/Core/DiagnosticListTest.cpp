// Lists of messages stay short, and say what they leave out.
#include <gtest/gtest.h>

#include "DiagnosticList.h"

#include <algorithm>
#include <chrono>

using namespace Drydock;

namespace
{

std::vector<FDiagnostic> Repeat(size_t Count, ESeverity Severity)
{
	std::vector<FDiagnostic> Diagnostics;
	for (size_t Index = 0; Index < Count; ++Index)
	{
		Diagnostics.push_back({Severity, 1012, "mistake " + std::to_string(Index)});
	}
	return Diagnostics;
}

} // namespace

TEST(DiagnosticList, TheFirstHundredStayAndTheOthersAreCounted)
{
	EXPECT_EQ(100u, LimitDiagnostics(Repeat(100, ESeverity::Error)).size());
	const std::vector<FDiagnostic> Limited = LimitDiagnostics(Repeat(1234, ESeverity::Error));
	ASSERT_EQ(101u, Limited.size());
	EXPECT_EQ("mistake 99", Limited[99].Message);
	EXPECT_EQ("error DD1025: and 1134 more like it (DD1012)", Limited[100].ToString());
}

TEST(DiagnosticList, EachSeverityHasItsOwnHundred)
{
	std::vector<FDiagnostic> Diagnostics = Repeat(150, ESeverity::Warning);
	AddDiagnostic(Diagnostics = LimitDiagnostics(Diagnostics), {ESeverity::Error, 1012, "an error"});
	ASSERT_EQ(102u, Diagnostics.size());
	EXPECT_EQ("warning DD1025: and 50 more like it (DD1012)", Diagnostics[100].ToString());
	EXPECT_EQ("an error", Diagnostics[101].Message);
}

TEST(DiagnosticList, EachNumberHasItsOwnHundred)
{
	std::vector<FDiagnostic> Diagnostics = LimitDiagnostics(Repeat(150, ESeverity::Error));
	AddDiagnostic(Diagnostics, {ESeverity::Error, 1013, "of another kind"});
	EXPECT_EQ("of another kind", Diagnostics.back().Message);
}

TEST(DiagnosticList, ListsThatWereLimitedAddUp)
{
	std::vector<FDiagnostic> Joined = LimitDiagnostics(Repeat(130, ESeverity::Error));
	for (const FDiagnostic& Diagnostic : LimitDiagnostics(Repeat(170, ESeverity::Error)))
	{
		Joined.push_back(Diagnostic);
	}
	const std::vector<FDiagnostic> Limited = LimitDiagnostics(Joined);
	ASSERT_EQ(101u, Limited.size());
	EXPECT_EQ("and 200 more like it (DD1012)", Limited[100].Message); // of 300
	EXPECT_EQ(Limited[100].Message, LimitDiagnostics(Limited)[100].Message);
}

TEST(DiagnosticList, TwentyAlikeAreShownAndOfMoreFive)
{
	EXPECT_EQ(20u, SummarizeDiagnostics(Repeat(20, ESeverity::Error)).size());
	const std::vector<FDiagnostic> Summary = SummarizeDiagnostics(Repeat(10'000, ESeverity::Error));
	ASSERT_EQ(6u, Summary.size());
	EXPECT_EQ("mistake 4", Summary[4].Message);
	EXPECT_EQ("error DD1025: and 9995 more like it (DD1012)", Summary[5].ToString());
}

TEST(DiagnosticList, WhatIsShownCountsWhatAListCountedAndKeepsOtherKinds)
{
	std::vector<FDiagnostic> Diagnostics = LimitDiagnostics(Repeat(10'000, ESeverity::Warning));
	Diagnostics.insert(Diagnostics.begin() + 50, {ESeverity::Warning, 1013, "of another kind"});
	Diagnostics.push_back({ESeverity::Error, 1012, "of another severity"});
	const std::vector<FDiagnostic> Summary = SummarizeDiagnostics(Diagnostics);
	ASSERT_EQ(8u, Summary.size());
	EXPECT_EQ("and 9995 more like it (DD1012)", Summary[5].Message);
	EXPECT_EQ("of another kind", Summary[6].Message);
	EXPECT_EQ("of another severity", Summary[7].Message);
}

TEST(DiagnosticList, AnErrorHoldsAllAndSaysTheFirst)
{
	const FError Error(Repeat(10'000, ESeverity::Error), ExitUsage);
	EXPECT_EQ(10'000u, Error.GetDiagnostics().size());
	const std::string What = Error.what();
	EXPECT_EQ(5, std::count(What.begin(), What.end(), '\n')); // six lines
}

TEST(DiagnosticList, ALongMessageIsCutBetweenCharacters)
{
	std::vector<FDiagnostic> Diagnostics;
	std::string Umlauts = "x"; // every second byte begins a character, and none begins at the limit
	for (int Index = 0; Index < 100'000; ++Index)
	{
		Umlauts += "\xC3\xBC";
	}
	AddDiagnostic(Diagnostics, {ESeverity::Error, 1012, Umlauts});
	EXPECT_EQ(Umlauts.substr(0, 1999) + "...", Diagnostics[0].Message);
}

TEST(NearestName, ATextOfMegabytesIsNoMisspelling)
{
	const auto Begin = std::chrono::steady_clock::now();
	EXPECT_EQ("", FindNearestName(std::string(10'000'000, 'x'), {"BloomIntensity", "xxxxxxx"}));
	EXPECT_LT(std::chrono::steady_clock::now() - Begin, std::chrono::seconds(1));
}

TEST(DiagnosticList, ATableStaysWholeAndALongSentenceIsCut)
{
	const std::string Table = "names are missing\n" + std::string(60'000, 'x') + "\n";
	EXPECT_EQ(Table, SummarizeDiagnostics({{.Message = Table}}).front().Message);
	EXPECT_EQ(std::string(2000, 'x') + "...",
		SummarizeDiagnostics({{.Message = std::string(2001, 'x') + "\n"}}).front().Message);
	EXPECT_EQ(64'003u, SummarizeDiagnostics({{.Message = "a\n" + std::string(70'000, 'x')}}).front().Message.size());
}
