// `drydock study`: measures what accuracy costs, by the variants of a config's study.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "Program/ProgramOutput.h"
#include "Program/ProgressBar.h"
#include "Program/ReportOption.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Report/ReportPage.h"
#include "Report/StudyPage.h"
#include "Study/StudyChart.h"
#include "Study/StudyInsets.h"
#include "Study/StudyReport.h"
#include "Study/StudyRun.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"

#include <chrono>
#include <cstdio>
#include <ctime>
#include <memory>

namespace Drydock
{

namespace
{

struct FStudyOptions
{
	FRunOptions Run;
	std::string OutputFolder; // empty: GetDefaultOutputFolder
	bool bJson = false;
	std::string Report; // "off", "on"; empty: on where a person looks on
};

/** study.json last: a budget reads it. */
const FOutputNames& GetStudyOutputNames()
{
	static const FOutputNames Names = {.Name = "study",
		.Files = {"study.json", "study.csv", "study.svg", "study_taps.svg", "study_insets.svg", "study_timing.json",
			"study_timing.csv", "study.html"},
		.Last = "study.json",
		.Folders = {"insets"},
		.Unsteady = {"study.html"}};
	return Names;
}

/** Prints the table of the study, or study.json, and writes study.json, study.csv, study_taps.svg and, with times,
 * study_timing.json, study_timing.csv, study.svg; study_insets.svg with insets/; and study.html where it is asked for.
 */
int RunStudy(const FStudyOptions& Options)
{
	FProgressBar Bar;
	FRunOptions RunOptions = Options.Run;
	RunOptions.Progress = [&](int Done, int Total, const std::string& What)
	{
		Bar.Show(Done, Total, What);
	};
	const auto Begin = std::chrono::steady_clock::now();
	FStudyRun Run(RunOptions);
	FOutputFolder Folder(ChooseOutputFolder(Options.OutputFolder, Options.Run), GetStudyOutputNames());
	const FStudyResult Result = Run.Measure();
	const auto Write = [&](const char* Name, const std::string& Text)
	{
		WriteWholeFile((Folder.GetAside() / Name).string(), Text);
	};
	Bar.Show(1, 1, "pictures");
	const std::vector<FStudyInsetRow> Insets = WriteStudyInsets(Run, Result, Folder.GetAside().string());
	Write("study_insets.svg", DrawStudyInsets(Result.Name + ": what the errors look like", Insets));
	Write("study.json", MakeStudyJson(Result));
	Write("study.csv", MakeStudyCsv(Result, false));
	Write("study_taps.svg", DrawStudyChart(Result, EStudyCost::Taps));
	Write("study_timing.json", MakeStudyTimingJson(Result));
	Write("study_timing.csv", MakeStudyCsv(Result, true));
	Write("study.svg", DrawStudyChart(Result, EStudyCost::Milliseconds));
	if (WantsReport(Options.Report, Options.bJson))
	{
		Write("study.html", MakeReportPage(MakeStudyPageData(Result, Insets, FormatReportTime(std::time(nullptr)))));
	}
	Folder.PutInPlace();
	Bar.Clear();
	PrintDiagnostics(Result.Diagnostics);
	if (Options.bJson)
	{
		std::fputs(MakeStudyJson(Result).c_str(), stdout);
		return ExitDone;
	}
	const double Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - Begin).count();
	std::fputs(fmt::format("{}\npicture  {} ({:.0f} s, {:.0f} s of them measuring)\n", MakeStudyTable(Result),
				   (Folder.GetPath() / "study.svg").string(), Seconds, Result.Seconds)
				   .c_str(),
		stdout);
	if (WantsReport(Options.Report, Options.bJson))
	{
		PrintPage(Folder.GetPath() / "study.html");
	}
	return ExitDone;
}

FVerbCall AddOptions(CLI::App& Verb)
{
	const auto Options = std::make_shared<FStudyOptions>();
	AddConfig(Verb, Options->Run);
	AddThreads(Verb, Options->Run, "Threads; 0: all cores (default)");
	Verb.add_option("--out", Options->OutputFolder, "Folder for tables and pictures; out/NAME of the config by default")
		->type_name("DIR");
	AddReport(Verb, Options->Report, "study.html, the chart with what lies behind its points");
	Verb.add_flag("--json", Options->bJson, "Print study.json instead of the table");
	return [Options]
	{
		return RunStudy(*Options);
	};
}

const FVerbRegistration GRegistration({
	.Name = "study",
	.Place = 50,
	.Doc = "Measure what accuracy costs: the variants of a config's study",
	.AddOptions = AddOptions,
});

} // namespace

} // namespace Drydock
