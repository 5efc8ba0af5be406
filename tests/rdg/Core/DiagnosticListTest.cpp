// Lists of messages stay short, and say what they leave out.
#include <gtest/gtest.h>

#include "DiagnosticList.h"

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
	EXPECT_EQ("error DD1025: and 1134 more errors", Limited[100].ToString());
}

TEST(DiagnosticList, EachSeverityHasItsOwnHundred)
{
	std::vector<FDiagnostic> Diagnostics = Repeat(150, ESeverity::Warning);
	AddDiagnostic(Diagnostics = LimitDiagnostics(Diagnostics), {ESeverity::Error, 1012, "an error"});
	ASSERT_EQ(102u, Diagnostics.size());
	EXPECT_EQ("warning DD1025: and 50 more warnings", Diagnostics[100].ToString());
	EXPECT_EQ("an error", Diagnostics[101].Message);
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
	EXPECT_EQ("and 200 more errors", Limited[100].Message); // of 300
	EXPECT_EQ(Limited[100].Message, LimitDiagnostics(Limited)[100].Message);
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
