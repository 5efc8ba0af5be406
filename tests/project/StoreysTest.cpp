// The house rule: rdg <- settings <- passes <- pipeline. A storey includes only itself and the ones below it.
// Source: drydock (docs/architecture.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace
{

namespace Files = std::filesystem;

const std::vector<std::string> GStoreys = {"rdg", "settings", "passes", "pipeline"};

int StoreyOf(const Files::path& RelativePath)
{
	const auto Found = std::find(GStoreys.begin(), GStoreys.end(), RelativePath.begin()->string());
	return Found == GStoreys.end() ? -1 : static_cast<int>(Found - GStoreys.begin());
}

/** Every source file of the storeys, relative to the root. */
std::vector<Files::path> FindSources(const Files::path& Root)
{
	std::vector<Files::path> Sources;
	for (const std::string& Storey : GStoreys)
	{
		for (const auto& Entry : Files::recursive_directory_iterator(Root / Storey))
		{
			const std::string Extension = Entry.path().extension().string();
			if (Extension == ".h" || Extension == ".cpp" || Extension == ".inl")
			{
				Sources.push_back(Files::relative(Entry.path(), Root));
			}
		}
	}
	std::sort(Sources.begin(), Sources.end());
	return Sources;
}

/** Where `#include "Name"` of a file can lead: files whose path ends with it. */
std::vector<Files::path> Resolve(
	const std::string& Name, const Files::path& From, const std::multimap<std::string, Files::path>& ByFileName)
{
	std::vector<Files::path> Found;
	const auto Range = ByFileName.equal_range(Files::path(Name).filename().string());
	for (auto It = Range.first; It != Range.second; ++It)
	{
		const std::string Path = "/" + It->second.generic_string();
		if (Path.size() > Name.size() &&
			Path.compare(Path.size() - Name.size() - 1, std::string::npos, "/" + Name) == 0)
		{
			Found.push_back(It->second);
		}
	}
	// A file beside the including one wins, as for the compiler.
	const Files::path Beside = (From.parent_path() / Name).lexically_normal();
	if (std::find(Found.begin(), Found.end(), Beside) != Found.end())
	{
		return {Beside};
	}
	return Found;
}

struct FInclude
{
	Files::path From;
	std::string Name;
	std::vector<Files::path> To;
};

std::vector<FInclude> FindIncludes(const Files::path& Root)
{
	const std::vector<Files::path> Sources = FindSources(Root);
	std::multimap<std::string, Files::path> ByFileName;
	for (const Files::path& Source : Sources)
	{
		ByFileName.emplace(Source.filename().string(), Source);
	}
	const std::regex Include("^\\s*#\\s*include\\s*\"([^\"]+)\"");
	std::vector<FInclude> Includes;
	for (const Files::path& Source : Sources)
	{
		std::ifstream File(Root / Source);
		for (std::string Line; std::getline(File, Line);)
		{
			std::smatch Match;
			if (std::regex_search(Line, Match, Include))
			{
				Includes.push_back({Source, Match[1], Resolve(Match[1], Source, ByFileName)});
			}
		}
	}
	return Includes;
}

} // namespace

TEST(Storeys, IncludesGoDownOnly)
{
	for (const FInclude& Include : FindIncludes(DRYDOCK_TEST_SOURCE_DIR))
	{
		for (const Files::path& To : Include.To)
		{
			EXPECT_LE(StoreyOf(To), StoreyOf(Include.From)) << Include.From << " includes " << To;
		}
	}
}

TEST(Storeys, EveryQuotedIncludeIsFoundInTheHouse)
{
	const std::vector<FInclude> Includes = FindIncludes(DRYDOCK_TEST_SOURCE_DIR);
	EXPECT_GT(Includes.size(), 100u);
	for (const FInclude& Include : Includes)
	{
		EXPECT_FALSE(Include.To.empty()) << Include.From << " includes \"" << Include.Name << "\", which no storey has";
	}
}

TEST(Storeys, PublicHeadersIncludeNoThirdPartyLibraryThatTheMacrosBreak)
{
	const std::regex Forbidden("^\\s*#\\s*include\\s*<(fmt/|CLI/|OpenImageIO/|nlohmann/|rapidcheck|tbb/|oneapi/)");
	for (const Files::path& Source : FindSources(DRYDOCK_TEST_SOURCE_DIR))
	{
		if (Source.extension() != ".h")
		{
			continue;
		}
		std::ifstream File(Files::path(DRYDOCK_TEST_SOURCE_DIR) / Source);
		for (std::string Line; std::getline(File, Line);)
		{
			EXPECT_FALSE(std::regex_search(Line, Forbidden)) << Source << ": " << Line;
		}
	}
}
