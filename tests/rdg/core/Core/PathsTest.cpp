// The folders of a project and its plugins, as the .uplugin says, and whole files as text.
#include <gtest/gtest.h>

#include "CodeScope.h"
#include "Interfaces/IPluginManager.h"
#include "Misc/FileHelper.h"
#include "Misc/Paths.h"

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace
{

namespace Files = std::filesystem;

/** Two plugins of two projects: one with a .uproject, one that lies anywhere. */
class ProjectPaths : public testing::Test
{
protected:
	ProjectPaths()
		: Root(Files::temp_directory_path() / ("drydock_paths_" + std::to_string(getpid())))
	{
		Files::create_directories(Root / "Game/Plugins/Group/Tint/Source");
		Files::create_directories(Root / "Loose/Blur/Source");
		std::ofstream(Root / "Game/Game.uproject") << "{}";
		Register("libPathsTint.so", "PathsTint", Root / "Game/Plugins/Group/Tint");
		Register("libPathsBlur.so", "PathsBlur", Root / "Loose/Blur");
	}
	~ProjectPaths() override { Files::remove_all(Root); }

	static void Register(const std::string& Library, const std::string& Name, const Files::path& Folder)
	{
		Drydock::CallCode({.Plugin = Library, .Callback = "its registration"},
			[&] { IPluginManager::Get().RegisterPlugin(FString(Name), FString(Folder.string())); });
	}
	static std::string Ask(const std::string& Library, FString (*Function)())
	{
		std::string Answer;
		Drydock::CallCode({.Plugin = Library, .Callback = "a test"}, [&] { Answer = Function().ToStdString(); });
		return Answer;
	}

	Files::path Root;
};

TEST_F(ProjectPaths, AreThoseOfTheRunningPlugin)
{
	EXPECT_EQ((Root / "Game").string() + "/", Ask("libPathsTint.so", &FPaths::ProjectDir));
	EXPECT_EQ((Root / "Game/Plugins/Group").string() + "/", Ask("libPathsTint.so", &FPaths::ProjectPluginsDir));
	EXPECT_EQ((Root / "Game/Saved").string() + "/", Ask("libPathsTint.so", &FPaths::ProjectSavedDir));
	EXPECT_EQ((Root / "Loose").string() + "/", Ask("libPathsBlur.so", &FPaths::ProjectPluginsDir));
	EXPECT_EQ((Root / "Loose").string() + "/", Ask("libPathsBlur.so", &FPaths::ProjectDir));
}

TEST_F(ProjectPaths, SourcesAreTheProjectsOrThePlugins)
{
	EXPECT_EQ((Root / "Game/Plugins/Group/Tint/Source").string() + "/", Ask("libPathsTint.so", &FPaths::GameSourceDir));
	Files::create_directories(Root / "Game/Source");
	EXPECT_EQ((Root / "Game/Source").string() + "/", Ask("libPathsTint.so", &FPaths::GameSourceDir));
}

TEST_F(ProjectPaths, OutsideOfPluginsTheLastOneCounts)
{
	EXPECT_STREQ(("" + (Root / "Loose").string() + "/").c_str(), *FPaths::ProjectDir());
}

TEST_F(ProjectPaths, FilesAreWrittenAndAdded)
{
	const FString File((Root / "Log.txt").string());
	EXPECT_TRUE(FFileHelper::SaveStringToFile(TEXT("one"), *File));
	EXPECT_TRUE(FFileHelper::SaveStringToFile(FString(TEXT("two")) + LINE_TERMINATOR, *File,
		FFileHelper::EEncodingOptions::AutoDetect, &IFileManager::Get(), FILEWRITE_Append));
	FString Text;
	EXPECT_TRUE(FFileHelper::LoadFileToString(Text, *File));
	EXPECT_STREQ("onetwo\n", *Text);
	EXPECT_EQ(7, IFileManager::Get().FileSize(*File));
	EXPECT_FALSE(FFileHelper::LoadFileToString(Text, TEXT("/nowhere/at/all")));
}

TEST(PathNames, ExtensionsAndFolders)
{
	EXPECT_STREQ("a/b.ush", *FPaths::ChangeExtension(TEXT("a/b.usf"), TEXT("ush")));
	FString Folder = TEXT("a\\b/");
	FPaths::NormalizeDirectoryName(Folder);
	EXPECT_STREQ("a/b", *Folder);
}

} // namespace
