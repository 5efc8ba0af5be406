// Reads the table, and compares what a shader includes and calls with it.
#include "EngineNames.h"

#include "InstallPaths.h"
#include "RangeTools.h"
#include "ShaderDirectories.h"
#include "ShaderEntries.h"
#include "ShaderSource.h"
#include "TextTools.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

namespace Drydock
{

const std::vector<FEngineName>& GetEngineNames()
{
	static const std::vector<FEngineName> Names = []
	{
		std::vector<FEngineName> Rows;
		std::ifstream File(FindShippedShaders() + "/rdg/graph/Shaders/EngineNames.txt");
		const std::string Text{std::istreambuf_iterator<char>(File), {}};
		for (std::vector<std::string>& Columns : SplitRows(Text))
		{
			Columns.resize(6);
			Rows.push_back({Columns[0], Columns[1], Columns[2], Columns[3], Columns[4], Columns[5]});
		}
		return Rows;
	}();
	return Names;
}

std::vector<size_t> ListDefinitions(const FHlslText& Text)
{
	std::vector<size_t> Names = ToVector<size_t>(ListFunctionTexts(Text), &FFunctionText::Name);
	for (size_t At = 0; At < Text.Size(); At = std::max(At, Text.FindClose(At)) + 1)
	{
		if (Text.Is(At, "struct") && Text.IsWord(At + 1))
		{
			Names.push_back(At + 1);
		}
		else if (Text.Is(At, "static") && Text.Is(At + 1, "const") && Text.IsWord(At + 3))
		{
			Names.push_back(At + 3);
		}
	}
	return Names;
}

bool IsShipped(const std::string& File, const FShaderCompileRequest& Request)
{
	const bool bGenerated = std::any_of(Request.GeneratedFiles.begin(), Request.GeneratedFiles.end(),
		[&File](const std::pair<std::string, std::string>& Each) { return Each.first == File; });
	const std::string Real = bGenerated ? std::string() : FindShaderFile(File);
	const std::string Root = FindShippedShaders();
	return Real.starts_with(Root + "/rdg/graph/Shaders/") || Real.starts_with(Root + "/passes/Shaders/");
}

namespace
{

/** The row of a name, or of the file of that virtual path; null: the table has none. */
const FEngineName* FindRow(const std::string& Name)
{
	static const std::map<std::string, const FEngineName*> Rows = []
	{
		std::map<std::string, const FEngineName*> Result;
		for (const FEngineName& Row : GetEngineNames())
		{
			Result.emplace(Row.IsFile() ? ToLowerCase(Row.File) : Row.Name, &Row);
		}
		return Result;
	}();
	const auto Found = Rows.find(Name.starts_with("/") ? ToLowerCase(Name) : Name); // paths in any case
	return Found == Rows.end() ? nullptr : Found->second;
}

std::string Describe(const std::string& Name, const std::string& Where)
{
	const FEngineName* const Row = FindRow(Name);
	return Name + Where +
		   (!Row                             ? ""
			   : Row->Certainty == "article" ? " (an article adds it)"
			   : Row->Deprecated == "-"      ? ""
											 : " (the engine has " + Row->Deprecated + ")");
}

bool IsEngines(const std::string& Name)
{
	const FEngineName* const Row = FindRow(Name);
	return Row && Row->IsEngines();
}

int GLintEngine = 0;

/** "from 5.4 on" and the like, where the version that is asked for does not have the name; else empty. */
std::string DescribeVersion(const FEngineName& Row)
{
	// "-": none. Engine 4 is before all.
	const auto Get = [](const std::string& Version)
	{
		return Version.starts_with("5.") ? std::stoi(Version.substr(2)) : 0;
	};
	const std::string Sure = Row.Certainty == "uncertain" ? ", uncertain" : "";
	if (Get(Row.From) > GLintEngine || (Row.Until != "-" && Get(Row.Until) < GLintEngine))
	{
		return " (engine 5." + std::to_string(GLintEngine) + " does not have it: " +
			   (Get(Row.From) > GLintEngine ? "from " + Row.From + " on" : "until " + Row.Until) + Sure + ")";
	}
	return "";
}

/** The names of a file that the version does not have. */
void FindOtherVersions(const std::string& File, const std::vector<std::string>& Lines, std::vector<FNotInEngine>& Found)
{
	static const std::regex Word("[A-Za-z_][A-Za-z0-9_]*");
	for (size_t Index = 0; Index < Lines.size() && GLintEngine != 0; ++Index)
	{
		const std::string Code = Lines[Index].substr(0, Lines[Index].find("//"));
		for (std::sregex_iterator It(Code.begin(), Code.end(), Word), End; It != End; ++It)
		{
			const FEngineName* const Row = FindRow(It->str());
			const std::string Why = Row && Row->IsEngines() ? DescribeVersion(*Row) : "";
			if (!Why.empty())
			{
				Found.push_back({File, int(Index) + 1, Row->Name + Why});
			}
		}
	}
}

} // namespace

void SetLintEngine(int Minor)
{
	GLintEngine = Minor;
}

std::vector<FNotInEngine> FindNotInEngine(const FHlslText& Text, const FShaderCompileRequest& Request)
{
	std::vector<FNotInEngine> Found;
	std::map<std::string, std::vector<std::string>> Theirs; // the files that drydock does not ship, as lines
	std::vector<std::string> Files = Text.Files;
	Files.push_back(Request.VirtualPath);
	for (const std::string& File : Files)
	{
		if (!Theirs.contains(File) && !IsShipped(File, Request))
		{
			Theirs.emplace(File, SplitText(ReadShaderText(File, Request)));
		}
	}

	static const std::regex Include(R"re(^\s*#\s*include\s*"([^"]+)")re");
	for (const auto& [File, Lines] : Theirs)
	{
		FindOtherVersions(File, Lines, Found);
		std::smatch Match;
		for (size_t i = 0; i < Lines.size(); ++i)
		{
			if (std::regex_search(Lines[i], Match, Include))
			{
				std::string Path = ResolveVirtualPath(Match[1], File);
				if (FindShaderFile(Path).empty())
				{
					Path = ResolveVirtualPath("/Engine/Private/" + Match[1].str(), File); // as the engine looks for it
				}
				if (IsShipped(Path, Request) && !IsEngines(Path))
				{
					Found.push_back({File, int(i) + 1, Describe(Path, "")});
				}
			}
		}
	}

	std::map<std::string, std::string> Ours; // name, file
	std::set<std::string> TheirNames;
	for (const size_t At : ListDefinitions(Text))
	{
		const std::string& File = Text.Files[Text[At].File];
		if (Theirs.contains(File))
		{
			TheirNames.insert(Text[At].Text);
		}
		else if (!IsEngines(Text[At].Text))
		{
			Ours.emplace(Text[At].Text, File);
		}
	}
	for (size_t At = 1; At < Text.Size(); ++At)
	{
		const std::string& Word = Text[At].Text;
		const auto Name = Ours.find(Word);
		const auto File = Name == Ours.end() ? Theirs.end() : Theirs.find(Text.Files[Text[At].File]);
		const size_t Line = size_t(Text[At].Line) - 1;
		// A macro of the engine's name may stand for a name of ours: only what the author wrote counts.
		const bool bWritten =
			File != Theirs.end() && Line < File->second.size() && File->second[Line].find(Word) != std::string::npos;
		if (bWritten && !TheirNames.contains(Word) && !Text.Is(At - 1, "."))
		{
			Found.push_back({File->first, int(Line) + 1, Describe(Word, " of " + Name->second)});
		}
	}
	return Found;
}

} // namespace Drydock
