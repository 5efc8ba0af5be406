// Collects the names that are taken, and explains why a name cannot be a patch's.
#include "Patch/PatchName.h"

#include "GlobalShader.h"
#include "InstallPaths.h"
#include "RangeTools.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <iterator>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr size_t LongestName = 64;

constexpr const char* NamesText =
#include "PatchNames.txt"
	;

bool IsNameStart(char Letter)
{
	return std::isalpha(static_cast<unsigned char>(Letter)) != 0;
}

/** The identifier at the start of Text, after white space; Text loses both. */
std::string TakeName(std::string& Text)
{
	const auto Begin =
		std::find_if(Text.begin(), Text.end(), [](char Letter) { return Letter != ' ' && Letter != '\t'; });
	const auto End = std::find_if_not(Begin, Text.end(), IsWordCharacter);
	const std::string Name(Begin, End);
	Text.erase(Text.begin(), End);
	return Name;
}

bool IsApiMacro(const std::string& Name)
{
	return Name.size() > 4 && Name.compare(Name.size() - 4, 4, "_API") == 0;
}

/** The name that one line declares, or nothing. */
std::string FindDeclaredName(std::string Line)
{
	if (Line.starts_with("#define"))
	{
		Line.erase(0, 7);
		return TakeName(Line);
	}
	const std::string First =
		std::isspace(static_cast<unsigned char>(Line.empty() ? ' ' : Line[0])) != 0 ? "" : TakeName(Line);
	if (First.starts_with("BEGIN_") && First.find("_STRUCT") != std::string::npos && Line.starts_with('('))
	{
		Line.erase(0, 1);
		return TakeName(Line);
	}
	if (!Contains(std::array{"class", "struct", "enum", "union", "using"}, First))
	{
		return {};
	}
	std::string Name = TakeName(Line);
	while (Name == "class" || Name == "struct" || IsApiMacro(Name))
	{
		Name = TakeName(Line);
	}
	const bool bAlias = First == "using";
	return bAlias && !Line.starts_with(" =") ? std::string() : Name;
}

/** The folders of the headers that use the engine's names. */
std::vector<Files::path> FindHeaderFolders()
{
	const std::string Installed = FindInstalled("include/drydock");
	const Files::path Root = Installed.empty() ? Files::path(DRYDOCK_SOURCE_DIR) : Files::path(Installed);
	return {Root / "rdg", Root / "settings", Root / "passes"};
}

/** Every name that a patch's files give to something. */
std::vector<std::string> GetNamesOfPatch(const std::string& Name)
{
	return {Name, "F" + Name, "F" + Name + "PS", "F" + Name + "Module", "F" + Name + "ViewExtension",
		Name + "ViewExtension"};
}

} // namespace

std::set<std::string> FindDeclaredNames(const std::string& Text)
{
	std::set<std::string> Names;
	for (const std::string& Line : SplitText(Text))
	{
		Names.insert(FindDeclaredName(Line));
	}
	Names.erase("");
	return Names;
}

std::set<std::string> FindTakenNames()
{
	std::set<std::string> Taken;
	for (const Files::path& Folder : FindHeaderFolders())
	{
		std::error_code Error;
		for (Files::recursive_directory_iterator Entry(Folder, Error), End; !Error && Entry != End;
			 Entry.increment(Error))
		{
			if (Entry->path().extension() == ".h")
			{
				Taken.merge(FindDeclaredNames(TryReadTextFile(Entry->path()).value_or("")));
				Taken.insert(Entry->path().stem().string());
			}
		}
	}
	ForEachGlobalShader([&](const FGlobalShaderType& Type) { Taken.insert(Type.GetName()); });
	return Taken;
}

std::string ExplainBadPatchName(const std::string& Name, const std::set<std::string>& Taken)
{
	if (Name.empty() || !IsNameStart(Name.front()) || !std::all_of(Name.begin(), Name.end(), IsWordCharacter))
	{
		return "C++ classes have this name, so it must begin with a letter and consist of letters, digits and _";
	}
	if (Name.find("__") != std::string::npos)
	{
		return "C++ reserves names with __";
	}
	if (Name.size() > LongestName)
	{
		return "it has more than " + std::to_string(LongestName) + " letters";
	}
	for (const std::vector<std::string>& Columns : SplitRows(NamesText))
	{
		if (Contains(SplitText(Columns[1], ' '), Name))
		{
			return Columns[0];
		}
	}
	for (const std::string& Own : GetNamesOfPatch(Name))
	{
		if (Taken.count(Own) != 0)
		{
			return Own + " is a name of the engine's";
		}
	}
	return {};
}

std::string SuggestPatchName(const std::string& Name, const std::set<std::string>& Taken)
{
	std::string Clean;
	std::copy_if(Name.begin(), Name.end(), std::back_inserter(Clean), IsWordCharacter);
	Clean.erase(Clean.begin(), std::find_if(Clean.begin(), Clean.end(), IsNameStart));
	if (Clean.empty())
	{
		return {};
	}
	const bool bHasPrefix =
		Clean.size() > 1 && Clean[0] == 'F' && std::isupper(static_cast<unsigned char>(Clean[1])) != 0;
	for (const std::string& Near : {Clean, "My" + (bHasPrefix ? Clean.substr(1) : Clean)})
	{
		std::string Capital = Near;
		Capital[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(Capital[0])));
		if (Capital != Name && ExplainBadPatchName(Capital, Taken).empty())
		{
			return Capital;
		}
	}
	return {};
}

} // namespace Drydock
