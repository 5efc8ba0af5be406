// Collects the names that are taken, and explains why a name cannot be a patch's.
#include "Patch/PatchName.h"

#include "GlobalShader.h"
#include "InstallPaths.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr size_t LongestName = 64;

/** C++20's, with the alternative spellings of operators. */
constexpr std::array Keywords = {"alignas", "alignof", "and", "and_eq", "asm", "auto", "bitand", "bitor", "bool",
	"break", "case", "catch", "char", "char16_t", "char32_t", "char8_t", "class", "co_await", "co_return", "co_yield",
	"compl", "concept", "const", "const_cast", "consteval", "constexpr", "constinit", "continue", "decltype", "default",
	"delete", "do", "double", "dynamic_cast", "else", "enum", "explicit", "export", "extern", "false", "float", "for",
	"friend", "goto", "if", "inline", "int", "long", "mutable", "namespace", "new", "noexcept", "not", "not_eq",
	"nullptr", "operator", "or", "or_eq", "private", "protected", "public", "register", "reinterpret_cast", "requires",
	"return", "short", "signed", "sizeof", "static", "static_assert", "static_cast", "struct", "switch", "template",
	"this", "thread_local", "throw", "true", "try", "typedef", "typeid", "typename", "union", "unsigned", "using",
	"virtual", "void", "volatile", "wchar_t", "while", "xor", "xor_eq"};

/** Modules of the engine that a patch is likely to be named after. */
constexpr std::array EngineModules = {"AnimGraphRuntime", "AppFramework", "ApplicationCore", "AssetRegistry",
	"AudioMixer", "AugmentedReality", "Chaos", "CinematicCamera", "Composure", "Core", "CoreUObject",
	"DeveloperSettings", "Engine", "EngineSettings", "EnhancedInput", "Foliage", "HeadMountedDisplay", "ImageCore",
	"ImageWrapper", "InputCore", "Json", "Landscape", "Launch", "LevelSequence", "MaterialShaderQualitySettings",
	"Media", "MediaAssets", "MovieScene", "NavigationSystem", "Niagara", "OpenColorIO", "Paper2D", "PhysicsCore",
	"Projects", "RHI", "RHICore", "RenderCore", "Renderer", "Slate", "SlateCore", "SlateRHIRenderer", "Sockets", "UMG",
	"UnrealEd", "VectorVM", "VulkanRHI", "D3D12RHI", "MetalRHI"};

/** Targets that CMake makes itself, or that a patch's CMakeLists.txt has beside its own. */
constexpr std::array BuildTargets = {"all", "clean", "depend", "drydock", "edit_cache", "help", "install", "package",
	"package_source", "preinstall", "rebuild_cache", "test"};

bool IsNameStart(char Letter)
{
	return std::isalpha(static_cast<unsigned char>(Letter)) != 0;
}

bool IsNamePart(char Letter)
{
	return IsNameStart(Letter) || std::isdigit(static_cast<unsigned char>(Letter)) != 0 || Letter == '_';
}

template<typename TList>
bool Holds(const TList& List, const std::string& Name)
{
	return std::find(std::begin(List), std::end(List), Name) != std::end(List);
}

/** The identifier at the start of Text, after white space; Text loses both. */
std::string TakeName(std::string& Text)
{
	const auto Begin =
		std::find_if(Text.begin(), Text.end(), [](char Letter) { return Letter != ' ' && Letter != '\t'; });
	const auto End = std::find_if_not(Begin, Text.end(), IsNamePart);
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
	if (!Holds(std::array{"class", "struct", "enum", "union", "using"}, First))
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
	if (Name.empty() || !IsNameStart(Name.front()) || !std::all_of(Name.begin(), Name.end(), IsNamePart))
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
	if (Holds(Keywords, Name))
	{
		return "it is a keyword of C++";
	}
	if (Holds(EngineModules, Name))
	{
		return "the engine has a module of that name";
	}
	if (Holds(BuildTargets, Name))
	{
		return "CMake has a target of that name";
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
	std::copy_if(Name.begin(), Name.end(), std::back_inserter(Clean), IsNamePart);
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
