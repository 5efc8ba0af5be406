// The order of the house: a storey includes only itself and the storeys below it, a room of a storey only itself and
// the rooms below it, and no two units (header and source) include each other, however long the way round.
#include <gtest/gtest.h>

#include "IncludeGraph.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <utility>

using namespace Drydock::Test;

namespace
{

/** Lowest first. */
const std::vector<std::string> GStoreys = {"rdg", "settings", "passes", "pipeline"};

/** The rooms of a storey, lowest first. Those of one step stand side by side: none includes another. */
using FSteps = std::vector<std::vector<std::string>>;

const std::map<std::string, FSteps> GRooms = {
	{"rdg", {{"Core"}, {"Kernel"}, {"RHI"}, {"Lanes"}, {"Spirv"}, {"ShaderCompiler"}, {"Shader"}, {"Graph"},
				{"Binding"}, {"Inspect"}, {"Vulkan"}, {"GraphUtils"}}},
	{"passes", {{"Scene"}, {"Screen"}, {"Blur"}, {"Exposure"}, {"Bloom"}, {"Tonemap"}, {"Lens"}, {"Toon"}, {"Native"}}},
	{"pipeline", {{"Text"}, {"Picture"}, {"Config"}, {"Objects"}, {"SceneFile"}, {"Effects"}, {"Extensions"}, {"Chain"},
					 {"Frame"}, {"Budget"}, {"Run"},
					 {"Sequence", "Study", "Blend", "Patch", "Import", "Inspect", "Prove", "Hazards"},
					 {"Matrix", "Report"}, {"Program"}}},
};

/** The folders of a path from the root. */
std::vector<std::string> Split(const std::string& Path)
{
	std::vector<std::string> Parts;
	std::istringstream Stream(Path);
	for (std::string Part; std::getline(Stream, Part, '/');)
	{
		Parts.push_back(Part);
	}
	return Parts;
}

size_t GetStoreyNumber(const std::string& File)
{
	return static_cast<size_t>(std::find(GStoreys.begin(), GStoreys.end(), Split(File).at(0)) - GStoreys.begin());
}

/** The step that a file's room stands on; -1 where there is no such room. */
int GetStep(const FSteps& Steps, const std::string& File)
{
	const std::string Room = Split(File).at(1);
	const auto Found = std::find_if(Steps.begin(), Steps.end(),
		[&Room](const std::vector<std::string>& Step)
		{ return std::find(Step.begin(), Step.end(), Room) != Step.end(); });
	return Found == Steps.end() ? -1 : static_cast<int>(Found - Steps.begin());
}

/** Whether both lie in one storey that has rooms, and To in no room that From may include. */
bool GoesUpBetweenRooms(const std::string& From, const std::string& To)
{
	const std::vector<std::string> FromParts = Split(From);
	const std::vector<std::string> ToParts = Split(To);
	const auto Rooms = GRooms.find(FromParts[0]);
	if (Rooms == GRooms.end() || ToParts[0] != FromParts[0] || ToParts[1] == FromParts[1])
	{
		return false;
	}
	return GetStep(Rooms->second, To) >= GetStep(Rooms->second, From);
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
		EXPECT_FALSE(Include.To.empty()) << Include.From << " includes \"" << Include.Name << "\", which no storey has";
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
		if (const auto Rooms = GRooms.find(Split(Path)[0]); Rooms != GRooms.end())
		{
			EXPECT_GE(GetStep(Rooms->second, Path), 0) << Path << " stands in no room of " << Rooms->first;
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
