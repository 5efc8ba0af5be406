// Orders overlays, finds clashes, builds, and switches them on.
#include "Overlay/Overlays.h"

#include "Config/ConfigReader.h"
#include "ContentHash.h"
#include "Overlay/OverlayErrors.h"
#include "Overlay/OverlaySource.h"
#include "Patch/PluginBuild.h"
#include "RangeTools.h"
#include "ShaderDirectories.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <dlfcn.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** Moves each overlay behind those that it stands over. A circle keeps the order of the config. */
std::vector<size_t> OrderOverlays(const std::vector<FConfigOverlay>& Overlays)
{
	std::vector<size_t> Ordered;
	std::vector<bool> Taken(Overlays.size(), false);
	const auto IsFree = [&](size_t Index)
	{
		return std::all_of(Overlays[Index].Over.begin(), Overlays[Index].Over.end(),
			[&](const std::string& Below)
			{
				const auto Found = std::find_if(Overlays.begin(), Overlays.end(),
					[&](const FConfigOverlay& Other) { return Other.Folder.Value == Below; });
				return Found == Overlays.end() || Taken[static_cast<size_t>(Found - Overlays.begin())];
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
		}
		Taken[Next] = true;
		Ordered.push_back(Next);
	}
	return Ordered;
}

/** Names what two overlays fill, where neither says that it stands over the other. */
void CheckClashes(
	const std::vector<FConfigOverlay>& Overlays, const std::vector<FOverlayFolder>& Folders, FConfigMessages& Messages)
{
	std::map<std::string, size_t> Filled;
	for (size_t Index = 0; Index < Folders.size(); ++Index)
	{
		for (const std::string& Name : Folders[Index].ListReplaced())
		{
			const auto [Known, bNew] = Filled.try_emplace(Name, Index);
			const std::vector<std::string>& Over = Overlays[Index].Over;
			const std::string& Below = Overlays[Known->second].Folder.Value;
			if (!bNew && std::find(Over.begin(), Over.end(), Below) == Over.end())
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

/** A line for each overlay: its name and what it replaces. */
std::vector<std::string> DescribeOverlays(const std::vector<FOverlayFolder>& Folders)
{
	std::map<std::string, std::string> Last;
	for (const FOverlayFolder& Folder : Folders)
	{
		for (const std::string& Name : Folder.ListReplaced())
		{
			Last[Name] = Folder.Name;
		}
	}
	std::vector<std::string> Lines;
	for (const FOverlayFolder& Folder : Folders)
	{
		std::vector<std::string> Names;
		for (const std::string& Name : Folder.ListReplaced())
		{
			Names.push_back(Last[Name] == Folder.Name ? Name : Name + " (" + Last[Name] + " stands over it)");
		}
		Lines.push_back("the overlay " + Folder.Name + " stands in for " + JoinText(Names));
	}
	return Lines;
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
	Build.BuildFolder = Files::absolute("build/overlay/" + Build.Name).string();
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
	if (TryReadTextFile(StampFile) == Stamp && Files::exists(Library, Error))
	{
		return Library;
	}
	WriteIfNew(Made + "/Connections.cpp", Source.Connections);
	WriteIfNew(Made + "/Settings.inl", Source.Members);
	WriteIfNew(Made + "/Types.inl", Source.Types);
	BuildPlugin(Build);
	WriteTextFile(StampFile, Stamp);
	return Library;
}

} // namespace

FOverlaysOfRun PrepareOverlays(const FConfig& Config, bool bRefuseCode, std::vector<FDiagnostic>& Diagnostics)
{
	FOverlaysOfRun Overlays;
	std::vector<FConfigOverlay> Ordered;
	FConfigMessages Messages(Config.File, Diagnostics);
	const size_t Before = Diagnostics.size();
	for (const size_t Index : OrderOverlays(Config.Overlays))
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
	CheckClashes(Ordered, Overlays.Folders, Messages);
	if (Diagnostics.size() != Before)
	{
		return Overlays;
	}
	const std::vector<std::string> Lines = DescribeOverlays(Overlays.Folders);
	for (size_t Index = 0; Index < Ordered.size(); ++Index)
	{
		const FOverlayFolder& Folder = Overlays.Folders[Index];
		const auto Note = [&](EOverlayError Code, const std::string& Message)
		{
			Diagnostics.push_back({ESeverity::Note, Code, Message, Ordered[Index].Folder.Value, 0, 0, {}});
		};
		Note(NoteOverlay, Lines[Index]);
		if (!Folder.Unused.empty())
		{
			Note(NoteOverlayUnused, "nothing here reads these files of the overlay: " + JoinText(Folder.Unused));
		}
		if (Folder.HasCode())
		{
			Overlays.Libraries.push_back(BuildOverlay(Folder, Config.GetEngineProfile().Minor));
		}
	}
	return Overlays;
}

FScopedOverlays::FScopedOverlays(const FOverlaysOfRun& Overlays)
	: Replacements(Overlays.Libraries)
{
	std::vector<std::string> Shaders = ToVector<std::string>(
		Overlays.Folders, [](const FOverlayFolder& Folder) { return Folder.Path + "/Engine/Shaders"; });
	ShadersBefore = SetShaderOverlays(std::move(Shaders));
}

FScopedOverlays::~FScopedOverlays()
{
	SetShaderOverlays(std::move(ShadersBefore));
}

} // namespace Drydock
