// What `drydock new` writes, and what it refuses. Building and running a patch: docs/first-patch.md, which a test
// carries out.
#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include "Diagnostics.h"
#include "Patch/PatchTemplate.h"
#include "Program/CommandLine.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <unistd.h>

using namespace Drydock;

namespace
{

namespace Files = std::filesystem;

/** A folder that goes away. */
class PatchTemplate : public testing::Test
{
protected:
	PatchTemplate()
		: Folder(Files::temp_directory_path() / ("drydock_patch_" + std::to_string(getpid())))
	{
		Files::remove_all(Folder);
		Files::create_directories(Folder);
	}
	~PatchTemplate() override { Files::remove_all(Folder); }

	std::string Path(const std::string& Name) const { return (Folder / Name).string(); }

	/** `drydock new`: exit code and number of the message, 0 if there is none. */
	std::pair<int, int> New(const std::string& Name, const std::string& Dir)
	{
		testing::internal::CaptureStdout();
		std::pair<int, int> Outcome = {ExitDone, 0};
		try
		{
			CallProgram({"new", Name, "--dir", Dir, "--json"});
		}
		catch (const FError& Error)
		{
			Outcome = {Error.GetExitCode(), Error.GetDiagnostics().front().Code};
		}
		Out = testing::internal::GetCapturedStdout();
		return Outcome;
	}

	size_t CountFiles() const
	{
		return static_cast<size_t>(std::distance(Files::directory_iterator(Folder), Files::directory_iterator()));
	}

	const Files::path Folder;
	std::string Out;
};

std::string ReadText(const Files::path& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

bool Contains(const std::string& Text, const std::string& Part)
{
	return Text.find(Part) != std::string::npos;
}

} // namespace

TEST_F(PatchTemplate, EveryMentionIsRenamedOnce)
{
	EXPECT_EQ("FRainPS, lib_Rain.so", RenamePatch("FMyPatchPS, lib_MyPatch.so", "Rain"));
	EXPECT_EQ("FMyPatch2PS", RenamePatch("FMyPatchPS", "MyPatch2"));
}

TEST_F(PatchTemplate, TheProjectHasTheLayoutOfAPlugin)
{
	std::vector<std::string> Paths;
	for (const FPatchFile& File : MakePatchFiles("Rain"))
	{
		Paths.push_back(File.Path);
	}
	const std::vector<std::string> Expected = {".github/workflows/drydock.yml", ".gitignore", ".vscode/launch.json",
		".vscode/settings.json", ".vscode/tasks.json", "CMakeLists.txt", "README.md", "Rain.uplugin",
		"Shaders/Private/DrydockPrint.ush", "Shaders/Private/Rain.usf", "Source/Rain/Private/RainModule.cpp",
		"Source/Rain/Private/RainViewExtension.cpp", "Source/Rain/Private/RainViewExtension.h",
		"Source/Rain/Rain.Build.cs", "configs/Rain.json", "configs/scenes/room.exr",
		"configs/schema/drydock.schema.json", "tests/RainTest.cpp"};
	EXPECT_EQ(Expected, Paths);
}

TEST_F(PatchTemplate, NothingIsCalledAsTheTemplate)
{
	for (const FPatchFile& File : MakePatchFiles("Rain"))
	{
		EXPECT_FALSE(Contains(File.Path + File.Text, "MyPatch")) << File.Path;
	}
}

// What is pasted to the engine must not know of drydock, but for the header that makes drydock's own words nothing
// there.
TEST_F(PatchTemplate, SourcesAndShadersAreTheEnginesAlone)
{
	for (const FPatchFile& File : MakePatchFiles("Rain"))
	{
		if (File.Path == "Shaders/Private/DrydockPrint.ush")
		{
			EXPECT_TRUE(
				Contains(File.Text, "#ifndef DRYDOCK\n#define DrydockPrint(...)\n#define DrydockAssert(...)\n#endif"));
		}
		else if (File.Path.starts_with("Source/") || File.Path.starts_with("Shaders/") || File.Path == "Rain.uplugin")
		{
			EXPECT_FALSE(Contains(File.Text, "rydock")) << File.Path;
			EXPECT_FALSE(Contains(File.Text, "DRYDOCK")) << File.Path;
		}
	}
}

TEST_F(PatchTemplate, TheConfigLoadsWhatTheBuildFileBuilds)
{
	for (const FPatchFile& File : MakePatchFiles("Rain"))
	{
		if (File.Path == "configs/Rain.json")
		{
			const nlohmann::json Config = nlohmann::json::parse(File.Text, nullptr, true, true);
			EXPECT_EQ("../build/libRain.so", Config["plugins"][0]);
			EXPECT_EQ("scenes/room.exr", Config["scene"]["file"]);
		}
		if (File.Path == "CMakeLists.txt")
		{
			EXPECT_TRUE(Contains(File.Text, "find_package(drydock CONFIG REQUIRED)"));
			EXPECT_TRUE(Contains(File.Text, "drydock_add_plugin(Rain\n"));
		}
	}
}

// F5 in an editor: gdb on this config, with the program's own arguments.
TEST_F(PatchTemplate, TheEditorDebugsTheShadersOfTheConfig)
{
	for (const FPatchFile& File : MakePatchFiles("Rain"))
	{
		if (File.Path != ".vscode/launch.json")
		{
			continue;
		}
		const nlohmann::json Launch = nlohmann::json::parse(File.Text, nullptr, true, true);
		const nlohmann::json& Shaders = Launch["configurations"][0];
		const nlohmann::json Arguments = {"drydock", "run", "${workspaceFolder}/configs/Rain.json", "--debug-shaders",
			"${input:pixel}", "--passes", "${input:pass}"};
		EXPECT_EQ(Arguments, Shaders["args"]);
		EXPECT_EQ("set breakpoint pending on", Shaders["setupCommands"][0]["text"]);
		EXPECT_EQ("FRainPS", Launch["inputs"][1]["default"]);
		EXPECT_EQ("build", Shaders["preLaunchTask"]);
		EXPECT_EQ("build", Launch["configurations"][1]["preLaunchTask"]);
	}
}

// The lines are those that the pages show, which are compared with what is printed.
TEST_F(PatchTemplate, TheEditorListsErrorsOfShadersAndConfigs)
{
	for (const FPatchFile& File : MakePatchFiles("MyPatch"))
	{
		if (File.Path != ".vscode/tasks.json")
		{
			continue;
		}
		const nlohmann::json Tasks = nlohmann::json::parse(File.Text, nullptr, true, true)["tasks"];
		EXPECT_EQ("build", Tasks[0]["label"]);
		EXPECT_EQ("build", Tasks[1]["dependsOn"]);
		const auto FindLine = [&](const std::string& Page, size_t Matcher)
		{
			const std::regex Pattern(Tasks[1]["problemMatcher"][Matcher]["pattern"]["regexp"].get<std::string>());
			std::ifstream Lines(DRYDOCK_TEST_SOURCE_DIR "/docs/" + Page);
			std::vector<std::string> Groups;
			for (std::string Line; std::getline(Lines, Line) && Groups.empty();)
			{
				std::smatch Match;
				if (std::regex_match(Line, Match, Pattern))
				{
					Groups.assign(Match.begin() + 1, Match.begin() + 5);
				}
			}
			return Groups;
		};
		EXPECT_EQ(
			(std::vector<std::string>{"Private/MyPatch.usf", "21", "17", "error"}), FindLine("first-patch.md", 0));
		EXPECT_EQ((std::vector<std::string>{"configs/a.json", "12", "7", "error"}), FindLine("errors.md", 1));
	}
}

TEST_F(PatchTemplate, ThePluginIsOneModuleLoadedBeforeShadersCompile)
{
	for (const FPatchFile& File : MakePatchFiles("Rain"))
	{
		if (File.Path == "Rain.uplugin")
		{
			const nlohmann::json Plugin = nlohmann::json::parse(File.Text);
			EXPECT_EQ(1u, Plugin["Modules"].size());
			EXPECT_EQ("Rain", Plugin["Modules"][0]["Name"]);
			EXPECT_EQ("PostConfigInit", Plugin["Modules"][0]["LoadingPhase"]);
		}
	}
}

TEST_F(PatchTemplate, FilesAreWrittenAsTheyAre)
{
	WritePatch(Path("Rain"), {{"a/b.txt", "text\n"}, {"c", std::string("\0\xff", 2)}});
	EXPECT_EQ("text\n", ReadText(Folder / "Rain/a/b.txt"));
	EXPECT_EQ(std::string("\0\xff", 2), ReadText(Folder / "Rain/c"));
}

TEST_F(PatchTemplate, NothingIsLeftBesideTheProject)
{
	WritePatch(Path("Rain"), {{"a/b.txt", "text\n"}});
	EXPECT_EQ(1u, CountFiles());
}

TEST_F(PatchTemplate, JsonNamesTheFolderAndTheFiles)
{
	EXPECT_EQ(std::make_pair(0, 0), New("Rain", Path("deep/er")));
	const nlohmann::json Json = nlohmann::json::parse(Out);
	EXPECT_EQ("Rain", Json["name"]);
	EXPECT_EQ(Path("deep/er/Rain"), Json["folder"].get<std::string>());
	for (const nlohmann::json& File : Json["files"])
	{
		EXPECT_TRUE(Files::is_regular_file(Folder / "deep/er/Rain" / File.get<std::string>())) << File;
	}
}

TEST_F(PatchTemplate, ABadNameIsAUsageErrorAndWritesNothing)
{
	EXPECT_EQ(std::make_pair(2, 1060), New("My-Patch", Folder.string()));
	EXPECT_EQ(0u, CountFiles());
	EXPECT_EQ("DD1060", nlohmann::json::parse(Out).at("messages").at(0).at("code"));
}

TEST_F(PatchTemplate, AnExistingFolderIsLeftAlone)
{
	Files::create_directory(Folder / "Rain");
	EXPECT_EQ(std::make_pair(2, 1061), New("Rain", Folder.string()));
	EXPECT_TRUE(Files::is_empty(Folder / "Rain"));
	EXPECT_EQ(1u, CountFiles());
}

TEST_F(PatchTemplate, AFileOrADanglingLinkOfThatNameIsLeftAlone)
{
	std::ofstream(Folder / "Rain") << "mine";
	Files::create_symlink("nowhere", Folder / "Snow");
	EXPECT_EQ(std::make_pair(2, 1061), New("Rain", Folder.string()));
	EXPECT_EQ(std::make_pair(2, 1061), New("Snow", Folder.string()));
	EXPECT_EQ("mine", ReadText(Folder / "Rain"));
	EXPECT_TRUE(Files::is_symlink(Folder / "Snow"));
}

TEST_F(PatchTemplate, WhereNothingCanBeWrittenIsAFileError)
{
	std::ofstream(Folder / "file") << "";
	EXPECT_EQ(std::make_pair(3, 5004), New("Rain", Path("file")));
	EXPECT_EQ(1u, CountFiles());
}
