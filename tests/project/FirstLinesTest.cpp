// Every file opens with a sentence that says what it is for; where it comes from may follow, if not from drydock
// itself.
#include <gtest/gtest.h>

#include "IncludeGraph.h"

#include <regex>
#include <sstream>

namespace
{

/** The folders where it holds. */
const std::vector<std::string> GFolders = {"rdg", "settings", "passes", "pipeline", "tests/rdg", "tests/settings",
	"tests/passes", "tests/pipeline", "tests/project", "tests/stability", "bench"};

/** The comment lines that a file begins with, as one text. */
std::string GetOpening(const std::string& Text)
{
	std::string Opening;
	std::istringstream Lines(Text);
	for (std::string Line; std::getline(Lines, Line) && Line.starts_with("//");)
	{
		Opening += Line.substr(2);
	}
	return Opening;
}

} // namespace

TEST(FirstLines, SayWhatTheFileIsFor)
{
	const std::regex Sentence("^ (?!Sources?:)[A-Z`#a-z][^]*[.?:]( |$)");
	for (const auto& [Path, Text] : Drydock::Test::ReadSources(DRYDOCK_TEST_SOURCE_DIR, GFolders))
	{
		EXPECT_TRUE(std::regex_search(GetOpening(Text), Sentence)) << Path << " opens with:" << GetOpening(Text);
	}
}

TEST(FirstLines, DoNotNameDrydockAsTheSource)
{
	const std::regex Stamp("Source: drydock[.;,]");
	for (const auto& [Path, Text] : Drydock::Test::ReadSources(DRYDOCK_TEST_SOURCE_DIR, GFolders))
	{
		EXPECT_FALSE(std::regex_search(GetOpening(Text), Stamp)) << Path << " opens with:" << GetOpening(Text);
	}
}
