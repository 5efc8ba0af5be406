// The text of an ini file as data: sections, commands, quotes, comments, and what is said of lines that are none.
#include <gtest/gtest.h>

#include "Objects/IniText.h"
#include "Objects/ObjectErrors.h"

using namespace Drydock;

namespace
{

/** `Section: Key=a|b; Key2=c` for each section, a line each; and the numbers of the lines that are warned of. */
std::string Read(const std::string& Text, std::vector<int>* OutWarned = nullptr)
{
	std::vector<FDiagnostic> Diagnostics;
	std::string Result;
	for (const FIniSection& Section : ReadIniText(Text, "Config/DefaultGame.ini", Diagnostics))
	{
		Result += Section.Name + ":";
		for (const FIniKey& Key : Section.Keys)
		{
			Result += " " + Key.Name + "=";
			for (size_t Index = 0; Index < Key.Values.size(); ++Index)
			{
				Result += (Index > 0 ? "|" : "") + Key.Values[Index].Text;
			}
			Result += ";";
		}
		Result += "\n";
	}
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		EXPECT_EQ(WarnIniLine, Diagnostic.Code);
		EXPECT_EQ(ESeverity::Warning, Diagnostic.Severity);
		EXPECT_EQ("Config/DefaultGame.ini", Diagnostic.File);
		if (OutWarned != nullptr)
		{
			OutWarned->push_back(Diagnostic.Line);
		}
	}
	EXPECT_TRUE(OutWarned != nullptr || Diagnostics.empty());
	return Result;
}

} // namespace

TEST(IniText, SectionsKeysAndComments)
{
	EXPECT_EQ("/Script/A.B: Key=Value; Other=a = b;\nSystemSettings: r.X=1;\n",
		Read("; first\n\n[/Script/A.B]\n Key = Value \r\n;Key=No\nOther=a = b\n\t[SystemSettings]\nr.X=1"));
	EXPECT_EQ("", Read(""));
	EXPECT_EQ("A: K=1;\n", Read("\xEF\xBB\xBF[A]\nK=1\n"));
}

TEST(IniText, TheLastPlainValueStays)
{
	EXPECT_EQ("A: K=2; L=;\n", Read("[A]\nK=1\nL=\n[a]\nk=2\n"));
}

TEST(IniText, CommandsChangeLists)
{
	EXPECT_EQ("A: K=1|2|3;\n", Read("[A]\n+K=1\n+K=2\n+K=1\n+K=3\n"));
	EXPECT_EQ("A: K=1|1;\n", Read("[A]\n.K=1\n.K=1\n"));
	EXPECT_EQ("A: K=2;\n", Read("[A]\n+K=1\n+K=2\n-K=1\n"));
	EXPECT_EQ("A: K=3;\n", Read("[A]\n+K=1\n!K=ClearArray\n+K=3\n"));
	EXPECT_EQ("A: K=;\n", Read("[A]\n+K=1\n!K=ClearArray\n"));
}

TEST(IniText, QuotesKeepWhatIsInThem)
{
	EXPECT_EQ("A: K= a;b ; L=say \"x\" \\;\n", Read("[A]\nK=\" a;b \"\nL=\"say \\\"x\\\" \\\\\"\n"));
}

TEST(IniText, LinesThatAreNoneAreWarnedOfAndLeftOut)
{
	std::vector<int> Warned;
	EXPECT_EQ("A:\n", Read("Early=1\n[A]\nno equals\n// comment\n=1\nK[0]=1\n@K=x\nL=\"open\nL=\"a\" b\n[\n", &Warned));
	EXPECT_EQ((std::vector<int>{1, 3, 4, 5, 6, 7, 8, 9, 10}), Warned);
}

TEST(IniText, KeysBehindABrokenSectionBelongToNone)
{
	std::vector<int> Warned;
	EXPECT_EQ("A: K=1;\n", Read("[A]\nK=1\n[B\nK=2\n", &Warned));
	EXPECT_EQ((std::vector<int>{3, 4}), Warned);
}
