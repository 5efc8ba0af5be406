// Loads shared objects once and starts their modules.
#include "Extensions/Plugins.h"

#include "Async/Async.h"
#include "Config/ConfigReader.h"
#include "AddedSettingFields.h"
#include "CodeScope.h"
#include "ExtensionFactory.h"
#include "Engine/World.h"
#include "Extensions/ExtensionErrors.h"
#include "GlobalShader.h"
#include "Modules/ModuleManager.h"
#include "PassFactory.h"
#include "PassFunctions.h"
#include "PostProcessSettingsReflection.h"
#include "RegularFile.h"
#include "ShaderDirectories.h"
#include "Text/TextFile.h"
#include "TextTools.h"
#include "TimerManager.h"

#include <DrydockHeadersMark.h>
#include <dlfcn.h>
#include <filesystem>
#include <link.h>
#include <map>

/** Plugins that were built with these headers need it. */
extern "C"
{
	extern DRYDOCK_API const char DRYDOCK_HEADERS_MARK;
	const char DRYDOCK_HEADERS_MARK = 0;
}

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

struct FLoadedPlugin
{
	void* Handle = nullptr;
	Files::file_time_type Time;
};

/** By canonical path. Never destroyed: the loader unloads at the end, each library before those it needs. */
std::map<std::string, FLoadedPlugin>& GetLoaded()
{
	static auto* const Loaded = new std::map<std::string, FLoadedPlugin>;
	return *Loaded;
}

/** How much is registered: what a plugin adds to. */
size_t CountRegistered()
{
	size_t NumShaders = 0;
	ForEachGlobalShader([&](const FGlobalShaderType&) { ++NumShaders; });
	return NumShaders + CountPassReplacements() + GetExtensionFactories().size() + GetPassFactories().size() +
		   GetSettingFields().size();
}

std::string GetFileName(const std::string& Path)
{
	return Files::path(Path).filename().string();
}

/** Whether the library is gone: one with unique symbols stays in memory until the end. */
bool Unload(const std::string& Path, FLoadedPlugin& Plugin)
{
	// Its extensions' weak references are its own code: they go first.
	const FCodeOwner Owner = {GetFileName(Path), "destructors of static variables (dlclose)"};
	CallCode(Owner,
		[&]
		{
			GEngine->ViewExtensions->ForgetPlugin(Path);
			GWorld->GetTimerManager().ClearAllTimersOf(Owner.Plugin);
			ForgetTasksOf(Owner.Plugin);
			dlclose(Plugin.Handle);
		});
	ForgetPluginCode(Owner.Plugin);
	if (void* const Still = dlopen(Path.c_str(), RTLD_NOW | RTLD_NOLOAD))
	{
		dlclose(Still);
		return false;
	}
	return true;
}

/** Notes folders of shaders that the engine would not find: drydock alone mapped them, since the first Before ones. */
void NoteUnmapped(const FConfigPlace& Place, size_t Before, FConfigMessages& Messages)
{
	const std::vector<FShaderDirectory> All = GetShaderDirectories();
	for (size_t Index = Before; Index < All.size(); ++Index)
	{
		const std::string& Virtual = All[Index].Virtual;
		const bool bMapped = !All[Index].bByDrydock || std::ranges::any_of(All, [&](const FShaderDirectory& Other)
														   { return !Other.bByDrydock && Other.Virtual == Virtual; });
		std::string Used;
		ForEachGlobalShader(
			[&](const FGlobalShaderType& Type)
			{
				const std::string File = Type.GetShaderFilename();
				Used = File.starts_with(Virtual + "/") ? File : Used;
			});
		if (!bMapped && !Used.empty())
		{
			Messages.Note(NotePluginUnmapped, Place,
				"the plugin does not map " + Virtual + ", and the engine will not find " + Used +
					": call AddShaderSourceDirectoryMapping(TEXT(\"" + Virtual +
					"\"), ...) in its module's StartupModule; drydock maps it to " + All[Index].Real);
		}
	}
}

/** Warns of what `drydock build` has noted beside the library. */
void WarnOfNames(const TConfigValue<std::string>& Plugin, const std::string& Path, FConfigMessages& Messages)
{
	const std::string File = GetVersionNotesFile(Path);
	std::error_code None; // no file: nothing is noted
	const Files::file_time_type Noted = Files::last_write_time(File, None);
	if (!None && Noted >= Files::last_write_time(Path, None))
	{
		const std::vector<std::string> Lines = SplitText(TryReadTextFile(File).value_or(""));
		for (const std::string& Line : Lines)
		{
			Messages.Warn(WarnPluginNames, Plugin.Place,
				Line + "; nobody named a version, so nothing is refused (drydock build --engine-minor names one)");
		}
	}
}

/** Whether it is loaded; else that is reported. */
bool Load(
	const TConfigValue<std::string>& Plugin, const std::string& Path, FObjectValues& Values, FConfigMessages& Messages)
{
	const std::string Name = GetFileName(Path);
	std::error_code Gone; // it was there a moment ago: dlopen reports what is wrong with it
	const Files::file_time_type Time = Files::last_write_time(Path, Gone);
	const auto Known = GetLoaded().find(Path);
	if (Known != GetLoaded().end())
	{
		if (Known->second.Time == Time)
		{
			Values.GiveTo(Name);
			return true;
		}
		FLoadedPlugin Old = Known->second;
		GetLoaded().erase(Known);
		if (!Unload(Path, Old))
		{
			Messages.Warn(WarnPluginNotReloaded, Plugin.Place,
				Path +
					" has changed, and the old one cannot be unloaded: build it with -fno-gnu-unique, or start anew");
		}
	}
	const size_t NumBefore = CountRegistered();
	const size_t NumMapped = CountShaderDirectories();
	const uint64 FirstExtension = GEngine->ViewExtensions->GetNextRegistration();
	// Local: plugins see drydock's symbols and not each other's, which may bear the same names.
	void* const Handle = CallCode(FCodeOwner{Name, "constructors of static variables (dlopen)"},
		[&] { return dlopen(Path.c_str(), RTLD_NOW | RTLD_LOCAL); });
	for (const FDiagnostic& Problem : TakeSettingProblems())
	{
		Messages.Error(Problem.Code, Plugin.Place, Problem.Message);
	}
	if (Handle == nullptr)
	{
		const char* const Given = dlerror();
		const std::string Reason = Given != nullptr ? Given : "unknown reason";
		const bool bOtherHeaders = Reason.find("undefined symbol: DrydockHeaders_") != std::string::npos;
		Messages.Error(ErrorPluginNotLoaded, Plugin.Place,
			bOtherHeaders ? "the plugin was built with the headers of another drydock: build it again (drydock build)"
						  : "the plugin cannot be loaded: " + Reason);
		return false;
	}
	GetLoaded()[Path] = {Handle, Time};
	link_map* Map = nullptr;
	if (dlinfo(Handle, RTLD_DI_LINKMAP, &Map) == 0)
	{
		NotePluginCode(Name, Map->l_ld);
	}
	Values.GiveTo(Name);
	CallCode(FCodeOwner{Name, "the start of its modules"}, [] { FModuleManager::Get().StartupPendingModules(); });
	NoteUnmapped(Plugin.Place, NumMapped, Messages);
	const int32 NumExtensions = GEngine->ViewExtensions->MarkPlugin(Path, FirstExtension);
	const bool bOverlay = Plugin.Place.Pointer == "/overlay"; // which ReportOverlays looks at
	if (NumExtensions == 0 && CountRegistered() == NumBefore && !bOverlay)
	{
		Messages.Warn(WarnPluginEmpty, Plugin.Place,
			"the plugin registered no extension, pass or shader: an extension must be made by "
			"FSceneViewExtensions::NewExtension and held, in a static variable or by the module");
	}
	return true;
}

} // namespace

FLoadedPlugins LoadPlugins(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	FObjectValues Values(Config, Diagnostics);
	FLoadedPlugins Loaded;
	for (const TConfigValue<std::string>& Plugin : Config.Plugins)
	{
		const std::string Given = Config.Resolve(Plugin.Value);
		std::error_code Missing;
		const std::string Path = Files::canonical(Given, Missing).string();
		if (Missing == std::errc::no_such_file_or_directory)
		{
			Messages.Error(
				ErrorFileMissing, Plugin.Place, "the plugin " + Given + " does not exist" + DescribeWindowsPath(Given));
		}
		else if (const std::string Problem = Missing ? Missing.message() : FRegularFile(Path).GetProblem();
				 !Problem.empty())
		{
			Messages.Error(ErrorFileMissing, Plugin.Place, "the plugin " + Given + " cannot be read: " + Problem);
		}
		else if (Load(Plugin, Path, Values, Messages))
		{
			WarnOfNames(Plugin, Path, Messages);
			Values.PlaceActors(GetFileName(Path));
			Loaded.Files.push_back(Path);
		}
	}
	Values.ReportUnknownClasses(Loaded.Files.size() == Config.Plugins.size());
	Loaded.IniVariables = Values.GetVariables();
	return Loaded;
}

std::string GetVersionNotesFile(const std::string& Library)
{
	return Library + ".names";
}

std::vector<std::string> FindPluginIniFiles(const std::string& Plugin)
{
	std::error_code Missing;
	return FindIniFiles(GetFileName(Files::canonical(Plugin, Missing).string()));
}

void RefusePlugins(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	for (const TConfigValue<std::string>& Plugin : Config.Plugins)
	{
		Messages.Error(
			ErrorPluginRefused, Plugin.Place, "the plugin " + Plugin.Value + " is not loaded: --no-plugins was given");
	}
}

} // namespace Drydock
