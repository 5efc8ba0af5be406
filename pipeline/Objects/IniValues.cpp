// Gives a plugin's classes, and console variables, the values of its ini files.
#include "Objects/IniValues.h"

#include "HAL/ConsoleVariableTools.h"
#include "Interfaces/IPluginManager.h"
#include "Objects/IniText.h"
#include "Objects/ObjectErrors.h"
#include "Objects/PropertyText.h"
#include "RangeTools.h"
#include "RegularFile.h"
#include "UObject/Reflection.h"

#include <algorithm>
#include <filesystem>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** Names of a plugin that its classes may stand under, and its folders. */
struct FPluginFolders
{
	std::vector<std::string> Names;
	std::vector<std::string> Folders;
};

FPluginFolders FindPluginFolders(const std::string& Library)
{
	FPluginFolders Found;
	for (const TSharedRef<IPlugin>& Plugin : IPluginManager::Get().GetEnabledPlugins())
	{
		if (*Plugin->GetLibrary() == Library)
		{
			Found.Names.emplace_back(*Plugin->GetName());
			const std::string Folder = *Plugin->GetBaseDir();
			AddUnique(Found.Folders, Folder);
		}
	}
	return Found;
}

/** Finds "Game" for UCLASS(config=Game). Derived classes inherit the name and may name another. */
std::string FindConfigName(const FReflectedStruct& Class)
{
	const FReflectedStruct* Each = &Class;
	while (Each != nullptr && (Each->Config[0] == '\0' || IsSameName(Each->Config, "inherit")))
	{
		Each = Each->Super != nullptr ? FReflection::Get().FindStruct(*Each->Super) : nullptr;
	}
	return Each != nullptr ? Each->Config : "";
}

/** A console variable's value as ini files have it: the engine's editor writes True and False. Source: engine
 * ConvertValueFromHumanFriendlyValue (public copies). */
std::string ReadHumanValue(const std::string& Text)
{
	const auto Is = [&](const char* Word)
	{
		return IsSameName(Text, Word);
	};
	return Is("True") || Is("Yes") || Is("On") ? "1" : Is("False") || Is("No") || Is("Off") ? "0" : Text;
}

/** Gives the classes of one plugin what one ini file says. */
class FIniGiver
{
public:
	FIniGiver(const std::string& Library, const std::string& InFile, std::vector<FDiagnostic>& InDiagnostics)
		: File(InFile)
		, Diagnostics(InDiagnostics)
		, Classes(FReflection::Get().FindClasses(Library))
		, ModuleNames(FindPluginFolders(Library).Names)
		, Category(Files::path(InFile).stem().string().substr(std::string("Default").size()))
	{
		for (const FReflectedStruct* const Class : Classes)
		{
			ModuleNames.emplace_back(Class->Module);
		}
	}

	void Give(const FIniSection& Section, std::vector<FIniVariable>& OutVariables)
	{
		const bool bProject = IsSameName(Section.Name, "/Script/Engine.RendererSettings");
		if (bProject || IsSameName(Section.Name, "SystemSettings") || IsSameName(Section.Name, "ConsoleVariables"))
		{
			ReadVariables(Section, bProject ? ECVF_SetByProjectSetting : ECVF_SetBySystemSettingsIni, OutVariables);
			return;
		}
		const size_t Dot = Section.Name.rfind('.');
		if (strncasecmp(Section.Name.c_str(), "/Script/", 8) != 0 || Dot == std::string::npos)
		{
			return; // of code that reads it by itself
		}
		const std::string Module = Section.Name.substr(8, Dot - 8);
		if (std::ranges::none_of(ModuleNames, [&](const std::string& Name) { return IsSameName(Name, Module); }))
		{
			return; // of another plugin or the engine
		}
		const auto Class = std::ranges::find_if(
			Classes, [&](const FReflectedStruct* Each) { return IsNameOf(Section.Name.substr(Dot + 1), *Each); });
		if (Class == Classes.end())
		{
			std::vector<std::string> Names;
			std::ranges::transform(
				Classes, std::back_inserter(Names), [](const FReflectedStruct* Each) { return Each->Name + 1; });
			Warn(GetLine(Section), "the plugin has no class " + Section.Name.substr(Dot + 1) +
									   Suggest(Section.Name.substr(Dot + 1), Names));
			return;
		}
		GiveClass(Section, **Class);
	}

private:
	static int GetLine(const FIniSection& Section)
	{
		for (const FIniKey& Key : Section.Keys)
		{
			if (!Key.Values.empty())
			{
				return Key.Values[0].Line;
			}
		}
		return 0;
	}

	void Warn(int Line, const std::string& Message)
	{
		AddDiagnostic(Diagnostics,
			{.Severity = ESeverity::Warning, .Code = WarnIniValue, .Message = Message, .File = File, .Line = Line});
	}

	void ReadVariables(
		const FIniSection& Section, EConsoleVariableFlags SetBy, std::vector<FIniVariable>& OutVariables) const
	{
		if (!IsSameName(Category, "Engine"))
		{
			return; // the engine asks its own ini alone
		}
		for (const FIniKey& Key : Section.Keys)
		{
			for (const FIniValue& Value : Key.Values)
			{
				OutVariables.push_back({Key.Name, ReadHumanValue(Value.Text), SetBy, File, Value.Line});
			}
		}
	}

	void GiveClass(const FIniSection& Section, const FReflectedStruct& Class)
	{
		const std::string Wanted = FindConfigName(Class);
		if (!IsSameName(Wanted, Category))
		{
			Warn(GetLine(Section),
				Wanted.empty()
					? std::string(Class.Name) + " is not a UCLASS(config=" + Category + "), so its values are not read"
					: std::string(Class.Name) + " is a UCLASS(config=" + Wanted +
						  "), whose values are read from Default" + Wanted + ".ini alone");
			return;
		}
		for (const FIniKey& Key : Section.Keys)
		{
			GiveKey(Key, Class);
		}
	}

	void GiveKey(const FIniKey& Key, const FReflectedStruct& Class)
	{
		const int Line = Key.Values.empty() ? 0 : Key.Values[0].Line;
		const std::string FullName = std::string(Class.Name) + "::" + Key.Name;
		const FFoundProperty Found = FReflection::Get().FindProperty(Class, Key.Name, true);
		if (Found.Property == nullptr)
		{
			Warn(Line, std::string(Class.Name) + " has no UPROPERTY " + Key.Name +
						   Suggest(Key.Name, FReflection::Get().GetPropertyNames(Class)));
			return;
		}
		if (!Found.Property->bConfig)
		{
			Warn(Line, FullName + " is not a UPROPERTY(config), so it keeps its value");
			return;
		}
		const std::optional<FPropertyValue> Value = ReadPropertyText(*Found.Property->Type, Key.Values);
		FPropertyProblem Problem;
		if (!Value)
		{
			Warn(Line, FullName + ": expected " + DescribeExpected(*Found.Property->Type) + ", found " +
						   (Key.Values.empty() ? "nothing" : Key.Values[0].Text));
		}
		else if (!FReflection::Get().Give(Class, Found.Property->Name, *Value, Problem))
		{
			Warn(Line, Problem.Message + (Problem.Path.empty() ? "" : " (at " + FullName + Problem.Path + ")"));
		}
	}

	const std::string& File;
	std::vector<FDiagnostic>& Diagnostics;
	std::vector<const FReflectedStruct*> Classes;
	std::vector<std::string> ModuleNames;
	std::string Category; // "Game" of DefaultGame.ini
};

} // namespace

bool IsNameOf(const std::string& Name, const FReflectedStruct& Class)
{
	return IsSameName(Name, Class.Name) || IsSameName(Name, Class.Name + 1);
}

std::vector<std::string> FindIniFiles(const std::string& Library)
{
	std::vector<std::string> Paths;
	for (const std::string& Folder : FindPluginFolders(Library).Folders)
	{
		std::error_code None; // no folder: no files
		const size_t NumBefore = Paths.size();
		for (const Files::directory_entry& Entry : Files::directory_iterator(Files::path(Folder) / "Config", None))
		{
			const std::string Name = Entry.path().filename().string();
			if (Name.starts_with("Default") && Name.ends_with(".ini"))
			{
				Paths.push_back(Entry.path().string());
			}
		}
		std::sort(Paths.begin() + std::ptrdiff_t(NumBefore), Paths.end());
	}
	return Paths;
}

void GiveIniFile(const std::string& Library, const std::string& Path, std::vector<FIniVariable>& OutVariables,
	std::vector<FDiagnostic>& Diagnostics)
{
	const FFileBytes Read = ReadRegularFile(Path);
	const bool bWide = Read.Bytes && (Read.Bytes->starts_with("\xFF\xFE") || Read.Bytes->starts_with("\xFE\xFF") ||
										 Read.Bytes->find('\0') != std::string::npos);
	if (!Read.Bytes || bWide)
	{
		AddDiagnostic(
			Diagnostics, {.Severity = ESeverity::Warning,
							 .Code = WarnIniFile,
							 .Message = Read.bTooLarge ? "the ini file has more than 16 MB; it is left out"
										: bWide ? "the ini file is not UTF-8 (UTF-16, or no text); it is left out"
												: "the ini file cannot be read: " + Read.Problem,
							 .File = Path});
		return;
	}
	FIniGiver Giver(Library, Path, Diagnostics);
	for (const FIniSection& Section : ReadIniText(*Read.Bytes, Path, Diagnostics))
	{
		Giver.Give(Section, OutVariables);
	}
}

void ApplyIniVariables(const std::vector<FIniVariable>& Variables, std::vector<FDiagnostic>& Diagnostics)
{
	for (const FIniVariable& Variable : Variables)
	{
		FDiagnostic Message = {
			.Severity = ESeverity::Warning, .Code = WarnIniValue, .File = Variable.File, .Line = Variable.Line};
		IConsoleVariable* const Found = IConsoleManager::Get().FindConsoleVariable(Variable.Name.c_str());
		if (Found == nullptr)
		{
			Message.Severity = ESeverity::Note;
			Message.Code = NoteIniVariable;
			Message.Message = "there is no console variable " + Variable.Name + " here; it is left out";
		}
		else if (!DoesConsoleVariableTake(*Found, Variable.Value.c_str()))
		{
			Message.Message = Variable.Name + " cannot be \"" + Variable.Value + "\"; it keeps its value";
		}
		else if (DescribeRefusedSet(Variable.Name.c_str(), *Found, Variable.SetBy).IsEmpty())
		{
			Found->Set(Variable.Value.c_str(), Variable.SetBy);
			continue;
		}
		else
		{
			continue; // who set it before comes later in the engine's order
		}
		AddDiagnostic(Diagnostics, Message);
	}
}

} // namespace Drydock
