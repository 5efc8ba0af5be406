// Reads includes line by line, and finds circles by Tarjan's algorithm.
#include "IncludeGraph.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <regex>
#include <sstream>

namespace Drydock::Test
{

namespace
{

namespace Files = std::filesystem;

using FByFileName = std::multimap<std::string, std::string>;

std::vector<std::string> Resolve(
	const std::string& Name, const std::string& From, const FSourceTexts& Sources, const FByFileName& ByFileName)
{
	const std::string Beside = (Files::path(From).parent_path() / Name).lexically_normal().generic_string();
	if (Sources.count(Beside))
	{
		return {Beside};
	}
	std::map<size_t, std::vector<std::string>> FoundByDepth;
	const auto [First, Last] = ByFileName.equal_range(Files::path(Name).filename().string());
	for (auto It = First; It != Last; ++It)
	{
		if (("/" + It->second).ends_with("/" + Name))
		{
			FoundByDepth[std::count(It->second.begin(), It->second.end(), '/')].push_back(It->second);
		}
	}
	return FoundByDepth.empty() ? std::vector<std::string>() : FoundByDepth.begin()->second;
}

/** Tarjan: units are numbered as they are met; a circle is what lies above its first unit when that one is left. */
class FCircleFinder
{
public:
	explicit FCircleFinder(const FUnitGraph& InGraph)
		: Graph(InGraph)
	{
	}

	std::set<std::set<std::string>> Run()
	{
		for (const auto& [Unit, Included] : Graph)
		{
			if (!Numbers.count(Unit))
			{
				Visit(Unit);
			}
		}
		return std::move(Circles);
	}

private:
	/** The lowest number that can be reached from Unit among those that are still open. */
	size_t Visit(const std::string& Unit)
	{
		const size_t Number = Numbers.size();
		Numbers[Unit] = Number;
		Open.push_back(Unit);
		size_t Lowest = Number;
		if (const auto Found = Graph.find(Unit); Found != Graph.end())
		{
			for (const std::string& Included : Found->second)
			{
				if (!Numbers.count(Included))
				{
					Lowest = std::min(Lowest, Visit(Included));
				}
				else if (std::find(Open.begin(), Open.end(), Included) != Open.end())
				{
					Lowest = std::min(Lowest, Numbers[Included]);
				}
			}
		}
		if (Lowest == Number)
		{
			const auto First = std::find(Open.begin(), Open.end(), Unit);
			if (Open.end() - First > 1)
			{
				Circles.emplace(First, Open.end());
			}
			Open.erase(First, Open.end());
		}
		return Lowest;
	}

	const FUnitGraph& Graph;
	std::map<std::string, size_t> Numbers;
	std::vector<std::string> Open;
	std::set<std::set<std::string>> Circles;
};

} // namespace

FSourceTexts ReadSources(const Files::path& Root, const std::vector<std::string>& Folders)
{
	FSourceTexts Sources;
	for (const std::string& Folder : Folders)
	{
		for (Files::recursive_directory_iterator It(Root / Folder), End; It != End; ++It)
		{
			const Files::path Path = It->path();
			if (Path.filename().string().starts_with("."))
			{
				It.disable_recursion_pending();
				continue;
			}
			const std::string Extension = Path.extension().string();
			if (It->is_regular_file() && (Extension == ".h" || Extension == ".cpp" || Extension == ".inl"))
			{
				std::ifstream File(Path, std::ios::binary);
				Sources[Files::relative(Path, Root).generic_string()] = std::string(std::istreambuf_iterator(File), {});
			}
		}
	}
	return Sources;
}

std::vector<FInclude> FindIncludes(const FSourceTexts& Sources)
{
	FByFileName ByFileName;
	for (const auto& [Path, Text] : Sources)
	{
		ByFileName.emplace(Files::path(Path).filename().string(), Path);
	}
	const std::regex Pattern("^\\s*#\\s*include\\s*\"([^\"]+)\"");
	std::vector<FInclude> Includes;
	for (const auto& [Path, Text] : Sources)
	{
		std::istringstream Lines(Text);
		for (std::string Line; std::getline(Lines, Line);)
		{
			std::smatch Match;
			if (Line.find('#') != std::string::npos && std::regex_search(Line, Match, Pattern))
			{
				Includes.push_back({Path, Match[1], Resolve(Match[1], Path, Sources, ByFileName)});
			}
		}
	}
	return Includes;
}

std::string GetUnit(const std::string& File)
{
	return Files::path(File).replace_extension().generic_string();
}

FUnitGraph MakeUnitGraph(const std::vector<FInclude>& Includes)
{
	FUnitGraph Graph;
	for (const FInclude& Include : Includes)
	{
		for (const std::string& To : Include.To)
		{
			if (GetUnit(To) != GetUnit(Include.From))
			{
				Graph[GetUnit(Include.From)].insert(GetUnit(To));
			}
		}
	}
	return Graph;
}

std::set<std::set<std::string>> FindCircles(const FUnitGraph& Graph)
{
	return FCircleFinder(Graph).Run();
}

} // namespace Drydock::Test
