// `drydock blend`: prints the post-process settings at a place or along a path, and how each came about.
#include <CLI/CLI.hpp>

#include "Blend/BlendReport.h"
#include "Extensions/ViewExtensions.h"
#include "Program/ProgressBar.h"
#include "Program/ProgramOutput.h"
#include "Program/SettingStory.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Run/FinalSettings.h"
#include "Run/RunSetup.h"

#include <cstdio>
#include <memory>
#include <numeric>
#include <unistd.h>

namespace Drydock
{

namespace
{

std::string ExplainLocation(const FBlendOptions& Options, const FConfig& Config)
{
	return !Options.At.empty()            ? "--at"
		   : Config.View.Location.IsSet() ? "view.location"
		   : Config.Scene.CameraLocation  ? "the scene's camera"
										  : "no volume asks where";
}

/** View extensions have the last word: what those of the config and its plugins do to the settings in SetupView, on a
 * view that has no frame. */
void AddExtensionEdits(const FRunSetup& Setup, FBlendReport& Report)
{
	FHookLog Log;
	FViewExtensionFrame Extensions(Setup.Config.GetEngineProfile(), Log);
	FSceneViewFamily Family;
	Family.EngineShowFlags = Setup.Settings.ShowFlags;
	Extensions.Gather(Family, Setup.Plugins);
	Extensions.SetupViewFamily(Family);

	FViewInfo View;
	View.Family = &Family;
	View.ViewLocation = Report.Location;
	View.FinalPostProcessSettings = Report.Blended.Settings;
	Family.Views.Add(&View);
	Extensions.SetupView(Family, {&View, ""}, Report.Blended.Gates, &Report.Ledger);
	Report.Blended.Settings = View.FinalPostProcessSettings;
	Report.Diagnostics.insert(Report.Diagnostics.end(), Log.Diagnostics.begin(), Log.Diagnostics.end());
}

/** Console variables are those of the setup, which must live on. */
FBlendReport MakeReport(const FBlendOptions& Options, const FRunSetup& Setup)
{
	const FSettingsBlender Blender = MakeSettingsBlender(Setup.Config);
	FBlendReport Report;
	Report.Config = Setup.Config.File;
	Report.Location = GetViewLocation(Setup.Config);
	Report.LocationFrom = ExplainLocation(Options, Setup.Config);
	for (const APostProcessVolume& Volume : Blender.GetInputs().Volumes)
	{
		Report.VolumeNames.emplace_back(*Volume.Name);
		Report.VolumeProperties.push_back(Volume.GetProperties());
		Report.VolumeProperties.back().Settings = nullptr; // the blender's, which ends here
	}
	Report.Volumes = Blender.FindVolumes(Report.Location);
	Report.Blended = Blender.At(Report.Location, &Report.Ledger);
	Report.Diagnostics = Setup.Diagnostics;
	AddExtensionEdits(Setup, Report);
	return Report;
}

std::vector<size_t> GetAllSettings()
{
	std::vector<size_t> All(GetSettingFields().size());
	std::iota(All.begin(), All.end(), size_t{0});
	return All;
}

FVerbCall AddOptions(CLI::App& Verb)
{
	const auto Options = std::make_shared<FBlendOptions>();
	AddConfig(Verb, Options->Run);
	CLI::Option* const At =
		Verb.add_option("--at", Options->At, "Where, in cm; the view's location by default")->type_name("X,Y,Z");
	CLI::Option* const Path = Verb.add_option("--path", Options->Path,
									  "Along these points: a JSON file, or \"scene\" for the cameras of the scene's "
									  "frames")
								  ->type_name("FILE|scene")
								  ->excludes(At);
	RequireRange(
		Verb.add_option("--steps", Options->Steps, "Places between two points of the path; some 240 in all by default"),
		0, 100000)
		->type_name("N")
		->needs(Path);
	Verb.add_option("--out", Options->OutputFolder, "Folder for walk.csv and walk.svg; out/NAME by default")
		->type_name("DIR")
		->needs(Path);
	AddRepeated(Verb, "--setting", "NAME", Options->Names,
		"Only these settings, with * and ?; repeats; by default those that changed");
	Verb.add_flag("--json", Options->bJson, "Print all settings with their whole ledger as JSON");
	return [Options]
	{
		return Options->Path.empty() ? PrintSettingStory(*Options) : WalkAlongPath(*Options);
	};
}

const FVerbRegistration GRegistration({
	.Name = "blend",
	.Place = 30,
	.Doc = "Print the post-process settings at a place, and how each came about",
	.AddOptions = AddOptions,
});

} // namespace

int PrintSettingStory(const FBlendOptions& Options)
{
	FRunOptions RunOptions = Options.Run;
	if (!Options.At.empty())
	{
		RunOptions.Location = ParseLocation(Options.At);
	}
	const bool bChosen = !Options.Names.empty();
	const std::vector<size_t> Chosen = FindSettings(Options.Names);
	const FRunSetup Setup(RunOptions);
	const FBlendReport Report = MakeReport(Options, Setup);
	PrintDiagnostics(Report.Diagnostics);
	const std::string Text = Options.bJson ? MakeBlendJson(Report, bChosen ? Chosen : GetAllSettings())
										   : MakeBlendText(Report, bChosen ? Chosen : FindChangedSettings(Report),
												 !bChosen, IsColorful(STDOUT_FILENO));
	std::fputs(Text.c_str(), stdout);
	return ExitDone;
}

} // namespace Drydock
