// `drydock study`. Source: drydock.
#include "ProgressBar.h"
#include "RunOutputs.h"
#include "Study/StudyChart.h"
#include "Study/StudyInsets.h"
#include "Study/StudyReport.h"
#include "Study/StudyRun.h"
#include "Verbs.h"

#include <cstdio>
#include <filesystem>

namespace Drydock
{

int StudyVerb(const FVerbOptions& Options)
{
	FProgressBar Bar;
	FRunOptions RunOptions = Options.Run;
	RunOptions.Progress = [&](int Done, int Total, const std::string& What)
	{
		Bar.Show(Done, Total, What);
	};
	const FStudyResult Result = RunStudy(RunOptions);
	RunOptions.Progress = nullptr;
	const std::filesystem::path Folder =
		Options.OutputFolder.empty() ? GetDefaultOutputFolder(Options.Run.ConfigFile) : Options.OutputFolder;
	const auto Write = [&](const char* Name, const std::string& Text)
	{
		WriteTextFile((Folder / Name).string(), Text);
	};
	Bar.Show(1, 1, "pictures");
	const std::string Insets = DrawStudyInsets(
		Result.Name + ": what the errors look like", WriteStudyInsets(RunOptions, Result, Folder.string()));
	Write("study_insets.svg", Insets);
	Write("study.json", MakeStudyJson(Result));
	Write("study.csv", MakeStudyCsv(Result, false));
	Write("study_taps.svg", DrawStudyChart(Result, EStudyCost::Taps));
	Write("study_timing.json", MakeStudyTimingJson(Result));
	Write("study_timing.csv", MakeStudyCsv(Result, true));
	Write("study.svg", DrawStudyChart(Result, EStudyCost::Milliseconds));
	Bar.Clear();
	PrintDiagnostics(Result.Diagnostics);
	if (Options.bJson)
	{
		std::fputs(MakeStudyJson(Result).c_str(), stdout);
		return ExitDone;
	}
	char Seconds[64];
	std::snprintf(Seconds, sizeof(Seconds), "%.0f s", Result.Seconds);
	std::fputs(
		(MakeStudyTable(Result) + "\npicture  " + (Folder / "study.svg").string() + " (" + Seconds + ")\n").c_str(),
		stdout);
	return ExitDone;
}

} // namespace Drydock
