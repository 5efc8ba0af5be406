// `drydock settings import` and `export`: turn the engine's paste text into volumes of a config, and back.
#include "Config/SettingsJson.h"
#include "PostProcessSettingsReflection.h"
#include "PrintText.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Run/RunSetup.h"
#include "Text/ConfigErrors.h"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <cstdio>
#include <filesystem>
#include <memory>

namespace Drydock
{

namespace
{

struct FSettingsImportOptions
{
	FRunOptions Run;       // of --config
	std::string File;      // engine text; "-": stdin
	bool bUpgrade = false; // as the engine upgrades old assets
	bool bJson = false;
};

struct FSettingsExportOptions
{
	FRunOptions Run;                   // of --at
	std::string File;                  // a config
	std::optional<std::string> Volume; // only the volume of this name
	std::string At;                    // "X,Y,Z", cm: the settings there, blended, in place of the volumes
	bool bFull = false;                // not only what differs from the defaults
	bool bStruct = false;              // the settings alone, without an actor around them
};

std::string ReadText(const std::string& File)
{
	return File == "-" ? ReadStandardInputText() : ReadTextFile(File, "the text cannot be read");
}

void Upgrade(std::vector<FVolumeText>& Volumes, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	for (FVolumeText& Volume : Volumes)
	{
		const std::string Names = JoinText(UpgradeSettings(Volume.Settings.Settings));
		if (!Names.empty())
		{
			Diagnostics.push_back({.Severity = ESeverity::Note,
				.Code = NoteTextUpgraded,
				.Message = "BloomMethod is BM_FFT, so these become 1, as the engine upgrades them: " + Names,
				.File = File,
				.Where = Volume.Name});
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
	FJsonWriter Writer('{');
	Writer.Key("volumes");
	WriteVolumes(Writer, Volumes);
	Writer.Key("messages");
	WriteDiagnostics(Writer, Diagnostics);
	return Writer.GetText();
}

/** The volumes that are asked for; none, or several where one is wanted, is an error. */
std::vector<FVolumeText> CollectVolumes(
	const FConfig& Config, const FSettingsExportOptions& Options, std::vector<FDiagnostic>& Diagnostics)
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
	const std::string Mistake =
		Volumes.empty() && !Options.Volume ? "the config has no volumes to export"
		: Volumes.empty() ? "there is no volume " + *Options.Volume + SuggestName(*Options.Volume, Names)
		: Options.bStruct && Volumes.size() > 1 ? "the config has several volumes: name the one to export with --volume"
												: "";
	if (!Mistake.empty())
	{
		Diagnostics.push_back({ESeverity::Error, ErrorBadArgument, Mistake, Config.File});
	}
	return Volumes;
}

/** The settings that volumes and camera override at a location, with their blended values, as one unbound volume. */
std::vector<FVolumeText> BlendVolume(const FSettingsExportOptions& Options, const FRunSetup& Setup)
{
	FVolumeText Volume;
	Volume.Name = "At " + Options.At;
	Volume.bUnbound = true;
	Volume.Settings.Settings = Setup.Settings.Settings;
	for (const FSettingField& Field : GetSettingFields())
	{
		// A setting that nobody overrides is the project's: r.DefaultFeature and similar variables hold there too.
		if (!Field.IsOverridden(Volume.Settings.Settings))
		{
			Field.Set(Volume.Settings.Settings, Field.Default);
		}
	}
	return {Volume};
}

int ImportSettings(const FSettingsImportOptions& Options)
{
	const std::string File = Options.File == "-" ? "<stdin>" : Options.File;
	std::vector<FDiagnostic> Diagnostics;
	std::optional<FRunSetup> Setup;
	if (!Options.Run.ConfigFile.empty())
	{
		Setup.emplace(Options.Run); // its plugins may bring settings
	}
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
		PrintText(stdout, MakeImportJson(Volumes, Diagnostics));
		return bBroken ? ExitUsage : ExitDone;
	}
	PrintDiagnostics(Diagnostics);
	if (bBroken)
	{
		return ExitUsage;
	}
	FJsonWriter Writer;
	WriteVolumes(Writer, Volumes);
	PrintText(stdout, Writer.GetText());
	return ExitDone;
}

int ExportSettings(const FSettingsExportOptions& Options)
{
	std::vector<FDiagnostic> Diagnostics;
	const ESettingsTextForm Form = Options.bFull ? ESettingsTextForm::Full : ESettingsTextForm::Delta;
	FRunOptions RunOptions = Options.Run;
	RunOptions.ConfigFile = Options.File;
	if (!Options.At.empty())
	{
		RunOptions.Location = ParseLocation(Options.At);
	}
	const FRunSetup Setup(RunOptions); // its plugins and overlays may bring settings; warnings are for those who run it
	const std::vector<FVolumeText> Volumes =
		Options.At.empty() ? CollectVolumes(Setup.Config, Options, Diagnostics) : BlendVolume(Options, Setup);
	if (HasErrors(Diagnostics))
	{
		throw FError(Diagnostics, ExitUsage);
	}
	const std::string Text = Options.bStruct ? WriteSettingsText(Volumes[0].Settings, Form, Diagnostics) + "\n"
											 : WriteVolumesText(Volumes, Form, Diagnostics);
	PrintDiagnostics(Diagnostics);
	PrintText(stdout, Text);
	return ExitDone;
}

} // namespace

FVerbCall AddSettingsImportOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSettingsImportOptions>();
	Verb.Add("TEXT", Options->File, "Read this file of engine text; - is stdin").Require();
	Verb.AddFlag("--upgrade", Options->bUpgrade, "Upgrade old assets as the engine does: BM_FFT sets intensities to 1");
	Verb.Add("--config", Options->Run.ConfigFile, "Accept the settings that this config's plugins add")
		.SetType("CONFIG");
	AddTrust(Verb, Options->Run);
	Verb.AddFlag("--json", Options->bJson, "Print an object of volumes and messages");
	return CallWith(Options, ImportSettings);
}

FVerbCall AddSettingsExportOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSettingsExportOptions>();
	Verb.Add("CONFIG", Options->File, "JSON config").Require();
	const FVerbOption Volume =
		Verb.Add("--volume", Options->Volume, "Export only the volume of this name").SetType("NAME");
	Verb.Add("--at", Options->At, "Export the blended settings at this location (cm) as one volume")
		.SetType("X,Y,Z")
		.Exclude(Volume);
	Verb.AddFlag("--struct", Options->bStruct, "Export only the settings (..), to paste into a volume's Settings");
	Verb.AddFlag("--full", Options->bFull, "Export all settings, not only those that are overridden or changed");
	AddTrust(Verb, Options->Run);
	return CallWith(Options, ExportSettings);
}

} // namespace Drydock
