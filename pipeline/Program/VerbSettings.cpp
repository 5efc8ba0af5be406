// `drydock settings import` and `export`: the engine's paste text from and to configs. Source: drydock.
#include "Config/ReadConfig.h"
#include "Config/SettingsJson.h"
#include "PostProcessSettingsReflection.h"
#include "Program/Verbs.h"
#include "Run/RunSetup.h"
#include "Text/ConfigErrors.h"
#include "Text/JsonWriter.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

namespace Drydock
{

namespace
{

std::string ReadText(const std::string& File)
{
	if (File == "-")
	{
		return std::string(std::istreambuf_iterator<char>(std::cin), {});
	}
	std::ifstream Stream(File, std::ios::binary);
	if (std::filesystem::is_directory(File) || !Stream)
	{
		FDiagnostic Diagnostic;
		Diagnostic.Code = ErrorFileMissing;
		Diagnostic.File = File;
		Diagnostic.Message = "the text cannot be read";
		throw FError(Diagnostic, ExitFiles);
	}
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

void Upgrade(std::vector<FVolumeText>& Volumes, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	for (FVolumeText& Volume : Volumes)
	{
		std::string Names;
		for (const std::string& Name : UpgradeSettings(Volume.Settings.Settings))
		{
			Names += (Names.empty() ? "" : ", ") + Name;
		}
		if (!Names.empty())
		{
			FDiagnostic Diagnostic;
			Diagnostic.Severity = ESeverity::Note;
			Diagnostic.Code = NoteTextUpgraded;
			Diagnostic.File = File;
			Diagnostic.Where = Volume.Name;
			Diagnostic.Message = "BloomMethod is BM_FFT, so these become 1, as the engine upgrades them: " + Names;
			Diagnostics.push_back(Diagnostic);
		}
	}
}

/** Pasted structs have no name: the file's will do. */
void NameVolumes(std::vector<FVolumeText>& Volumes, const std::string& File)
{
	for (FVolumeText& Volume : Volumes)
	{
		if (Volume.Name.empty())
		{
			Volume.Name = File == "-" ? "Pasted" : std::filesystem::path(File).stem().string();
		}
	}
}

std::string MakeImportJson(const std::vector<FVolumeText>& Volumes, const std::vector<FDiagnostic>& Diagnostics)
{
	FJsonWriter Writer;
	Writer.BeginObject();
	Writer.Key("volumes");
	WriteVolumes(Writer, Volumes);
	Writer.Key("messages");
	WriteDiagnostics(Writer, Diagnostics);
	Writer.EndObject();
	return Writer.GetText();
}

/** The volumes that are asked for; none, or several where one is wanted, is an error. */
std::vector<FVolumeText> CollectVolumes(
	const FConfig& Config, const FSettingsVerbOptions& Options, std::vector<FDiagnostic>& Diagnostics)
{
	std::vector<FVolumeText> Volumes;
	std::vector<std::string> Names;
	for (const FConfigVolume& Volume : Config.Volumes)
	{
		Names.push_back(Volume.Name);
		if (!Options.Volume || *Options.Volume == Volume.Name)
		{
			Volumes.push_back(MakeVolumeText(Volume, Config.File, Diagnostics));
		}
	}
	const std::string Nearest = Options.Volume ? FindNearestName(*Options.Volume, Names) : "";
	const std::string Mistake =
		Volumes.empty() && !Options.Volume ? "the config has no volumes to export"
		: Volumes.empty()
			? "there is no volume " + *Options.Volume + (Nearest.empty() ? "" : "; did you mean " + Nearest + "?")
		: Options.bStruct && Volumes.size() > 1 ? "the config has several volumes: name the one to export with --volume"
												: "";
	if (!Mistake.empty())
	{
		Diagnostics.push_back({ESeverity::Error, ErrorBadArgument, Mistake, Config.File});
	}
	return Volumes;
}

/** What volumes and camera override at a place, with the values that render: one unbound volume. */
std::vector<FVolumeText> BlendVolume(const FSettingsVerbOptions& Options)
{
	FRunOptions RunOptions;
	RunOptions.ConfigFile = Options.File;
	RunOptions.Location = ParseLocation(Options.At);
	const FRunSetup Setup(RunOptions);
	FVolumeText Volume;
	Volume.Name = "At " + Options.At;
	Volume.bUnbound = true;
	Volume.Settings.Settings = Setup.Settings.Settings;
	for (const FSettingField& Field : GetSettingFields())
	{
		// What nobody overrides is the project's: r.DefaultFeature and the like hold there too.
		if (!Field.IsOverridden(Volume.Settings.Settings))
		{
			Field.Set(Volume.Settings.Settings, Field.Default);
		}
	}
	return {Volume};
}

std::vector<FVolumeText> LoadVolumes(const FSettingsVerbOptions& Options, std::vector<FDiagnostic>& Diagnostics)
{
	const FConfig Config = LoadConfig(Options.File, Diagnostics);
	if (HasErrors(Diagnostics))
	{
		throw FError(Diagnostics, ExitUsage);
	}
	Diagnostics.clear(); // warnings are for those who run it
	return CollectVolumes(Config, Options, Diagnostics);
}

} // namespace

int SettingsImportVerb(const FSettingsVerbOptions& Options)
{
	const std::string File = Options.File == "-" ? "<stdin>" : Options.File;
	std::vector<FDiagnostic> Diagnostics;
	std::vector<FVolumeText> Volumes = ReadVolumesText(ReadText(Options.File), File, Diagnostics);
	const bool bBroken = HasErrors(Diagnostics);
	if (bBroken)
	{
		Volumes.clear();
	}
	NameVolumes(Volumes, Options.File);
	if (Options.bUpgrade)
	{
		Upgrade(Volumes, File, Diagnostics);
	}
	if (Options.bJson)
	{
		std::fputs(MakeImportJson(Volumes, Diagnostics).c_str(), stdout);
		return bBroken ? ExitUsage : ExitDone;
	}
	PrintDiagnostics(Diagnostics);
	if (bBroken)
	{
		return ExitUsage;
	}
	FJsonWriter Writer;
	WriteVolumes(Writer, Volumes);
	std::fputs(Writer.GetText().c_str(), stdout);
	return ExitDone;
}

int SettingsExportVerb(const FSettingsVerbOptions& Options)
{
	std::vector<FDiagnostic> Diagnostics;
	const ESettingsTextForm Form = Options.bFull ? ESettingsTextForm::Full : ESettingsTextForm::Delta;
	const std::vector<FVolumeText> Volumes =
		Options.At.empty() ? LoadVolumes(Options, Diagnostics) : BlendVolume(Options);
	if (HasErrors(Diagnostics))
	{
		throw FError(Diagnostics, ExitUsage);
	}
	const std::string Text = Options.bStruct ? WriteSettingsText(Volumes[0].Settings, Form, Diagnostics) + "\n"
											 : WriteVolumesText(Volumes, Form, Diagnostics);
	PrintDiagnostics(Diagnostics);
	std::fputs(Text.c_str(), stdout);
	return ExitDone;
}

} // namespace Drydock
