// Asks the house for what a run's report says beside the run.
#include "Report/RunReport.h"

#include "Blend/MakeBlendReport.h"
#include "PostProcessSettingsReflection.h"
#include "Report/ReportData.h"
#include "Report/ReportPage.h"
#include "Report/WalkData.h"
#include "Run/Explain.h"
#include "Run/RunJson.h"
#include "Run/RunSetup.h"
#include "TemporaryFolder.h"
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

/** With plugins nothing is known of the frame without skipping. */
std::string ExplainRun(FRunOptions Options, const FRunResult& Result)
{
	if (HasPlugins(Options, Result))
	{
		return MakeExplainJson(MakeExplainReport(Result, Result, FCostModel::Load()));
	}
	Options.bExecute = false;
	Options.bPlanLoads = true;
	Options.bNoSkip = true;
	Options.bKeepForReport = false;
	Options.Progress = nullptr;
	return MakeExplainJson(MakeExplainReport(Result, RunConfig(Options), FCostModel::Load()));
}

/** The blend once more; of plugins only the settings, as they blend without SetupView. */
FBlendReport BlendRun(const FRunOptions& Options, const FRunResult& Result)
{
	const FRunSetup Setup(Options);
	return MakeBlendReport(
		Setup, Setup.Config.View.Location.IsSet() ? "view.location" : "scene", !HasPlugins(Options, Result));
}

/** The settings that something other than a default gives, and those that an extension has changed since. */
std::set<std::string> FindTouched(const FBlendReport& Blend, const FRunResult& Result)
{
	std::set<std::string> Names;
	for (const size_t Index : FindChangedSettings(Blend))
	{
		Names.insert(GetSettingFields()[Index].Name);
	}
	for (const FSettingField& Field : GetSettingFields())
	{
		if (SettingToJson(Field, Field.Get(Blend.Blended.Settings)) != SettingToJson(Field, Field.Get(Result.Settings)))
		{
			Names.insert(Field.Name);
		}
	}
	return Names;
}

} // namespace

EReport ParseReport(const std::string& Word)
{
	return Word == "off" ? EReport::Off : Word == "full" ? EReport::Full : EReport::On;
}

std::string MakeRunReportData(const FRunOptions& Options, const FRunResult& Result)
{
	const FTemporaryFolder Temporary;
	const std::filesystem::path Folder = Temporary.Reserve("report");
	std::filesystem::create_directory(Folder);
	const FBlendReport Blend = BlendRun(Options, Result);
	return MakeReportData({.Result = Result,
		.Name = std::filesystem::path(Options.ConfigFile).stem().string(),
		.When = "",
		.TimingJson = MakeTimingJson(Result, 0.0),
		.ExplainJson = ExplainRun(Options, Result),
		.BlendJson = MakeBlendJson(Blend, FindChangedSettings(Blend)),
		.WalkJson = "",
		.Touched = FindTouched(Blend, Result),
		.Folder = Folder.string(),
		.Before = {},
		.bLarge = false});
}

void WriteRunReport(const FRunOptions& Options, const FRunResult& Result, EReport Report,
	const std::filesystem::path& Folder, const std::filesystem::path& Aside, double SaveMs)
{
	const FBlendReport Blend = BlendRun(Options, Result);
	const FReportInputs Inputs{.Result = Result,
		.Name = std::filesystem::path(Options.ConfigFile).stem().string(),
		.When = "",
		.TimingJson = MakeTimingJson(Result, SaveMs),
		.ExplainJson = ExplainRun(Options, Result),
		.BlendJson = MakeBlendJson(Blend, FindChangedSettings(Blend)),
		.WalkJson =
			Result.Config.Scene.Sequence.empty() || HasPlugins(Options, Result) ? "" : MakeSceneWalkJson(Options),
		.Touched = FindTouched(Blend, Result),
		.Folder = Aside.string(),
		.Before = ReadReportBefore(Folder.string()),
		.bFull = Report == EReport::Full};
	WriteWholeFile((Aside / "report.html").string(), MakeReportPage(MakeReportData(Inputs)));
}

} // namespace Drydock
