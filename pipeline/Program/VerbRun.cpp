// `drydock run`: runs a frame, or the frames of a sequence, and writes pictures and reports.
#include "Config/ReadConfig.h"
#include "DispatchReuse.h"
#include "Inspect/FirstCause.h"
#include "PrintText.h"
#include "Program/FindingsOption.h"
#include "Program/InspectOptions.h"
#include "Program/ProgramOutput.h"
#include "Program/ProgressBar.h"
#include "Program/ReportOption.h"
#include "Program/RunFrames.h"
#include "Program/RunSummary.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Program/WatchLoop.h"
#include "Report/RunReport.h"
#include "Run/CostModel.h"
#include "Run/PassesCsv.h"
#include "Run/Run.h"
#include "Run/RunAgain.h"
#include "Run/RunFiles.h"
#include "Run/RunOutputs.h"
#include "Run/ShaderWarnings.h"
#include "SceneFile/SceneCache.h"
#include "Text/ConfigErrors.h"
#include "Text/TextFile.h"

#include <chrono>
#include <ctime>
#include <cstdio>
#include <memory>
#include <optional>
#include <thread>

namespace Drydock
{

namespace
{

struct FRunVerbOptions : FFramesOptions
{
	FFindingsOptions Findings;
	std::string Csv;       // file to write; empty: none
	bool bWatch = false;   // run again whenever something changes
	bool bNoReuse = false; // with bWatch: compute every pass again
	std::string Again;     // run.json of a run to repeat; empty: none
	FRunInputs Before;     // that it depended on
	FInspectVerbOptions Inspect;
};

/** CPU time so far: loading libraries and registering what registers itself, which nothing waits for. */
double GetStartMilliseconds()
{
	return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/** If the passes themselves made NaN or infinity in the picture, the messages name the line that made it. */
FRunResult RunToFirstCause(FRunSession& Session, const FRunOptions& Options)
{
	if (!GetDispatchObservers().empty())
	{
		return Session.Run(std::nullopt, {}); // somebody looks already
	}
	try
	{
		FRunResult Result = Session.Run(std::nullopt, {});
		if (MadeNonFinite(Result.Diagnostics))
		{
			const std::vector<FDiagnostic> Cause = FindFirstCause(Options);
			Result.Diagnostics.insert(Result.Diagnostics.end(), Cause.begin(), Cause.end());
		}
		return Result;
	}
	catch (const FError& Error)
	{
		if (!MadeNonFinite(Error.GetDiagnostics()))
		{
			throw;
		}
		std::vector<FDiagnostic> All = FindFirstCause(Options);
		All.insert(All.begin(), Error.GetDiagnostics().begin(), Error.GetDiagnostics().end());
		throw FError(std::move(All), Error.GetExitCode());
	}
}

int RunOnce(const FRunVerbOptions& Options)
{
	const EReport Report =
		ChooseRunReport(Options.Report, Options.Run.ConfigFile, !Options.bWatch && WantsReport("", Options.bJson));
	FProgressBar Bar;
	FRunOptions RunOptions = Options.Run;
	RunOptions.bRecordInputs = !Options.bWatch;
	RunOptions.bKeepForReport = Report != EReport::Off;
	RunOptions.Progress = [&](int Done, int Total, const std::string& Pass)
	{
		Bar.Show(Done, Total, Pass);
	};
	const std::string Folder = ChooseOutputFolder(Options.OutputFolder, Options.Run);
	std::optional<FOutputFolder> Output;
	FRunInspection Inspection(MakeInspectOptions(Options.Inspect, Options.Run));
	const FShaderWarnings Warnings;
	std::vector<FDiagnostic> Warned; // found while overlays and plugins are there
	const FRunResult Result = [&]
	{
		FRunSession Session(RunOptions);
		Output.emplace(Folder, GetRunOutputNames()); // after mistakes of the config, before the work
		std::optional<FScopedDispatchObserver> Observed;
		if (!Inspection.IsEmpty())
		{
			Observed.emplace(Inspection);
		}
		try
		{
			FRunResult Done = RunToFirstCause(Session, RunOptions);
			Warned = Warnings.Find();
			return Done;
		}
		catch (const FError&)
		{
			PrintDiagnostics(Warnings.Find()); // the cause may be among them
			throw;
		}
	}();
	Bar.Clear();
	PrintDiagnostics(Warned);
	PrintDiagnostics(Result.Diagnostics);
	PrintDiagnostics(Options.Again.empty() ? std::vector<FDiagnostic>()
										   : FindChangedInputs(Options.Before, Result.Inputs, Options.Again));
	PrintDiagnostics(Inspection.GetDiagnostics());
	const std::string Seen = Inspection.Write(Output->GetAside(), GetOutputWidth());
	std::optional<double> PageMs;
	const FFurtherOutputs AddReport = [&](const std::filesystem::path& Aside, double SaveMs)
	{
		const auto Begin = std::chrono::steady_clock::now();
		WriteRunReport(Options.Run, Result, Report, Output->GetPath(), Aside, SaveMs);
		PageMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Begin).count();
	};
	const double SaveMs =
		WriteRunOutputs(Result, *Output, Report != EReport::Off ? AddReport : FFurtherOutputs(nullptr));
	if (!Options.Csv.empty())
	{
		WriteTextFile(Options.Csv, MakePassesCsv(Result));
	}
	Output.reset();           // whoever watches for the summary may start the next run
	if (Inspection.IsEmpty()) // else its times are the interpreter's
	{
		FCostModel Costs = FCostModel::Load();
		Costs.Learn(Result);
		Costs.Save();
	}
	Options.bJson ? PrintText(stderr, Seen) : PrintResult(Seen);
	PrintResult(Options.bJson ? Result.RunJson : MakeRunSummary(Result, Folder, SaveMs, PageMs, GetOutputWidth()),
		Options.bJson);
	if (Report != EReport::Off && !Options.bJson)
	{
		PrintPage(std::filesystem::path(Folder) / "report.html");
	}
	std::fflush(stdout); // before the closing lines, where both go to one terminal
	PrintClosingLines(Result.Effects);
	return ExitDone;
}

/** Until somebody ends the program. */
int Watch(const FRunVerbOptions& Options)
{
	constexpr std::chrono::milliseconds Interval(200);
	FRunVerbOptions Looked = Options;
	Looked.Run.WriteByDefault = {EOutputKind::Png};
	Looked.Run.SceneCache = std::make_shared<FSceneCache>();
	Looked.Run.ReuseCache = Options.bNoReuse ? nullptr : std::make_shared<FReuseCache>();
	RunWatchLoop({.Run =
					  [&]
				  {
					  RunOnce(Looked);
					  FlushOutput();
				  },
		.List = [&] { return FindRunFiles(Options.Run); },
		.Wait =
			[&]
		{
			std::this_thread::sleep_for(Interval);
			return true;
		}});
	return ExitDone;
}

/** Asked for on the command line, or by the config where the command line names no frame. */
bool IsSequence(const FRunVerbOptions& Options)
{
	if (!Options.Frames.empty() || Options.Run.Frame || Options.bWatch || Options.Inspect.IsAsked())
	{
		return !Options.Frames.empty();
	}
	try
	{
		std::vector<FDiagnostic> Ignored; // the run reports them
		return LoadConfig(Options.Run.ConfigFile, Ignored).Scene.Frames.IsSet();
	}
	catch (const FError&)
	{
		return false;
	}
}

/** The options of a run by its run.json: as it was. */
FRunVerbOptions TakeAgain(const FRunVerbOptions& Options)
{
	FRunVerbOptions Again = Options;
	if (Options.Again.empty())
	{
		if (Options.Run.ConfigFile.empty())
		{
			throw BadArgument("is required: a JSON config, or --again with a run.json", "CONFIG");
		}
		return Again;
	}
	FConfig Nowhere;
	Nowhere.File = "config.json";
	const std::vector<std::string> Added = ListRunArguments(Options.Run, Nowhere);
	if (!Added.empty() || !Options.Frames.empty())
	{
		throw BadArgument(
			"the run is repeated as it was: leave out " + (Added.empty() ? "--frames" : Added.front()), "--again");
	}
	const FRunAgain Read = ReadRunAgain(Options.Again, Options.Run.ConfigFile);
	const std::optional<int> Threads = Options.Run.Threads;
	Again.Run = Read.Options;
	Again.Run.Threads = Threads;
	Again.Run.bNoPlugins = Options.Run.bNoPlugins;
	Again.Before = Read.Inputs;
	return Again;
}

int RunOrWatch(const FRunVerbOptions& Given)
{
	const FRunVerbOptions Options = TakeAgain(Given);
	if (Options.Again.empty() && IsSequence(Options))
	{
		return RunFrames(Options);
	}
	if (Options.bRestart || !Options.Video.empty() || Options.Lead > 0)
	{
		throw BadArgument("needs the frames of a sequence: name them with --frames, or in the config's scene.frames",
			Options.bRestart         ? "--restart"
			: !Options.Video.empty() ? "--video"
									 : "--lead");
	}
	if (Options.bWatch)
	{
		return Watch(Options);
	}
	FRunVerbOptions Once = Options;
	Once.Run.StartMilliseconds = GetStartMilliseconds();
	return RunOnce(Once);
}

} // namespace

FVerbCall AddRunOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FRunVerbOptions>();
	AddConfig(Verb, Options->Run, false);
	Verb.Add("--again", Options->Again,
			"Repeat the run that this run.json records, with its options and the same bits; CONFIG is not needed")
		.SetType("RUN.json");
	AddArithmetic(Verb, Options->Run);
	Verb.Add("--out", Options->OutputFolder, "Folder for the outputs; out/NAME of the config by default")
		.SetType("DIR");
	Verb.Add(
			"--outputs",
			[Options](const std::vector<std::string>& Names) { Options->Run.Write = MakeOutputKinds(Names); },
			"Write these beside run.json: json is timing and trace, dot the graph; all by default, only png with "
			"--watch; overrides the config's outputs.write")
		.RequireSomeOf(GetOutputKindNames());
	Verb.AddRepeated("--dump", "PATTERN", Options->Run.Dump,
		"Keep the matching passes or resources: a pass, a resource or Pass.Resource, with * and ?; repeats");
	Verb.AddFlag("--no-skip", Options->Run.bNoSkip,
		"Run the passes that are not needed too: slower, the same bits; effects that are off stay off");
	Verb.AddFlag("--measure-effects", Options->Run.bMeasureEffects,
		"Measure the effects (bleed of toon bloom, banding of the toon shadow) and add the figures to run.json");
	Verb.AddFlag("--fingerprints", Options->Run.bFingerprints,
		"Add to each pass in run.json a fingerprint of every texture that the pass wrote");
	const FVerbOption Frames =
		Verb.Add("--frames", Options->Frames,
				"Render these frames of a sequence, each with the history of the frame before: all, 1-8, 1-9x2 (every "
				"second) or 1,3,5-8; the config's scene.frames by default. A stopped run resumes")
			.SetType("LIST")
			.Exclude(Verb.Find("--frame"));
	Verb.Add("--lead", Options->Lead,
			"Render this many frames before the first of --frames for their history, and write none of them")
		.RequireRange(0, 1000000)
		.SetType("N");
	Verb.AddFlag("--restart", Options->bRestart, "Render all frames again, even those already in the folder");
	Verb.Add("--video", Options->Video, "Write a video of the frames, such as walk.mp4; needs ffmpeg").SetType("FILE");
	Verb.AddFlag("--watch", Options->bWatch, "Run again whenever the config, its scene, a plugin or a shader changes")
		.Exclude(Frames);
	Verb.AddFlag("--no-reuse", Options->bNoReuse,
		"With --watch: compute every pass again, also those whose shader, parameters and inputs are unchanged; slower, "
		"the same bits");
	Verb.Add("--report", Options->Report,
			"Write report.html, or sequence.html for a sequence: on, off, or full, which adds the values of all "
			"pictures. --report alone means on. It overrides the config's outputs.report. The default is on, but off "
			"with --frames, --watch and --json")
		.SetValueWhereNoneFollows("on")
		.RequireOneOf({"on", "off", "full"});
	AddInspection(Verb, Options->Inspect, Frames);
	Verb.Add(
			"--final",
			[Options](const std::string& Word)
			{
				if (Word == "linear")
				{
					Options->Run.Variables.push_back("r.HDR.Display.OutputDevice=9");
				}
			},
			"Numbers of final.exr: encoded for the output device (default), or linear, the light of the display in "
			"half "
			"floats (r.HDR.Display.OutputDevice 9)")
		.RequireOneOf({"encoded", "linear"});
	Verb.Add("--csv", Options->Csv, "Write a table of the passes and their times for spreadsheets").SetType("FILE");
	AddFindings(Verb, Options->Findings, "a case for the frame");
	Verb.AddFlag("--json", Options->bJson, "Print run.json instead of the summary");
	return [Options]
	{
		return CallWithFindings(Options->Findings, "run", Options->Run.ConfigFile,
			[&Options](FJUnitSuite& Suite)
			{
				Suite.Cases.push_back({.Name = "frame"});
				return RunOrWatch(*Options);
			});
	};
}

} // namespace Drydock
