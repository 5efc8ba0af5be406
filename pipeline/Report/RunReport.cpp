// Asks the house for what a run's report says beside the run.
#include "Report/RunReport.h"

#include "Blend/MakeBlendReport.h"
#include "Report/ReportData.h"
#include "Report/ReportPage.h"
#include "Report/WalkData.h"
#include "Run/Explain.h"
#include "Run/RunJson.h"
#include "Run/RunSetup.h"
#include "Text/TextFile.h"

namespace Drydock
{

namespace
{

/** Plugins are not called once more: they may keep a history, or be under a debugger. */
bool HasPlugins(const FRunOptions& Options, const FRunResult& Result)
{
	return !Options.Plugins.empty() || !Result.Config.Plugins.empty();
}

std::string ExplainRun(FRunOptions Options, const FRunResult& Result)
{
	Options.bExecute = false;
	Options.bPlanLoads = true;
	Options.bNoSkip = true;
	Options.bKeepForReport = false;
	Options.Progress = nullptr;
	return MakeExplainJson(MakeExplainReport(Result, RunConfig(Options), FCostModel::Load()));
}

std::string BlendRun(const FRunOptions& Options)
{
	const FRunSetup Setup(Options);
	const FBlendReport Report = MakeBlendReport(Setup, Setup.Config.View.Location.IsSet() ? "view.location" : "scene");
	return MakeBlendJson(Report, FindChangedSettings(Report));
}

} // namespace

EReport ParseReport(const std::string& Word)
{
	return Word == "off" ? EReport::Off : Word == "full" ? EReport::Full : EReport::On;
}

void WriteRunReport(const FRunOptions& Options, const FRunResult& Result, EReport Report,
	const std::filesystem::path& Folder, const std::filesystem::path& Aside, double SaveMs)
{
	const FReportInputs Inputs{.Result = Result,
		.Name = std::filesystem::path(Options.ConfigFile).stem().string(),
		.When = "",
		.TimingJson = MakeTimingJson(Result, SaveMs),
		.ExplainJson = HasPlugins(Options, Result) ? "" : ExplainRun(Options, Result),
		.BlendJson = HasPlugins(Options, Result) ? "" : BlendRun(Options),
		.WalkJson =
			Result.Config.Scene.Sequence.empty() || HasPlugins(Options, Result) ? "" : MakeSceneWalkJson(Options),
		.Folder = Aside.string(),
		.Before = ReadReportBefore(Folder.string()),
		.bFull = Report == EReport::Full};
	WriteWholeFile((Aside / "report.html").string(), MakeReportPage(MakeReportData(Inputs)));
}

} // namespace Drydock
