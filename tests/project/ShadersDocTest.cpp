// docs/shaders.md names every include of the shader prelude, and none that does not exist.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

namespace
{

namespace fs = std::filesystem;

const fs::path Root = DRYDOCK_TEST_SOURCE_DIR;

std::string ReadDoc()
{
	std::ifstream File(Root / "docs/shaders.md");
	return std::string(std::istreambuf_iterator<char>(File), {});
}

} // namespace

TEST(ShadersDoc, NamesEveryInclude)
{
	const std::string Doc = ReadDoc();
	for (const fs::directory_entry& Entry : fs::recursive_directory_iterator(Root / "rdg/graph/Shaders/Engine"))
	{
		if (Entry.is_regular_file())
		{
			EXPECT_NE(std::string::npos, Doc.find(Entry.path().filename().string())) << Entry.path();
		}
	}
}

TEST(ShadersDoc, NamesNoneThatIsMissing)
{
	std::set<std::string> Names;
	for (const char* const Folder : {"rdg/graph/Shaders", "passes/Shaders"})
	{
		for (const fs::directory_entry& Entry : fs::recursive_directory_iterator(Root / Folder))
		{
			Names.insert(Entry.path().filename().string());
		}
	}
	// What stands under "Not there" is none of ours.
	const std::string Doc = ReadDoc();
	const std::string Listed = Doc.substr(0, Doc.find("\nNot there:"));
	const std::regex Word("[A-Za-z0-9]+\\.us[fh]");
	for (std::sregex_iterator It(Listed.begin(), Listed.end(), Word), End; It != End; ++It)
	{
		EXPECT_TRUE(Names.count(It->str())) << It->str();
	}
}
