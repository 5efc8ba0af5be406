// `drydock run`: runs a frame, or the frames of a sequence, and writes pictures and reports.
#include "Config/ReadConfig.h"
#include "Extensions/Plugins.h"
#include "Inspect/FirstCause.h"
#include "PrintText.h"
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
#include "Run/Run.h"
#include "Run/RunOutputs.h"
#include "SceneFile/SceneCache.h"
#include "Text/ConfigErrors.h"
#include "Text/WatchedFiles.h"

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
	bool bWatch = false; // run again whenever something changes
	FInspectVerbOptions Inspect;
};

/** CPU time so far: loading libraries and registering what registers itself, which nothing waits for. */
double GetStartMilliseconds()
{
	return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/** Where the picture has NaN or infinity of the passes' own making, the messages name the line that made it. */
FRunResult RunToFirstCause(FRunSession& Session, const FRunOptions& Options)
{
	if (GetDispatchObserver())
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
	RunOptions.bKeepForReport = Report != EReport::Off;
	RunOptions.Progress = [&](int Done, int Total, const std::string& Pass)
	{
		Bar.Show(Done, Total, Pass);
	};
	const std::string Folder = ChooseOutputFolder(Options.OutputFolder, Options.Run);
	std::optional<FOutputFolder> Output;
	FRunInspection Inspection(MakeInspectOptions(Options.Inspect, Options.Run));
	const FRunResult Result = [&]
	{
		FRunSession Session(RunOptions);
		Output.emplace(Folder, GetRunOutputNames()); // after mistakes of the config, before the work
		std::optional<FScopedDispatchObserver> Observed;
		if (!Inspection.IsEmpty())
		{
			Observed.emplace(Inspection);
		}
		return RunToFirstCause(Session, RunOptions);
	}();
	Bar.Clear();
	PrintDiagnostics(Result.Diagnostics);
	PrintDiagnostics(Inspection.GetDiagnostics());
	const std::string Seen = Inspection.Write(Output->GetAside(), GetOutputWidth());
	const FFurtherOutputs AddReport = [&](const std::filesystem::path& Aside, double SaveMs)
	{
		WriteRunReport(Options.Run, Result, Report, Output->GetPath(), Aside, SaveMs);
	};
	const double SaveMs =
		WriteRunOutputs(Result, *Output, Report != EReport::Off ? AddReport : FFurtherOutputs(nullptr));
	Output.reset();           // whoever watches for the summary may start the next run
	if (Inspection.IsEmpty()) // else its times are the interpreter's
	{
		FCostModel Costs = FCostModel::Load();
		Costs.Learn(Result);
		Costs.Save();
	}
	Options.bJson ? PrintText(stderr, Seen) : PrintResult(Seen);
	PrintResult(
		Options.bJson ? Result.RunJson : MakeRunSummary(Result, Folder, SaveMs, GetOutputWidth()), Options.bJson);
	if (Report != EReport::Off && !Options.bJson)
	{
		PrintPage(std::filesystem::path(Folder) / "report.html");
	}
	std::fflush(stdout); // before the closing lines, where both go to one terminal
	PrintClosingLines(Result.Effects);
	return ExitDone;
}

/** A library, and the ini files of the plugin, which are known once it is loaded. */
void AddPlugin(const std::string& Path, FWatchedFiles& Files)
{
	Files.AddFile(Path);
	for (const std::string& IniFile : FindPluginIniFiles(Path))
	{
		Files.AddFile(IniFile);
	}
}

/** What a run of the config reads: itself, its scene, its plugins, and every shader file there is. */
FWatchedFiles GetWatchedFiles(const FRunVerbOptions& Options)
{
	FWatchedFiles Files;
	Files.AddFile(Options.Run.ConfigFile);
	Files.AddShaders();
	try
	{
		std::vector<FDiagnostic> Ignored;
		const FConfig Config = LoadConfig(Options.Run.ConfigFile, Ignored);
		if (Config.Scene.File.IsSet())
		{
			Files.AddFile(Config.Resolve(Config.Scene.File.Value));
		}
		for (const TConfigValue<std::string>& Plugin : Config.Plugins)
		{
			AddPlugin(Config.Resolve(Plugin.Value), Files);
		}
		for (const std::string& Plugin : Options.Run.Plugins)
		{
			AddPlugin(Plugin, Files);
		}
	}
	catch (const FError&)
	{
		// The config itself is watched: it may come back.
	}
	return Files;
}

/** Until somebody ends the program. */
int Watch(const FRunVerbOptions& Options)
{
	constexpr std::chrono::milliseconds Interval(200);
	FRunVerbOptions Looked = Options;
	Looked.Run.WriteByDefault = {EOutputKind::Png};
	Looked.Run.SceneCache = std::make_shared<FSceneCache>();
	RunWatchLoop({.Run =
					  [&]
				  {
					  RunOnce(Looked);
					  FlushOutput();
				  },
		.List = [&] { return GetWatchedFiles(Options); },
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

int RunOrWatch(const FRunVerbOptions& Options)
{
	if (IsSequence(Options))
	{
		return RunFrames(Options);
	}
	if (Options.bRestart || !Options.Video.empty() || Options.Lead > 0)
	{
		throw FError(
			{.Code = ErrorBadArgument,
				.Message =
					"is about the frames of a sequence: name them with --frames, or in the config's scene.frames",
				.Where = Options.bRestart         ? "--restart"
						 : !Options.Video.empty() ? "--video"
												  : "--lead"},
			ExitUsage);
	}
	if (Options.bWatch)
	{
		return Watch(Options);
	}
	FRunVerbOptions Once = Options;
	Once.Run.StartMilliseconds = GetStartMilliseconds();
	return RunOnce(Once);
}

FVerbCall AddRunOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FRunVerbOptions>();
	AddConfig(Verb, Options->Run);
	AddArithmetic(Verb, Options->Run);
	Verb.Add("--out", Options->OutputFolder, "Folder for the outputs; out/NAME of the config by default")
		.SetType("DIR");
	Verb.Add(
			"--outputs",
			[Options](const std::vector<std::string>& Names) { Options->Run.Write = MakeOutputKinds(Names); },
			"What is written beside run.json: json is timing and trace, dot the graph; all by default, with "
			"--watch png; beats the config's outputs.write")
		.RequireSomeOf(GetOutputKindNames());
	Verb.AddRepeated("--dump", "PATTERN", Options->Run.Dump,
		"Keep what matches: a pass, a resource or Pass.Resource, with * and ?; repeats");
	Verb.AddFlag("--no-skip", Options->Run.bNoSkip,
		"Leave nothing out because nobody needs it: slower, the same bits; what is switched off stays off");
	Verb.AddFlag("--measure-effects", Options->Run.bMeasureEffects,
		"Measure what effects come to (bleed of toon bloom, banding of the toon shadow) and add it to run.json");
	Verb.AddFlag("--fingerprints", Options->Run.bFingerprints,
		"Add to each pass of run.json a fingerprint of every texture that it wrote");
	const FVerbOption Frames =
		Verb.Add("--frames", Options->Frames,
				"Frames of a sequence, each with what lives on from the one before: all, 1-8, 1-9x2 (every second) or "
				"1,3,5-8; the config's scene.frames by default. A run that was stopped goes on where it stood")
			.SetType("LIST")
			.Exclude(Verb.Find("--frame"));
	Verb.Add("--lead", Options->Lead,
			"Frames before the first of --frames that are rendered for what lives on from them, and are not written")
		.RequireRange(0, 1000000)
		.SetType("N");
	Verb.AddFlag("--restart", Options->bRestart, "Render all frames again, whatever the folder holds");
	Verb.Add("--video", Options->Video, "Video of the frames, such as walk.mp4; needs ffmpeg").SetType("FILE");
	Verb.AddFlag("--watch", Options->bWatch, "Run again whenever the config, its scene, a plugin or a shader changes")
		.Exclude(Frames);
	Verb.Add("--report", Options->Report,
			"Write report.html, the page to look at it all, of a sequence sequence.html: on (where no word "
			"follows), "
			"off, or full, with the values of all pictures of a frame; beats the config's outputs.report; on by "
			"default where stdout is a terminal, not under --watch")
		.SetValueWhereNoneFollows("on")
		.RequireOneOf({"on", "off", "full"});
	AddInspection(Verb, Options->Inspect, Frames);
	Verb.AddFlag("--json", Options->bJson, "Print run.json instead of the summary");
	return [Options]
	{
		return RunOrWatch(*Options);
	};
}

const FVerbRegistration GRunRegistration({
	.Name = "run",
	.Place = 10,
	.Group = EVerbGroup::Run,
	.Doc = "Run the frame of a config and write its pictures and reports",
	.AddOptions = AddRunOptions,
});

} // namespace

} // namespace Drydock
