// Plugins built by `drydock build` from a copy of their folder outside the tree, by g++ and, where it is there, by
// clang++: the pictures are those of the plugins that were built with this tree, bit for bit.
#include <gtest/gtest.h>

#include "ChildProcess.h"
#include "ProgramTestUtils.h"

using ProgramTest::FOutcome;
using ProgramTest::FProgramFolder;

namespace
{

namespace Files = std::filesystem;

class PluginCompilers : public testing::Test
{
protected:
	void Copy(const std::string& Plugin) const
	{
		Files::create_directories(Folder.Path / "Plugins");
		Files::copy(DRYDOCK_TEST_SOURCE_DIR "/tests/plugins/" + Plugin, Folder.Path / "Plugins" / Plugin,
			Files::copy_options::recursive);
	}

	/** Builds a copy of a plugin of tests/plugins and runs both, with arguments of their own. */
	void BuildAndCompare(
		const std::string& Plugin, const std::string& Arguments, const std::string& RunArguments = "") const
	{
		const FOutcome Built = Folder.Call("build Plugins/" + Plugin + " --out build/" + Plugin + " " + Arguments);
		ASSERT_EQ(0, Built.ExitCode) << Built.Printed;
		const std::string Name = "lib" + Plugin + ".so";
		Compare(Plugin, "build/" + Plugin + "/cmake/" + Name, DRYDOCK_TEST_BINARY_DIR "/lib/" + Name, RunArguments);
	}

	const FProgramFolder Folder{"plugin_compilers"};

private:
	void Compare(const std::string& Plugin, const std::string& Outside, const std::string& OfTree,
		const std::string& RunArguments) const
	{
		Folder.WriteFrame("none.json", "");
		const auto Run = [&](const std::string& Library, const std::string& Out)
		{
			const std::string Argument = Library.empty() ? "" : " --plugin '" + Library + "' " + RunArguments;
			const FOutcome Outcome = Folder.Call("run none.json --out " + Out + Argument);
			EXPECT_EQ(0, Outcome.ExitCode) << Outcome.Printed;
		};
		Run("", "none");
		Run(Outside, Plugin);
		Run(OfTree, Plugin + ".tree");
		for (const char* Picture : {"/final.exr", "/scene_linear.exr"})
		{
			EXPECT_TRUE(Folder.Read(Plugin + ".tree" + Picture) == Folder.Read(Plugin + Picture)) << Plugin << Picture;
		}
		EXPECT_FALSE(Folder.Read("none/final.exr") == Folder.Read(Plugin + "/final.exr")) << Plugin << " draws nothing";
	}
};

} // namespace

TEST_F(PluginCompilers, ThePluginWithAllNamesOfEffectsIsBuiltOutside)
{
	Copy("SameNames");
	Files::copy(DRYDOCK_TEST_BINARY_DIR "/tests/plugins/names/EffectNames.inl",
		Folder.Path / "Plugins/SameNames/Source/SameNames/Private/EffectNames.inl");
	BuildAndCompare("SameNames", "", "--set r.SameNames=1");
}

TEST_F(PluginCompilers, ClangsPicturesAreThoseOfGcc)
{
	if (Drydock::FindProgram("clang++").empty())
	{
		GTEST_SKIP() << "there is no clang++ here";
	}
	for (const char* Plugin : {"ArticleBlur", "FourTaps", "Tuned"})
	{
		Copy(Plugin);
		BuildAndCompare(Plugin, "--compiler clang++");
	}
}
