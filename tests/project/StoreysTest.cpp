// The order of the house: a storey includes only itself and the storeys below it, a room of a storey only itself and
// the rooms below it, and no two units (header and source) include each other, however long the way round.
#include <gtest/gtest.h>

#include "IncludeGraph.h"

#include <algorithm>
#include <regex>
#include <utility>

using namespace Drydock::Test;

namespace
{

/** Lowest first. */
const std::vector<std::string> GStoreys = {"rdg", "settings", "passes", "pipeline"};

/** The rooms of a storey, folders below it, lowest first. Those of one step stand side by side: none includes another.
 */
using FSteps = std::vector<std::vector<std::string>>;

const std::map<std::string, FSteps> GRooms = {
	{"rdg",
		{{"core/Core"}, {"core/Kernel"}, {"core/RHI"}, {"graph/Shader"}, {"graph/Graph"}, {"graph/Binding"},
			{"graph/GraphUtils"}, {"shader/Host"}, {"shader/Lanes"}, {"shader/Spirv/Module"}, {"shader/Spirv/Analyse"},
			{"shader/Spirv/Read"}, {"shader/Spirv/Emit", "shader/Spirv/Run"}, {"shader/Preprocessor"}, {"shader/Hlsl"},
			{"shader/Compiler"}, {"shader/Lint"}, {"inspect"}, {"vulkan"}}},
	{"settings", {{"Table"}, {"Blend", "Text"}, {"Final"}}},
	{"passes", {{"World"}, {"Scene"}, {"Screen"}, {"Blur"}, {"Exposure"}, {"Bloom"}, {"Tonemap"}, {"Lens"}, {"Toon"},
				   {"Native"}, {"Overlay"}}},
	{"pipeline", {{"Text"}, {"Picture"}, {"Scenes"}, {"Config"}, {"Objects"}, {"SceneFile"}, {"Effects"},
					 {"Extensions"}, {"Patch"}, {"Overlay"}, {"Chain"}, {"Frame"}, {"Budget"}, {"Run"},
					 {"Sequence", "Study", "Blend", "Import", "Inspect", "Prove", "Hazards", "Flicker"},
					 {"Matrix", "Report"}, {"Sweep"}, {"Live"}, {"Program"}}},
};

/** The storey that a path from the root begins with. */
std::string GetStorey(const std::string& File)
{
	return File.substr(0, File.find('/'));
}

size_t GetStoreyNumber(const std::string& File)
{
	return static_cast<size_t>(std::find(GStoreys.begin(), GStoreys.end(), GetStorey(File)) - GStoreys.begin());
}

struct FPlace
{
	std::string Room; // empty where no room has the file
	size_t Step = 0;
};

FPlace FindPlace(const std::string& File)
{
	const std::string Storey = GetStorey(File);
	const FSteps& Steps = GRooms.at(Storey);
	for (size_t Step = 0; Step < Steps.size(); ++Step)
	{
		for (const std::string& Room : Steps[Step])
		{
			if (File.starts_with(Storey + "/" + Room + "/"))
			{
				return {Room, Step};
			}
		}
	}
	return {};
}

/** Whether both lie in one storey that has rooms, and To in no room that From may include. */
bool GoesUpBetweenRooms(const std::string& From, const std::string& To)
{
	if (!GRooms.count(GetStorey(From)) || GetStorey(To) != GetStorey(From))
	{
		return false;
	}
	const FPlace FromPlace = FindPlace(From);
	const FPlace ToPlace = FindPlace(To);
	return ToPlace.Room != FromPlace.Room && ToPlace.Step >= FromPlace.Step;
}

const FSourceTexts& GetSources()
{
	static const FSourceTexts Sources = ReadSources(DRYDOCK_TEST_SOURCE_DIR, GStoreys);
	return Sources;
}

const std::vector<FInclude>& GetIncludes()
{
	static const std::vector<FInclude> Includes = FindIncludes(GetSources());
	return Includes;
}

std::string Join(const std::set<std::string>& Units)
{
	std::string Text;
	for (const std::string& Unit : Units)
	{
		Text += "\n  " + Unit;
	}
	return Text;
}

} // namespace

TEST(Storeys, IncludesGoDownOnly)
{
	for (const FInclude& Include : GetIncludes())
	{
		for (const std::string& To : Include.To)
		{
			EXPECT_LE(GetStoreyNumber(To), GetStoreyNumber(Include.From)) << Include.From << " includes " << To;
		}
	}
}

TEST(Storeys, EveryQuotedIncludeIsFoundInTheHouse)
{
	EXPECT_GT(GetIncludes().size(), 100u);
	for (const FInclude& Include : GetIncludes())
	{
		// A table of data that a source includes lies beside it.
		const std::filesystem::path Folder = std::filesystem::path(DRYDOCK_TEST_SOURCE_DIR) / Include.From;
		const bool bData =
			Include.Name.ends_with(".txt") && std::filesystem::exists(Folder.parent_path() / Include.Name);
		EXPECT_TRUE(bData || !Include.To.empty())
			<< Include.From << " includes \"" << Include.Name << "\", which no storey has";
	}
}

TEST(Storeys, PublicHeadersIncludeNoThirdPartyLibraryThatTheMacrosBreak)
{
	const std::regex Forbidden("(^|\n)\\s*#\\s*include\\s*<(fmt/|CLI/|OpenImageIO/|nlohmann/|rapidcheck|tbb/|oneapi/)");
	for (const auto& [Path, Text] : GetSources())
	{
		if (Path.ends_with(".h"))
		{
			EXPECT_FALSE(std::regex_search(Text, Forbidden)) << Path;
		}
	}
}

TEST(Rooms, EveryFileStandsInARoomOfItsStorey)
{
	for (const auto& [Path, Text] : GetSources())
	{
		if (GRooms.count(GetStorey(Path)))
		{
			EXPECT_NE("", FindPlace(Path).Room) << Path << " stands in no room of " << GetStorey(Path);
		}
	}
}

TEST(Rooms, IncludesGoDownOnly)
{
	for (const FInclude& Include : GetIncludes())
	{
		for (const std::string& To : Include.To)
		{
			EXPECT_FALSE(GoesUpBetweenRooms(Include.From, To))
				<< Include.From << " includes " << To << ", which stands above it or beside it";
		}
	}
}

TEST(Rooms, TheGraphAndTheShaderTierDoNotIncludeEachOther)
{
	for (const FInclude& Include : GetIncludes())
	{
		for (const std::string& To : Include.To)
		{
			EXPECT_FALSE(Include.From.starts_with("rdg/graph/") && To.starts_with("rdg/shader/"))
				<< Include.From << " " << To;
			EXPECT_FALSE(Include.From.starts_with("rdg/shader/") && To.starts_with("rdg/graph/"))
				<< Include.From << " " << To;
		}
	}
}

TEST(Rooms, IncludesOfThePipelineNameTheRoom)
{
	for (const FInclude& Include : GetIncludes())
	{
		for (const std::string& To : Include.To)
		{
			if (To.starts_with("pipeline/"))
			{
				EXPECT_EQ(To, "pipeline/" + Include.Name) << Include.From;
			}
		}
	}
}

TEST(Units, NoneIncludesItselfThroughOthers)
{
	for (const std::set<std::string>& Circle : FindCircles(MakeUnitGraph(GetIncludes())))
	{
		ADD_FAILURE() << "these include each other:" << Join(Circle);
	}
}
