// `drydock run`. Source: drydock.
#include "Program/ProgressBar.h"
#include "Config/ReadConfig.h"
#include "Program/Verbs.h"
#include "Run/CostModel.h"
#include "Run/Run.h"
#include "Run/RunOutputs.h"
#include "Text/WatchedFiles.h"

#include "Budget/RunOptions.h"
#include "ShaderCompilation.h"
#include "Text/ConfigErrors.h"

#include <chrono>
#include <cstdio>
#include <thread>

namespace Drydock
{

namespace
{

int RunOnce(const FVerbOptions& Options)
{
	FProgressBar Bar;
	FRunOptions RunOptions = Options.Run;
	RunOptions.Progress = [&](int Done, int Total, const std::string& Pass)
	{
		Bar.Show(Done, Total, Pass);
	};
	const FRunResult Result = RunConfig(RunOptions);
	Bar.Clear();
	PrintDiagnostics(Result.Diagnostics);
	const std::string Folder =
		Options.OutputFolder.empty() ? GetDefaultOutputFolder(Options.Run.ConfigFile) : Options.OutputFolder;
	const double SaveMs = WriteRunOutputs(Result, Folder);
	FCostModel Costs = FCostModel::Load();
	Costs.Learn(Result);
	Costs.Save();
	std::fputs((Options.bJson ? Result.RunJson : MakeRunSummary(Result, Folder, SaveMs)).c_str(), stdout);
	std::fflush(stdout);
	for (const std::string& Line : MakeClosingLines(Result.Effects))
	{
		std::fprintf(stderr, "%s\n", Line.c_str());
	}
	return ExitDone;
}

/** What a run of the config reads: itself, its scene, its plugins, and every shader file there is. */
FWatchedFiles GetWatchedFiles(const FVerbOptions& Options)
{
	FWatchedFiles Files;
	Files.AddFile(Options.Run.ConfigFile);
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
			Files.AddFile(Config.Resolve(Plugin.Value));
		}
	}
	catch (const FError&)
	{
		// The config itself is watched: it may come back.
	}
	Files.AddShaders();
	return Files;
}

[[noreturn]] void Watch(const FVerbOptions& Options)
{
	constexpr std::chrono::milliseconds Interval(200);
	for (;;)
	{
		const FWatchedFiles Before = GetWatchedFiles(Options);
		try
		{
			RunOnce(Options);
		}
		catch (const FError& Error)
		{
			PrintDiagnostics(Error.GetDiagnostics());
		}
		std::fputs("watching; Ctrl+C ends it\n", stderr);
		while (GetWatchedFiles(Options) == Before)
		{
			std::this_thread::sleep_for(Interval);
		}
		ForgetShaders();
	}
}

/** Asked for on the command line, or by the config where the command line names no frame. */
bool IsSequence(const FVerbOptions& Options)
{
	if (!Options.Frames.empty() || Options.Run.Frame || Options.bWatch)
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

} // namespace

int RunVerb(const FVerbOptions& Options)
{
	if (IsSequence(Options))
	{
		return RunSequenceVerb(Options);
	}
	if (Options.bRestart || !Options.Video.empty())
	{
		FDiagnostic Diagnostic;
		Diagnostic.Code = ErrorBadArgument;
		Diagnostic.Where = Options.bRestart ? "--restart" : "--video";
		Diagnostic.Message =
			"is about the frames of a sequence: name them with --frames, or in the config's scene.frames";
		throw FError(Diagnostic, ExitUsage);
	}
	if (Options.bWatch)
	{
		Watch(Options);
	}
	return RunOnce(Options);
}

} // namespace Drydock
