// `drydock blend`. Source: drydock.
#include "Blend/BlendReport.h"
#include "Extensions/ViewExtensions.h"
#include "Program/ProgressBar.h"
#include "Program/Verbs.h"
#include "Run/FinalSettings.h"
#include "Run/RunSetup.h"
#include "Text/ConfigErrors.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <unistd.h>

namespace Drydock
{

namespace
{

std::string ExplainLocation(const FVerbOptions& Options, const FConfig& Config)
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
FBlendReport MakeReport(const FVerbOptions& Options, const FRunSetup& Setup)
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

} // namespace

std::array<double, 3> ParseLocation(const std::string& Text)
{
	std::array<double, 3> Location = {};
	const char* At = Text.c_str();
	const char* const End = At + Text.size();
	bool bGood = true;
	for (size_t Index = 0; bGood && Index < Location.size(); ++Index)
	{
		while (*At == ' ')
		{
			++At;
		}
		const std::from_chars_result Result = std::from_chars(At, End, Location[Index]);
		bGood = Result.ec == std::errc() && std::isfinite(Location[Index]);
		At = Result.ptr;
		const bool bLast = Index + 1 == Location.size();
		bGood = bGood && (bLast ? At == End : *At == ',');
		At += bLast ? 0 : 1;
	}
	if (!bGood)
	{
		FDiagnostic Diagnostic;
		Diagnostic.Code = ErrorBadArgument;
		Diagnostic.Where = "--at";
		Diagnostic.Message = "expected X,Y,Z in centimetres such as 25,470,135, found \"" + Text + "\"";
		throw FError(Diagnostic, ExitUsage);
	}
	return Location;
}

int BlendVerb(const FVerbOptions& Options)
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
