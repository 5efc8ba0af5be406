// Texts of the libraries name source files without the folders of the machine that built drydock.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace
{

/** What a command prints, line by line. */
std::string RunTool(const std::string& Command)
{
	std::string Text;
	FILE* const Pipe = popen(Command.c_str(), "r");
	char Part[4096];
	while (Pipe != nullptr && std::fgets(Part, sizeof(Part), Pipe) != nullptr)
	{
		Text += Part;
	}
	EXPECT_TRUE(Pipe != nullptr && pclose(Pipe) == 0) << Command;
	return Text;
}

} // namespace

TEST(BuildPaths, AreInNoMessage)
{
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
	GTEST_SKIP() << "sanitizers keep paths of their own";
#endif
	const std::string Root = DRYDOCK_TEST_SOURCE_DIR;
	for (const std::string Storey : {"rdg", "settings", "passes", "pipeline"})
	{
		const std::string Library = DRYDOCK_TEST_BINARY_DIR "/lib/libdrydock_" + Storey + ".so";
		const std::string Texts = RunTool("readelf --wide --string-dump=.rodata '" + Library + "'");
		EXPECT_NE(std::string::npos, Texts.find(Storey + "/")) << Library; // __FILE__, relative
		for (const std::string Folder : {"rdg/", "settings/", "passes/", "pipeline/"})
		{
			const size_t Found = Texts.find(Root + "/" + Folder);
			EXPECT_EQ(std::string::npos, Found) << Library << ": " << Texts.substr(Found, 200);
		}
	}
}
