// `drydock study`. Source: drydock.
#include "Budget/RunOptions.h"
#include "Program/ProgressBar.h"
#include "Program/Verbs.h"
#include "Run/RunOutputs.h"
#include "Study/StudyChart.h"
#include "Study/StudyInsets.h"
#include "Study/StudyReport.h"
#include "Study/StudyRun.h"
#include "Text/TextFile.h"
#include "Text/TextFormat.h"

#include <chrono>
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
	const auto Begin = std::chrono::steady_clock::now();
	FStudyRun Run(RunOptions);
	const FStudyResult Result = Run.Measure();
	const std::filesystem::path Folder =
		Options.OutputFolder.empty() ? GetDefaultOutputFolder(Options.Run.ConfigFile) : Options.OutputFolder;
	const auto Write = [&](const char* Name, const std::string& Text)
	{
		WriteTextFile((Folder / Name).string(), Text);
	};
	Bar.Show(1, 1, "pictures");
	Write("study_insets.svg",
		DrawStudyInsets(Result.Name + ": what the errors look like", WriteStudyInsets(Run, Result, Folder.string())));
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
	const double Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - Begin).count();
	std::fputs((MakeStudyTable(Result) + "\npicture  " + (Folder / "study.svg").string() +
				   Format(" (%.0f s, ", Seconds) + Format("%.0f s of them measuring)\n", Result.Seconds))
				   .c_str(),
		stdout);
	return ExitDone;
}

} // namespace Drydock
