// `drydock sweep submit` and `reduce`: a sweep handed to processes, GNU parallel or Slurm, and its page.
#include "Program/ProgramOutput.h"
#include "Program/ReportOption.h"
#include "Program/VerbOptions.h"
#include "Program/VerbSweep.h"
#include "Program/Verbs.h"
#include "Sweep/SweepReduce.h"
#include "Sweep/SweepStatus.h"
#include "Sweep/SweepSubmit.h"

#include <memory>

namespace Drydock
{

namespace
{

struct FSweepReduceOptions
{
	std::string Folder;
	std::string Report; // "on", "off"; empty: on where a person looks on
	bool bJson = false;
};

struct FSweepSubmitOptions
{
	FSubmitRequest Request;
	std::string Engine = "local";
};

int ReduceResults(const FSweepReduceOptions& Options)
{
	const bool bPage = WantsReport(Options.Report, Options.bJson);
	const FSweepTable Table = ReduceSweep(FSweepFolder(Options.Folder), bPage);
	const std::filesystem::path Folder = Options.Folder;
	PrintResult(Options.bJson ? MakeSweepTableJson(Table)
							  : MakeSweepText(Table, GetOutputWidth()) + "table    " + (Folder / "table.csv").string() +
									"\npictures " + (Folder / "sheet.png").string() + "\n",
		Options.bJson);
	if (bPage && !Options.bJson)
	{
		PrintPage(Folder / "sweep.html");
	}
	return ExitDone;
}

int Submit(const FSweepSubmitOptions& Options)
{
	FSubmitRequest Request = Options.Request;
	const auto& Names = GetSweepEngineNames();
	Request.Engine = static_cast<ESweepEngine>(std::ranges::find(Names, Options.Engine) - Names.begin());
	const FSweepFolder Folder(Request.Folder);
	const FSweepPlan Plan = Folder.ReadPlan();
	const FSubmitResult Result = CallWithSweepBar(Folder, Plan, [&] { return SubmitSweep(Request); });
	if (!Result.bWaited)
	{
		PrintResult(Result.Said + "`drydock sweep status " + Request.Folder + "` tells how far it is\n");
		return ExitDone;
	}
	const FSweepStatus Status = FindSweepStatus(Folder, Plan);
	if (!Status.IsComplete())
	{
		PrintResult(MakeStatusText(Status, GetOutputWidth(), false) + ListLines(Result.Failures));
		return ExitPolicy;
	}
	return ReduceResults({Request.Folder, "on", false});
}

} // namespace

FVerbCall AddSweepSubmitOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSweepSubmitOptions>();
	FSubmitRequest& Request = Options->Request;
	Verb.Add("DIR", Request.Folder, "Folder of the plan").Require();
	Verb.Add("OPTION", Request.Options,
		"Behind --: options of the engine's own, such as --sshlogin node1,node2 of parallel, --partition=long of sbatch");
	Verb.Add("--engine", Options->Engine,
			"What runs the shards: processes here, then the page (default); GNU parallel, then the page; or a Slurm job "
			"array and a job for the page")
		.RequireOneOf(GetSweepEngineNames());
	Verb.Add("--shards", Request.NumShards,
			"Number of shards; by default as many as cores here, else about ten minutes each")
		.RequireRange(1, 1'000'000)
		.SetType("N");
	return CallWith(Options, Submit);
}

FVerbCall AddSweepReduceOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSweepReduceOptions>();
	Verb.Add("DIR", Options->Folder, "Folder of the plan").Require();
	AddReport(Verb, Options->Report, "sweep.html, the table with its pictures and plots");
	Verb.AddFlag("--json", Options->bJson, "Print table.json");
	return CallWith(Options, ReduceResults);
}

} // namespace Drydock
