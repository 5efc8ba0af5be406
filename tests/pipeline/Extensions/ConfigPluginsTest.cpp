// Plugins: shared objects that a config loads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "DispatchReuse.h"
#include "Extensions/ExtensionErrors.h"
#include "Run/Run.h"

#include <filesystem>
#include <unistd.h>

using namespace Drydock;

namespace
{

const std::string Library = DRYDOCK_TEST_BINARY_DIR "/lib/libTestPlugin.so";

FRunResult RunWith(const std::string& More, const std::shared_ptr<FReuseCache>& Cache = nullptr)
{
	FRunOptions Options;
	Options.ReuseCache = Cache;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/test.json";
	Options.ConfigText = R"({"scene": {"file": "scenes/toon_character_641x359.exr"})" + More + "}";
	return RunConfig(Options);
}

std::string Plugins(const std::string& Path)
{
	return ", \"plugins\": [\"" + Path + "\"]";
}

bool IsRed(const FRunResult& Result)
{
	return Result.Final.Get(9, 9, 0) == 1.0 && Result.Final.Get(9, 9, 1) == 0.0 && Result.Final.Get(9, 9, 2) == 0.0;
}

} // namespace

TEST(Plugins, TakePartInTheRunsThatNameThem)
{
	const std::string Enabled = R"(, "cvars": {"r.TestPlugin.Enabled": 1})";
	const FRunResult With = RunWith(Plugins(Library) + Enabled);
	EXPECT_TRUE(IsRed(With));
	EXPECT_TRUE(With.Diagnostics.empty()) << With.Diagnostics[0].ToString();
	EXPECT_FALSE(IsRed(RunWith(Enabled)));
	EXPECT_TRUE(IsRed(RunWith(Plugins(Library) + Enabled)));
}

TEST(Plugins, ALibraryThatRegistersNothingIsReported)
{
	const FRunResult Result = RunWith(Plugins(DRYDOCK_TEST_BINARY_DIR "/lib/libEmptyPlugin.so"));
	ASSERT_EQ(1u, Result.Diagnostics.size());
	EXPECT_EQ(WarnPluginEmpty, Result.Diagnostics[0].Code);
	EXPECT_EQ("/plugins/0", Result.Diagnostics[0].Where);
}

TEST(Plugins, OneThatWasBuiltWithOtherHeadersIsNotLoaded)
{
	try
	{
		RunWith(Plugins(DRYDOCK_TEST_BINARY_DIR "/lib/libOldPlugin.so"));
		FAIL();
	}
	catch (const FError& Error)
	{
		ASSERT_EQ(1u, Error.GetDiagnostics().size());
		EXPECT_EQ(ErrorPluginNotLoaded, Error.GetDiagnostics()[0].Code);
		EXPECT_THAT(Error.GetDiagnostics()[0].Message,
			testing::HasSubstr("built with the headers of another drydock: build it again"));
	}
}

TEST(Plugins, AChangedFileIsLoadedAnew)
{
	namespace Files = std::filesystem;
	const Files::path Folder = Files::temp_directory_path() / ("drydock_plugins_" + std::to_string(getpid()));
	Files::create_directories(Folder);
	const Files::path Changing = Folder / "libChanging.so";
	int NumChanges = 0;
	const auto Cache = std::make_shared<FReuseCache>();
	// As a linker does: a new file in the place of the old one.
	const auto RunAs = [&](const std::string& Name)
	{
		Files::remove(Changing);
		Files::copy_file(DRYDOCK_TEST_BINARY_DIR "/lib/" + Name, Changing);
		Files::last_write_time(Changing, Files::file_time_type::clock::now() + std::chrono::seconds(++NumChanges));
		return RunWith(Plugins(Changing.string()), Cache);
	};
	EXPECT_FALSE(IsRed(RunAs("libEmptyPlugin.so")));
	EXPECT_TRUE(IsRed(RunAs("libStaticPlugin.so")));
	EXPECT_TRUE(IsRed(RunAs("libStaticPlugin.so")));
	const FRunResult Again = RunAs("libEmptyPlugin.so");
	EXPECT_FALSE(IsRed(Again));
	EXPECT_EQ(1u, Again.Diagnostics.size()) << "it registers nothing, and the old one is gone";
	Files::remove_all(Folder);
}
