// `drydock study`: measures what accuracy costs, by the variants of a config's study.
#include "PrintText.h"
#include "Program/FindingsOption.h"
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
#include "Text/Fmt.inl"
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
	FFindingsOptions Findings;
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

/** A case for each variant, which fails where its picture has NaN or infinity that the reference lacks; and, where
 * the config has a budget, one for each job's choice, which fails where no variant meets it. */
std::vector<FJUnitCase> MakeStudyCases(const FStudyResult& Result)
{
	std::vector<FJUnitCase> Cases;
	for (const FStudyJob& Job : Result.Jobs)
	{
		const std::string Prefix = Job.Case.Label.empty() ? "" : Job.Case.Label + ", ";
		bool bChosen = false;
		for (const size_t Index : Job.Variants)
		{
			const FStudyVariant& Variant = Result.Variants[Index];
			FJUnitCase Case{.Name = Prefix + Variant.Label, .Rule = "variant"};
			bChosen = bChosen || Variant.bRecommended;
			if (!Variant.Competes())
			{
				Case.Outcome = EJUnitOutcome::Skipped;
				Case.Message = Variant.Excluded;
			}
			else if (Variant.Error.NumNonFinite > 0)
			{
				Case.Outcome = EJUnitOutcome::Failed;
				Case.Message = fmt::format("{} values are not finite", Variant.Error.NumNonFinite);
			}
			if (Variant.bRan)
			{
				Case.Seconds = Variant.Time.Median / 1000.0;
				Case.Output = fmt::format("{} {:.6g}, {:.3f} ms", Result.GetMetric(),
					GetMetric(Variant.Error, Result.GetMetric()), Variant.Time.Median);
			}
			Cases.push_back(std::move(Case));
		}
		if (!Result.Study.Budget.bDefault)
		{
			Cases.push_back({.Name = Prefix + "recommended",
				.Outcome = bChosen ? EJUnitOutcome::Passed : EJUnitOutcome::Failed,
				.Message = bChosen ? "" : Job.Recommendation,
				.Output = bChosen ? Job.Recommendation : "",
				.Rule = "budget"});
		}
	}
	return Cases;
}

/** Prints the table of the study, or study.json, and writes study.json, study.csv, study_taps.svg and, with times,
 * study_timing.json, study_timing.csv, study.svg; study_insets.svg with insets/; and study.html where it is asked for.
 */
int RunStudy(const FStudyOptions& Options, FJUnitSuite& Suite)
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
	Suite.Cases = MakeStudyCases(Result);
	const auto Write = [&](const char* Name, const std::string& Text)
	{
		WriteWholeFile((Folder.GetAside() / Name).string(), Text);
	};
	Bar.Show(1, 1, "pictures");
	const std::vector<FStudyInsetRow> Insets = WriteStudyInsets(Run, Result, Folder.GetAside().string());
	Write("study_insets.svg", DrawStudyInsets(Result.Name + ": what the errors look like", Insets));
	Write("study.json", MakeStudyJson(Result));
	Write("study.csv", MakeStudyCsv(Result, false));
	Write("study_taps.svg", DrawChart(MakeStudyChart(Result, EStudyCost::Taps)));
	Write("study_timing.json", MakeStudyTimingJson(Result));
	Write("study_timing.csv", MakeStudyCsv(Result, true));
	Write("study.svg", DrawChart(MakeStudyChart(Result, EStudyCost::Milliseconds)));
	if (WantsReport(Options.Report, Options.bJson))
	{
		Write("study.html", MakeReportPage(MakeStudyPageData(Result, Insets, FormatReportTime(std::time(nullptr)))));
	}
	Folder.PutInPlace();
	Bar.Clear();
	PrintDiagnostics(Result.Diagnostics);
	if (Options.bJson)
	{
		PrintText(stdout, MakeStudyJson(Result));
		return ExitDone;
	}
	const double Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - Begin).count();
	PrintResult(fmt::format("{}\npicture  {} ({:.0f} s, {:.0f} s of them measuring)\n",
		MakeStudyTable(Result, GetOutputWidth()), (Folder.GetPath() / "study.svg").string(), Seconds, Result.Seconds));
	if (WantsReport(Options.Report, Options.bJson))
	{
		PrintPage(Folder.GetPath() / "study.html");
	}
	return ExitDone;
}

} // namespace

FVerbCall AddStudyOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FStudyOptions>();
	AddConfig(Verb, Options->Run);
	AddThreads(Verb, Options->Run, "Number of threads; 0: all cores (default)");
	Verb.Add("--out", Options->OutputFolder, "Folder for tables and pictures; out/NAME of the config by default")
		.SetType("DIR");
	AddReport(Verb, Options->Report, "study.html, the chart and the data behind its points");
	AddFindings(Verb, Options->Findings, "a case for each variant, and one for the choice by a budget");
	Verb.AddFlag("--json", Options->bJson, "Print study.json instead of the table");
	return [Options]
	{
		return CallWithFindings(Options->Findings, "study", Options->Run.ConfigFile,
			[&Options](FJUnitSuite& Suite) { return RunStudy(*Options, Suite); });
	};
}

} // namespace Drydock
