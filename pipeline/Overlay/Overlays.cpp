// Orders overlays, finds clashes, builds, and switches them on.
#include "Overlay/Overlays.h"

#include "CodeScope.h"
#include "Config/ConfigReader.h"
#include "ContentHash.h"
#include "Overlay/OverlayErrors.h"
#include "Overlay/OverlayShaders.h"
#include "Overlay/OverlaySource.h"
#include "Patch/PluginBuild.h"
#include "PrintText.h"
#include "RangeTools.h"
#include "ShaderDirectories.h"
#include "Text/FolderLock.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <dlfcn.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** The folder that a name means, in one spelling. */
std::string GetPlace(const FConfig& Config, const std::string& Folder)
{
	return (Files::absolute(Config.Resolve(Folder)) / ".").lexically_normal().string();
}

/** The overlay of that folder; the number of overlays: there is none. */
size_t FindOverlay(const FConfig& Config, const std::string& Folder)
{
	const auto Found = std::find_if(Config.Overlays.begin(), Config.Overlays.end(),
		[&](const FConfigOverlay& Overlay)
		{ return GetPlace(Config, Overlay.Folder.Value) == GetPlace(Config, Folder); });
	return static_cast<size_t>(Found - Config.Overlays.begin());
}

/** Reports overlays without a name, named twice, or over one that is not there. */
void CheckNames(const FConfig& Config, FConfigMessages& Messages)
{
	const std::vector<FConfigOverlay>& Overlays = Config.Overlays;
	const std::vector<std::string> Names =
		ToVector<std::string>(Overlays, [](const FConfigOverlay& Overlay) { return Overlay.Folder.Value; });
	for (size_t Index = 0; Index < Overlays.size(); ++Index)
	{
		const TConfigValue<std::string>& Folder = Overlays[Index].Folder;
		if (Folder.Value.empty())
		{
			Messages.Error(ErrorOverlayFolder, Folder.Place, "an overlay needs the name of its folder");
		}
		else if (FindOverlay(Config, Folder.Value) != Index)
		{
			Messages.Error(ErrorOverlaysClash, Folder.Place, "the overlay " + Folder.Value + " is named twice");
		}
		for (const std::string& Below : Overlays[Index].Over)
		{
			if (FindOverlay(Config, Below) == Overlays.size())
			{
				Messages.Error(ErrorOverlaysClash, Folder.Place,
					"there is no overlay \"" + Below + "\" that " + Folder.Value + " could stand over" +
						Messages.Suggest(Below, Names));
			}
		}
	}
}

/** Moves each overlay behind those that it stands over. A circle is reported. */
std::vector<size_t> OrderOverlays(const FConfig& Config, FConfigMessages& Messages)
{
	const std::vector<FConfigOverlay>& Overlays = Config.Overlays;
	std::vector<size_t> Ordered;
	std::vector<bool> Taken(Overlays.size(), false);
	const auto IsFree = [&](size_t Index)
	{
		return std::all_of(Overlays[Index].Over.begin(), Overlays[Index].Over.end(),
			[&](const std::string& Below)
			{
				const size_t Found = FindOverlay(Config, Below);
				return Found == Overlays.size() || Taken[Found];
			});
	};
	while (Ordered.size() < Overlays.size())
	{
		size_t Next = Overlays.size();
		for (size_t Index = 0; Index < Overlays.size() && Next == Overlays.size(); ++Index)
		{
			Next = !Taken[Index] && IsFree(Index) ? Index : Next;
		}
		if (Next == Overlays.size())
		{
			Next = static_cast<size_t>(std::find(Taken.begin(), Taken.end(), false) - Taken.begin());
			Messages.Error(ErrorOverlaysClash, Overlays[Next].Folder.Place,
				"the overlay " + Overlays[Next].Folder.Value + " and " + Overlays[Next].Over.front() +
					" stand over each other; expected one of them below");
		}
		Taken[Next] = true;
		Ordered.push_back(Next);
	}
	return Ordered;
}

/** Names what two overlays fill, where neither says that it stands over the other. */
void CheckClashes(const FConfig& Config, const std::vector<FConfigOverlay>& Overlays,
	const std::vector<FOverlayFolder>& Folders, FConfigMessages& Messages)
{
	std::map<std::string, size_t> Filled;
	for (size_t Index = 0; Index < Folders.size(); ++Index)
	{
		for (const std::string& Name : Folders[Index].ListReplaced())
		{
			const auto [Known, bNew] = Filled.try_emplace(Name, Index);
			const std::vector<std::string>& Over = Overlays[Index].Over;
			const std::string& Below = Overlays[Known->second].Folder.Value;
			const bool bOver = std::any_of(Over.begin(), Over.end(),
				[&](const std::string& Each) { return GetPlace(Config, Each) == GetPlace(Config, Below); });
			if (!bNew && !bOver)
			{
				Messages.Error(ErrorOverlaysClash, Overlays[Index].Folder.Place,
					"the overlays " + Folders[Known->second].Name + " and " + Folders[Index].Name + " both replace " +
						Name + R"(; one must stand over the other: {"folder": ")" + Overlays[Index].Folder.Value +
						R"(", "over": ")" + Below + "\"}");
			}
			Known->second = Index;
		}
	}
}

/** Changes when drydock's own library does: size and time of its file. */
std::string GetOwnIdentity()
{
	Dl_info Info = {};
	std::error_code Error;
	const bool bFound = dladdr(reinterpret_cast<const void*>(&GetPassFunctions), &Info) != 0;
	const Files::path File = bFound && Info.dli_fname != nullptr ? Info.dli_fname : "";
	return File.string() + " " + std::to_string(Files::file_size(File, Error)) + " " +
		   std::to_string(Files::last_write_time(File, Error).time_since_epoch().count());
}

/** Covers everything that the library is made from. */
std::string HashOfBuild(const FOverlayFolder& Folder, const FOverlaySource& Source, const FPluginBuild& Build)
{
	FContentHash Hash;
	Hash.Add(GetOwnIdentity());
	Hash.Add(std::to_string(Build.EngineMinor));
	for (const std::string& Text : {Source.Connections, Source.Members, Source.Types})
	{
		Hash.Add(Text);
	}
	for (const std::string& File : Folder.Read)
	{
		Hash.Add(File);
		Hash.Add(TryReadTextFile(File).value_or(""));
	}
	return Hash.Finish();
}

/** Writes the file unless it has this text: its time would have everything compiled again. */
void WriteIfNew(const std::string& File, const std::string& Text)
{
	if (TryReadTextFile(File) != Text)
	{
		WriteTextFile(File, Text);
	}
}

/** Builds the overlay's code, unless that is done. Throws FError as BuildPlugin does. */
std::string BuildOverlay(const FOverlayFolder& Folder, int EngineMinor)
{
	const FOverlaySource Source = WriteOverlaySource(Folder);
	FPluginBuild Build;
	Build.Folder = Folder.Path;
	Build.Name = FindPluginName(Folder.Path);
	Build.EngineMinor = EngineMinor;
	// Overlays whose folders bear one name, and engine versions, do not take turns in one folder.
	FContentHash Place;
	Place.Add(Folder.Path);
	Place.Add(std::to_string(EngineMinor));
	Build.BuildFolder = Files::absolute("build/overlay/" + Build.Name + "." + Place.Finish().substr(0, 8)).string();
	const std::string Made = Build.BuildFolder + "/made";
	Build.Sources = Folder.Sources;
	Build.Sources.push_back(Made + "/Connections.cpp");
	Build.IncludeFolders = Folder.IncludeFolders;
	if (!Source.Members.empty())
	{
		Build.Definitions = {"DRYDOCK_OVERLAY_SETTINGS=\"" + Made + "/Settings.inl\"",
			"DRYDOCK_OVERLAY_TYPES=\"" + Made + "/Types.inl\""};
	}
	const std::string Library = Build.BuildFolder + "/cmake/lib" + Build.Name + ".so";
	const std::string StampFile = Build.BuildFolder + "/built.sha256";
	const std::string Stamp = HashOfBuild(Folder, Source, Build) + "\n";
	std::error_code Error;
	const FFolderLock Lock(Build.BuildFolder, std::chrono::seconds(Build.TimeLimitSeconds));
	if (TryReadTextFile(StampFile) == Stamp && Files::exists(Library, Error))
	{
		return Files::canonical(Library).string();
	}
	PrintText(stderr, "building the C++ of the overlay " + Folder.Name + "\n");
	WriteIfNew(Made + "/Connections.cpp", Source.Connections);
	WriteIfNew(Made + "/Settings.inl", Source.Members);
	WriteIfNew(Made + "/Types.inl", Source.Types);
	BuildPlugin(Build);
	WriteTextFile(StampFile, Stamp);
	return Files::canonical(Library).string();
}

} // namespace

FOverlaysOfRun PrepareOverlays(const FConfig& Config, bool bRefuseCode, std::vector<FDiagnostic>& Diagnostics)
{
	FOverlaysOfRun Overlays;
	std::vector<FConfigOverlay> Ordered;
	FConfigMessages Messages(Config.File, Diagnostics);
	const size_t Before = Diagnostics.size();
	CheckNames(Config, Messages);
	const std::vector<size_t> Order = OrderOverlays(Config, Messages);
	if (Diagnostics.size() != Before)
	{
		return Overlays;
	}
	for (const size_t Index : Order)
	{
		const FConfigOverlay& Overlay = Config.Overlays[Index];
		Ordered.push_back(Overlay);
		Overlays.Folders.push_back(ReadOverlayFolder(Config.Resolve(Overlay.Folder.Value), Diagnostics));
		if (bRefuseCode && Overlays.Folders.back().HasCode())
		{
			Messages.Error(ErrorOverlayRefused, Overlay.Folder.Place,
				"the overlay " + Overlay.Folder.Value + " has C++, which is not compiled: --no-plugins was given");
		}
	}
	CheckClashes(Config, Ordered, Overlays.Folders, Messages);
	if (HasErrors(Diagnostics))
	{
		return Overlays;
	}
	for (FOverlayFolder& Folder : Overlays.Folders)
	{
		Folder.Library = Folder.HasCode() ? BuildOverlay(Folder, Config.GetEngineProfile().Minor) : "";
	}
	return Overlays;
}

void ReportOverlays(const FConfig& Config, const FOverlaysOfRun& Overlays, std::vector<FDiagnostic>& Diagnostics)
{
	const FScopedOverlays Active(Overlays); // which the files that shaders include depend on
	const std::set<std::string> Read = ListReadShaders(Config);
	std::map<std::string, const FOverlayFolder*> Last;
	for (const FOverlayFolder& Folder : Overlays.Folders)
	{
		for (const std::string& Name : Folder.ListReplaced())
		{
			Last[Name] = &Folder;
		}
	}
	for (const FOverlayFolder& Folder : Overlays.Folders)
	{
		const std::vector<std::string> Filled = ListPassReplacements(Folder.Library);
		std::vector<std::string> Unread = Folder.Unused;
		std::set<std::string> Missing;
		for (const FOverlayPass& Pass : Folder.Passes)
		{
			if (!Contains(Filled, Pass.Function->Name))
			{
				Missing.insert(Pass.Function->Name);
				Diagnostics.push_back({.Code = ErrorOverlayPlace,
					.Message = std::string(Pass.Function->Name) +
							   " does not stand in for drydock's: expected the function " +
							   Pass.Function->GetSignature() +
							   ", outside of namespaces and of #if blocks that are off, in a header, too",
					.File = Pass.File,
					.Line = Pass.Line});
			}
		}
		std::vector<std::string> Names;
		for (const std::string& Name : Folder.ListReplaced())
		{
			if (Name.starts_with('/') && !Read.contains(ToLowerCase(Name)))
			{
				const std::string Near = FindNearestShaderFile(Name);
				const bool bNear = !Near.empty() && ToLowerCase(Near) != ToLowerCase(Name);
				Unread.push_back(Name + (bNear ? " (did you mean " + Near + "?)" : " (no shader reads it)"));
				continue;
			}
			const FOverlayDefault* const Default = FindItem(Folder.Defaults, Name, &FOverlayDefault::GetPlace);
			const FSettingField* const Field = Default != nullptr ? FindSettingField(Default->Name) : nullptr;
			if (Missing.contains(Name) || (Field != nullptr && Field->Get(FPostProcessSettings()) == Field->Default))
			{
				continue; // it does not act, or it is drydock's value
			}
			Names.push_back(Last[Name] == &Folder ? Name : Name + " (" + Last[Name]->Name + " stands over it)");
		}
		const auto Note = [&](EOverlayError Code, const std::string& Message)
		{
			Diagnostics.push_back({.Severity = ESeverity::Note, .Code = Code, .Message = Message});
		};
		Note(NoteOverlay,
			"the overlay " + Folder.Name + " stands in for " + (Names.empty() ? "nothing" : JoinText(Names)));
		if (!Unread.empty())
		{
			Note(NoteOverlayUnused,
				"nothing here reads these files of the overlay " + Folder.Name + ": " + JoinText(Unread));
		}
	}
}

FScopedOverlays::FScopedOverlays(const FOverlaysOfRun& Overlays)
	: Replacements(ToVector<std::string>(Overlays.Folders, &FOverlayFolder::Library))
{
	std::vector<std::string> Shaders = ToVector<std::string>(
		Overlays.Folders, [](const FOverlayFolder& Folder) { return Folder.Path + "/Engine/Shaders"; });
	ShadersBefore = SetShaderOverlays(std::move(Shaders));
	for (const FOverlayFolder& Folder : Overlays.Folders)
	{
		for (const FOverlayDefault& Default : Folder.Defaults)
		{
			FPostProcessSettings Settings;
			if (const FActiveReplacement* const Set = TakePassReplacement(Default.GetPlace().c_str()))
			{
				CallCode(
					Set->Owner, [&] { reinterpret_cast<void (*)(FPostProcessSettings&)>(Set->Address)(Settings); });
				DefaultsBefore.emplace_back(
					Default.Name, SetSettingDefault(Default.Name, FindSettingField(Default.Name)->Get(Settings)));
			}
		}
	}
}

FScopedOverlays::~FScopedOverlays()
{
	SetShaderOverlays(std::move(ShadersBefore));
	for (auto Before = DefaultsBefore.rbegin(); Before != DefaultsBefore.rend(); ++Before)
	{
		SetSettingDefault(Before->first, Before->second);
	}
}

} // namespace Drydock
