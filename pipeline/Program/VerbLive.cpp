// `drydock live`: the frame of a config in the browser, every setting a control, every change a new picture.
#include "Config/ReadConfig.h"
#include "EndAction.h"
#include "Live/LiveKeeper.h"
#include "Live/LiveServer.h"
#include "PostProcessSettingsReflection.h"
#include "Program/ProgramFailure.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Run/RunOutputs.h"
#include "TemporaryFolder.h"
#include "Text/ConfigErrors.h"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"

#include <cstdlib>
#include <fcntl.h>
#include <malloc.h>
#include <memory>
#include <spawn.h>
#include <thread>
#include <unistd.h>

namespace Drydock
{

namespace
{

struct FLiveVerbOptions
{
	FRunOptions Run;
	std::string OutputFolder;
	std::string Replay; // record of a session; empty: none
	int Port = 0;
	bool bNoOpen = false;
	bool bNoReuse = false;
};

/** A value of the command line as JSON: as it is where it is JSON, else as text. */
std::string MakeJsonValue(const std::string& Text)
{
	std::vector<FDiagnostic> Faults;
	bool bSyntaxError = false;
	ParseJson(Text, "", Faults, bSyntaxError);
	return bSyntaxError || !Faults.empty() ? FJsonWriter::Quote(Text) : Text;
}

FConfigEdit MakeArgumentEdit(const std::string& Place, const std::string& Argument, const char* Option)
{
	const size_t Equals = Argument.find('=');
	if (Equals == std::string::npos || Equals == 0 || Argument.find_first_of("/~") < Equals)
	{
		throw BadArgument("'" + Argument + "' is not NAME=VALUE", Option);
	}
	return {Place + Argument.substr(0, Equals), MakeJsonValue(Argument.substr(Equals + 1))};
}

/** The command line as edits of the config. */
std::vector<FConfigEdit> MakeEdits(const FRunOptions& Options)
{
	std::vector<FConfigEdit> Edits;
	for (const std::string& Variable : Options.Variables)
	{
		Edits.push_back(MakeArgumentEdit("/cvars/", Variable, "--set"));
	}
	for (const std::string& Setting : Options.Settings)
	{
		Edits.push_back(MakeArgumentEdit("/camera/Settings/", Setting, "--pp"));
	}
	if (!Options.Engine.empty())
	{
		Edits.push_back({"/engine", FJsonWriter::Quote(Options.Engine)});
	}
	return Edits;
}

FEditHistory BeginHistory(const FLiveVerbOptions& Options)
{
	const std::string Text = ReadTextFile(Options.Run.ConfigFile, "the config cannot be opened");
	const FConfigDocument Document = ParseConfigDocument(Text, Options.Run.ConfigFile);
	if (Document.bSyntaxError || HasErrors(Document.Diagnostics))
	{
		throw FError(Document.Diagnostics, ExitUsage);
	}
	return FEditHistory(Options.Run.ConfigFile, ApplyEdits(Text, MakeEdits(Options.Run)));
}

/** Asks the system to show the address; nothing where there is no display. The address goes by a file that only the
 * user can read: everybody on the machine sees the arguments of a program. */
void OpenBrowser(const std::string& Address, const FTemporaryFolder& Folder)
{
	const std::string File = Folder.WriteFile("live.html", "<!doctype html><meta charset=\"utf-8\"><title>drydock "
														   "live</title><meta http-equiv=\"refresh\" content=\"0;url=" +
															   Address + "\">\n");
	posix_spawn_file_actions_t Actions;
	posix_spawnattr_t Attributes;
	posix_spawn_file_actions_init(&Actions);
	posix_spawnattr_init(&Attributes);
	posix_spawn_file_actions_addopen(&Actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
	posix_spawn_file_actions_addopen(&Actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
	posix_spawn_file_actions_adddup2(&Actions, STDOUT_FILENO, STDERR_FILENO);
	posix_spawnattr_setflags(&Attributes, POSIX_SPAWN_SETSID);
	std::string Name = "xdg-open";
	char* const Arguments[] = {Name.data(), const_cast<char*>(File.c_str()), nullptr};
	pid_t Child = 0;
	posix_spawnp(&Child, Name.c_str(), &Actions, &Attributes, Arguments, environ);
	posix_spawnattr_destroy(&Attributes);
	posix_spawn_file_actions_destroy(&Actions);
}

bool HasDisplay()
{
	const auto IsSet = [](const char* Name)
	{
		const char* const Value = std::getenv(Name);
		return Value != nullptr && *Value != '\0';
	};
	return IsSet("DISPLAY") || IsSet("WAYLAND_DISPLAY");
}

FLiveOptions MakeLiveOptions(const FLiveVerbOptions& Options, const std::string& ConfigFile)
{
	FLiveOptions Made{.Run = Options.Run,
		.OutputFolder = Options.OutputFolder,
		.Explain = [](const std::exception_ptr& Thrown)
		{
			return ExplainFailure(Thrown);
		}};
	Made.Run.ConfigFile = ConfigFile;
	Made.bReuse = !Options.bNoReuse;
	Made.Run.Variables.clear(); // the state has them
	Made.Run.Settings.clear();
	Made.Run.Engine.clear();
	return Made;
}

int ServePage(const FLiveVerbOptions& Options, const std::string& Folder)
{
	// A frame's memory goes to the next frame, not to the system and back, which takes milliseconds.
	mallopt(M_MMAP_THRESHOLD, 32 << 20);
	mallopt(M_TRIM_THRESHOLD, 1 << 30);
	const FLiveBefore Before = BeginKept(Folder);
	FLiveOptions LiveOptions = MakeLiveOptions(Options, Options.Run.ConfigFile);
	LiveOptions.Crash = Before.Crash;
	LiveOptions.OnFrame = [&Folder](const FEditHistory& Shown)
	{
		KeepHistory(Folder, Shown);
	};
	FLiveEvents Events;
	FLivePictures Pictures;
	FLiveSession Session(LiveOptions, Before.History ? *Before.History : BeginHistory(Options), Events, Pictures);
	Session.BeginRun(); // mistakes of the config, before anything starts
	FLiveServer Server(Session, Events, Pictures, Before.Port > 0 ? Before.Port : Options.Port, Before.Token);
	const FEndAction SayBye(
		[&Events]
		{
			Events.Close();
			std::this_thread::sleep_for(std::chrono::milliseconds(50)); // until it is sent
		});
	std::optional<FTemporaryFolder> OfBrowser;
	if (Before.Port == 0)
	{
		KeepAddress(Folder, Server.GetPort(), Server.GetToken());
		PrintResult("live     " + Server.GetAddress() + "\n");
		FlushOutput();
		if (!Options.bNoOpen && HasDisplay())
		{
			OpenBrowser(Server.GetAddress(), OfBrowser.emplace());
		}
	}
	Server.Serve();
	return ExitDone;
}

/** The last state of a recorded session, as `drydock run` would run it. */
int ReplaySession(const FLiveVerbOptions& Options)
{
	if (!MakeEdits(Options.Run).empty())
	{
		throw BadArgument("the session is replayed as it was: leave out --set, --pp and --engine", "--replay");
	}
	const FEditHistory History = FEditHistory::Replay(
		ReadTextFile(Options.Replay, "the record cannot be opened", MaxBinaryBytes), Options.Replay);
	const std::string ConfigFile = Options.Run.ConfigFile.empty() ? History.GetFile() : Options.Run.ConfigFile;
	FRunOptions RunOptions = MakeLiveOptions(Options, ConfigFile).Run;
	RunOptions.ConfigText = History.GetText();
	const FRunResult Result = RunConfig(RunOptions);
	PrintDiagnostics(Result.Diagnostics);
	const std::string Folder = ChooseOutputFolder(Options.OutputFolder, RunOptions);
	WriteRunOutputs(Result, Folder);
	PrintResult("replayed " + Folder + "\n");
	return ExitDone;
}

int Live(const FLiveVerbOptions& Options)
{
	if (!Options.Replay.empty())
	{
		return ReplaySession(Options);
	}
	if (Options.Run.ConfigFile.empty())
	{
		throw BadArgument("is required: a JSON config, or --replay with the record of a session", "CONFIG");
	}
	const char* const Folder = FindLiveFolder();
	return Folder == nullptr ? KeepLive() : ServePage(Options, Folder);
}

} // namespace

FVerbCall AddLiveOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FLiveVerbOptions>();
	Verb.Add("CONFIG", Options->Run.ConfigFile, "JSON config, such as configs/toon_bloom.json");
	Verb.Add("--port", Options->Port, "Port of 127.0.0.1; 0: a free one (default)").RequireRange(0, 65535).SetType("N");
	Verb.AddFlag("--no-open", Options->bNoOpen, "Print the address, and open no browser");
	Verb.AddFlag("--no-reuse", Options->bNoReuse,
		"Run all passes of each frame, also those that no change reaches: slower, the same bits");
	Verb.Add("--out", Options->OutputFolder,
			"Folder in which configs may be saved, too; with --replay the folder for the outputs, by default out/NAME "
			"of "
			"the config")
		.SetType("DIR");
	Verb.Add("--replay", Options->Replay,
			"Run the last state of a recorded session and write its outputs, without a browser; CONFIG is not needed")
		.SetType("FILE");
	Verb.AddRepeated("--set", "r.NAME=VALUE", Options->Run.Variables,
		"Begin with a console variable; repeats; the config has it then");
	Verb.AddRepeated("--pp", "SETTING=VALUE", Options->Run.Settings,
		"Begin with a post-process setting of the camera; repeats; the config has it then");
	Verb.Add("--engine", Options->Run.Engine, "Begin with this engine version; the config has it then")
		.SetType("VERSION");
	AddThreads(Verb, Options->Run, "Number of threads; 0: all cores (default). Every number gives the same bits");
	AddTrust(Verb, Options->Run);
	return CallWith(Options, Live);
}

} // namespace Drydock
