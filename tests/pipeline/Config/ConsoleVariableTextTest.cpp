// How console variables are listed: filter, wrapping, help of one, JSON.
#include <gtest/gtest.h>

#include "Config/ConsoleVariableText.h"
#include "Text/Json.h"

#include <algorithm>
#include <sstream>

using namespace Drydock;

namespace
{

FConsoleVariableInfo MakeInfo(const char* Name, const char* Help = "Help.")
{
	return {Name, "int32", "5", "3", "Commandline", Help, false};
}

const std::vector<FConsoleVariableInfo> Three = {MakeInfo("r.Bloom"), MakeInfo("r.Bloom.Cross"), MakeInfo("r.Dof")};

std::string NamesOf(const std::vector<FConsoleVariableInfo>& Infos)
{
	std::string Names;
	for (const FConsoleVariableInfo& Info : Infos)
	{
		Names += std::string(*Info.Name) + " ";
	}
	return Names;
}

} // namespace

TEST(ConsoleVariableText, FilterIsAPartOfTheName)
{
	EXPECT_EQ("r.Bloom.Cross ", NamesOf(FilterConsoleVariables(Three, "cross")));
	EXPECT_EQ("r.Bloom r.Bloom.Cross r.Dof ", NamesOf(FilterConsoleVariables(Three, "")));
}

TEST(ConsoleVariableText, ExactNameIsOne)
{
	EXPECT_EQ("r.Bloom ", NamesOf(FilterConsoleVariables(Three, "R.BLOOM")));
}

TEST(ConsoleVariableText, PatternIsAWholeName)
{
	EXPECT_EQ("r.Bloom r.Bloom.Cross ", NamesOf(FilterConsoleVariables(Three, "r.bloom*")));
	EXPECT_EQ("r.Dof ", NamesOf(FilterConsoleVariables(Three, "r.?of")));
}

TEST(ConsoleVariableText, WrapsAtBlanks)
{
	EXPECT_EQ("  aa bb\n  cc\n", WrapText("aa bb cc", 8, "  "));
	EXPECT_EQ("  longerthanthat\n  b\n", WrapText("longerthanthat b", 8, "  "));
	EXPECT_EQ("a\nb\n", WrapText("a\nb", 8, ""));
}

TEST(ConsoleVariableText, ListNamesTheSetterAndWrapsTheHelp)
{
	EXPECT_EQ("name     type   value  default  set by\n"
			  "r.Bloom  int32  5      3        Commandline\n"
			  "    Help.\n",
		FormatConsoleVariables({MakeInfo("r.Bloom")}));
}

TEST(ConsoleVariableText, AllVariablesFitAHundredColumns)
{
	std::vector<FConsoleVariableInfo> Infos;
	for (const FConsoleVariableInfo& Info : ListConsoleVariables())
	{
		Infos.push_back(Info);
	}
	std::istringstream Lines(FormatConsoleVariables(Infos));
	for (std::string Line; std::getline(Lines, Line);)
	{
		EXPECT_LE(Line.size(), ConsoleListColumns) << Line;
	}
}

TEST(ConsoleVariableText, HelpOfOneIsTheConsoles)
{
	EXPECT_EQ("HELP for 'r.Bloom':\nFirst line.\nSecond line.\n\n"
			  "r.Bloom = \"5\"      LastSetBy: Commandline\ntype int32, default 3\n",
		FormatConsoleVariableHelp(MakeInfo("r.Bloom", "First line.\nSecond line.")));
}

TEST(ConsoleVariableText, JsonHasEveryColumn)
{
	EXPECT_EQ("[\n  {\"name\": \"r.Bloom\", \"type\": \"int32\", \"value\": \"5\", \"default\": \"3\", \"setBy\": "
			  "\"Commandline\", \"simulated\": true, \"help\": \"Help.\"}\n]\n",
		FormatConsoleVariablesAsJson({MakeInfo("r.Bloom")}));
}
