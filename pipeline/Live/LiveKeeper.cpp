// Starts the process again with the edits that its last good frame had.
#include "Live/LiveKeeper.h"

#include "EndAction.h"
#include "Live/LiveErrors.h"
#include "PrintText.h"
#include "TemporaryFolder.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Drydock
{

namespace
{

constexpr const char* FolderVariable = "DRYDOCK_LIVE_FOLDER";

std::string ReadIfAny(const std::string& File)
{
	return TryReadTextFile(File, MaxBinaryBytes).value_or("");
}

/** Starts this program once more, with the same arguments. Errors: its stderr. Throws FError. */
pid_t StartAgain(const std::string& Folder, int Errors)
{
	std::ifstream Stream("/proc/self/cmdline", std::ios::binary);
	std::vector<std::string> Arguments = SplitText(std::string(std::istreambuf_iterator<char>(Stream), {}), '\0');
	std::vector<char*> Pointers;
	for (std::string& Argument : Arguments)
	{
		Pointers.push_back(Argument.data());
	}
	Pointers.push_back(nullptr);
	posix_spawn_file_actions_t Actions;
	posix_spawn_file_actions_init(&Actions);
	posix_spawn_file_actions_adddup2(&Actions, Errors, STDERR_FILENO);
	setenv(FolderVariable, Folder.c_str(), 1);
	pid_t Process = 0;
	const int Fault = posix_spawn(&Process, "/proc/self/exe", &Actions, nullptr, Pointers.data(), environ);
	unsetenv(FolderVariable);
	posix_spawn_file_actions_destroy(&Actions);
	if (Fault != 0)
	{
		throw FError({.Code = ErrorNoServer, .Message = "this program cannot start itself"}, ExitFiles);
	}
	return Process;
}

/** Passes on what comes from a pipe, to its end. Returns the last line. */
std::string PassOn(int Pipe)
{
	constexpr size_t MaxLine = 10'000;
	std::string Said;
	char Bytes[4096];
	for (ssize_t Count; (Count = read(Pipe, Bytes, sizeof(Bytes))) > 0 || (Count < 0 && errno == EINTR);)
	{
		const std::string Part(Bytes, static_cast<size_t>(std::max(Count, ssize_t(0))));
		PrintText(stderr, Part);
		Said += Part;
		Said.erase(0, Said.size() - std::min(Said.size(), MaxLine));
	}
	const std::vector<std::string> Lines = SplitText(Trim(Said));
	return Lines.empty() ? "" : Lines.back();
}

/** Runs the program once more, to its end. Returns its exit code, as shells have it. */
int RunAgain(const std::string& Folder, std::string& OutLastLine)
{
	int Pipe[2] = {-1, -1};
	if (pipe2(Pipe, O_CLOEXEC) != 0)
	{
		throw FError({.Code = ErrorNoServer, .Message = "the system has no pipe for it"}, ExitFiles);
	}
	const pid_t Process = StartAgain(Folder, Pipe[1]);
	close(Pipe[1]);
	const FEndAction End(
		[Process]
		{
			kill(Process, SIGTERM);
			waitpid(Process, nullptr, 0);
		});
	OutLastLine = PassOn(Pipe[0]);
	close(Pipe[0]);
	int Status = 0;
	while (waitpid(Process, &Status, 0) < 0 && errno == EINTR)
	{
	}
	return WIFEXITED(Status) ? WEXITSTATUS(Status) : 128 + WTERMSIG(Status);
}

} // namespace

const char* FindLiveFolder()
{
	return std::getenv(FolderVariable);
}

FLiveBefore BeginKept(const std::string& Folder)
{
	prctl(PR_SET_PDEATHSIG, SIGTERM);
	prctl(PR_SET_NAME, "drydock"); // people look for it among processes
	FLiveBefore Before;
	const std::vector<std::string> Address = SplitText(ReadIfAny(Folder + "/address"), ' ');
	if (Address.size() == 2)
	{
		Before.Port = std::stoi(Address[0]);
		Before.Token = Address[1];
	}
	if (const std::string Record = ReadIfAny(Folder + "/before"); !Record.empty())
	{
		Before.History = FEditHistory::Replay(Record, "the record of this session");
	}
	Before.Crash = ReadIfAny(Folder + "/crash");
	return Before;
}

void KeepAddress(const std::string& Folder, int Port, const std::string& Token)
{
	WriteWholeFile(Folder + "/address", std::to_string(Port) + " " + Token);
}

void KeepHistory(const std::string& Folder, const FEditHistory& History)
{
	WriteWholeFile(Folder + "/writing", History.GetRecord());
	std::filesystem::rename(Folder + "/writing", Folder + "/well");
}

int KeepLive()
{
	const FTemporaryFolder Temporary;
	const std::string Folder = Temporary.Reserve("live");
	std::filesystem::create_directory(Folder);
	while (true)
	{
		std::string LastLine;
		const int ExitCode = RunAgain(Folder, LastLine);
		const bool bAsked = ExitCode == 128 + SIGINT || ExitCode == 128 + SIGTERM || ExitCode == 128 + SIGHUP;
		const bool bCrash = ExitCode == ExitInternal || ExitCode == ExitPlugin || ExitCode > 128;
		std::error_code NoFrame;
		std::filesystem::rename(Folder + "/well", Folder + "/before", NoFrame);
		if (!bCrash || bAsked || NoFrame)
		{
			return ExitCode;
		}
		WriteWholeFile(Folder + "/crash", LastLine);
		PrintText(stderr, "drydock live: starting again with the state before\n");
	}
}

} // namespace Drydock
