// `drydock blend`: prints the post-process settings at a place or along a path, and how each came about.
#include "Blend/BlendReport.h"
#include "Blend/MakeBlendReport.h"
#include "Program/ProgressBar.h"
#include "Program/ProgramOutput.h"
#include "Program/SettingStory.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Run/RunSetup.h"

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

std::vector<size_t> GetAllSettings()
{
	std::vector<size_t> All(GetSettingFields().size());
	std::iota(All.begin(), All.end(), size_t{0});
	return All;
}

} // namespace

FVerbCall AddBlendOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FBlendOptions>();
	AddConfig(Verb, Options->Run);
	const FVerbOption At =
		Verb.Add("--at", Options->At, "Blend at this location, in cm; at the view's location by default")
			.SetType("X,Y,Z");
	const FVerbOption Path =
		Verb.Add("--path", Options->Path,
				"Blend along these points: a JSON file, or \"scene\" for the cameras of the scene's "
				"frames")
			.SetType("FILE|scene")
			.Exclude(At);
	Verb.Add(
			"--steps", Options->Steps, "Number of locations between two points of the path; by default some 240 in all")
		.RequireRange(0, 100000)
		.SetType("N")
		.Need(Path);
	Verb.Add("--out", Options->OutputFolder, "Folder for walk.csv and walk.svg; out/NAME by default")
		.SetType("DIR")
		.Need(Path);
	Verb.AddRepeated("--setting", "SETTING", Options->Names,
		"Print only these settings, with * and ?; repeats; by default the changed ones");
	Verb.AddFlag("--json", Options->bJson, "Print JSON: all settings, each with its whole ledger");
	return [Options]
	{
		return Options->Path.empty() ? PrintSettingStory(*Options) : WalkAlongPath(*Options);
	};
}

int PrintSettingStory(const FBlendOptions& Options)
{
	FRunOptions RunOptions = Options.Run;
	if (!Options.At.empty())
	{
		RunOptions.Location = ParseLocation(Options.At);
	}
	const FRunSetup Setup(RunOptions);
	const bool bChosen = !Options.Names.empty();
	const std::vector<size_t> Chosen = FindSettings(Options.Names); // those of plugins and overlays among them
	const FBlendReport Report = MakeBlendReport(Setup, ExplainLocation(Options, Setup.Config));
	PrintDiagnostics(Report.Diagnostics);
	const std::string Text = Options.bJson ? MakeBlendJson(Report, bChosen ? Chosen : GetAllSettings())
										   : MakeBlendText(Report, bChosen ? Chosen : FindChangedSettings(Report),
												 !bChosen, IsColorful(STDOUT_FILENO));
	PrintResult(Text, Options.bJson);
	return ExitDone;
}

} // namespace Drydock
