// docs/errors.md and the code know the same message numbers.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace
{

namespace Files = std::filesystem;

std::string ReadFile(const Files::path& Path)
{
	std::ostringstream Text;
	Text << std::ifstream(Path).rdbuf();
	return Text.str();
}

void CollectNumbers(const std::string& Text, const std::string& Pattern, std::set<int>& Numbers)
{
	const std::regex Number(Pattern);
	for (std::sregex_iterator It(Text.begin(), Text.end(), Number), End; It != End; ++It)
	{
		Numbers.insert(std::stoi((*It)[1]));
	}
}

/** Numbers as the code gives them: an enumerator `= 2003,`, or a literal beside the severity or as an argument of
 * Error. */
std::set<int> FindNumbersInCode()
{
	std::set<int> Numbers;
	for (const char* Storey : {"rdg", "settings", "passes", "pipeline"})
	{
		for (const auto& Entry : Files::recursive_directory_iterator(Files::path(DRYDOCK_TEST_SOURCE_DIR) / Storey))
		{
			const std::string Name = Entry.path().filename().string();
			const std::string Extension = Entry.path().extension().string();
			if (Extension != ".h" && Extension != ".cpp")
			{
				continue;
			}
			const std::string Text = ReadFile(Entry.path());
			CollectNumbers(Text, "(?:ESeverity::\\w+, |Error\\()([1-6][0-9]{3}),", Numbers);
			if (Name.find("Errors") != std::string::npos || Name.find("BindingPlan") != std::string::npos ||
				Name == "VertexDraw.h")
			{
				CollectNumbers(Text, "= ([1-6][0-9]{3}),", Numbers);
			}
		}
	}
	return Numbers;
}

std::set<int> FindNumbersInDocs()
{
	std::set<int> Numbers;
	CollectNumbers(ReadFile(DRYDOCK_TEST_SOURCE_DIR "/docs/errors.md"), "\\| DD([0-9]{4}) \\|", Numbers);
	return Numbers;
}

} // namespace

TEST(Errors, EveryNumberOfTheCodeIsDocumented)
{
	const std::set<int> Documented = FindNumbersInDocs();
	const std::set<int> Used = FindNumbersInCode();
	EXPECT_GT(Used.size(), 40u);
	for (const int Number : Used)
	{
		EXPECT_TRUE(Documented.count(Number)) << "DD" << Number << " is missing in docs/errors.md";
	}
}

TEST(Errors, TroubleshootingNamesNumbersThatExistEachOnce)
{
	const std::string Page = ReadFile(DRYDOCK_TEST_SOURCE_DIR "/docs/troubleshooting.md");
	const std::set<int> Documented = FindNumbersInDocs();
	const std::regex Number("\\n\\| (DD[0-9]{4}(, DD[0-9]{4})*) \\|");
	std::set<int> Found;
	size_t NumFound = 0;
	for (std::sregex_iterator Row(Page.begin(), Page.end(), Number), End; Row != End; ++Row)
	{
		std::set<int> OfRow;
		CollectNumbers((*Row)[1].str(), "DD([0-9]{4})", OfRow);
		NumFound += OfRow.size();
		Found.insert(OfRow.begin(), OfRow.end());
	}
	EXPECT_GT(NumFound, 30u);
	EXPECT_EQ(NumFound, Found.size());
	for (const int Each : Found)
	{
		EXPECT_TRUE(Documented.count(Each)) << "DD" << Each << " is missing in docs/errors.md";
	}
}

TEST(Errors, EveryDocumentedNumberIsUsed)
{
	const std::set<int> Used = FindNumbersInCode();
	for (const int Number : FindNumbersInDocs())
	{
		EXPECT_TRUE(Used.count(Number)) << "no code gives DD" << Number;
	}
}
