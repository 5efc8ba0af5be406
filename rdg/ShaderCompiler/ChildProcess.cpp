// Starts a child process, reads what it prints, and stops it when its time is over.
#include "ChildProcess.h"

#include "EndAction.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace Drydock
{

namespace
{

constexpr size_t MaxOutput = 1u << 20;

/** Reads until the pipe closes or the time is over; true when it closed. */
bool ReadAll(int Pipe, std::chrono::steady_clock::time_point Deadline, std::string& Output)
{
	char Buffer[4096];
	for (;;)
	{
		const auto Left =
			std::chrono::duration_cast<std::chrono::milliseconds>(Deadline - std::chrono::steady_clock::now()).count();
		if (Left <= 0)
		{
			return false;
		}
		pollfd Poll{Pipe, POLLIN, 0};
		if (poll(&Poll, 1, int(Left)) <= 0)
		{
			continue;
		}
		const ssize_t Count = read(Pipe, Buffer, sizeof(Buffer));
		if (Count == 0 || (Count < 0 && errno != EINTR && errno != EAGAIN))
		{
			return true;
		}
		if (Count > 0 && Output.size() < MaxOutput)
		{
			Output.append(Buffer, size_t(Count));
		}
	}
}

/** For the functions of C: pointers to the texts, and a null at the end. */
std::vector<char*> GetPointers(const std::vector<std::string>& Texts)
{
	std::vector<char*> Pointers;
	for (const std::string& Text : Texts)
	{
		Pointers.push_back(const_cast<char*>(Text.c_str()));
	}
	Pointers.push_back(nullptr);
	return Pointers;
}

/** Changed, and of the own environment what that does not name. */
std::vector<std::string> MakeEnvironment(const std::vector<std::string>& Changed)
{
	std::vector<std::string> All = Changed;
	for (char** Entry = environ; *Entry; ++Entry)
	{
		const std::string Text = *Entry;
		const std::string Name = Text.substr(0, Text.find('=')) + "=";
		const bool bChanged = std::any_of(
			Changed.begin(), Changed.end(), [&Name](const std::string& One) { return One.starts_with(Name); });
		if (!bChanged)
		{
			All.push_back(Text);
		}
	}
	return All;
}

} // namespace

std::string FChildResult::Describe(int TimeLimitSeconds) const
{
	if (!bStarted)
	{
		return "could not be started";
	}
	if (bTimedOut)
	{
		return "took longer than " + std::to_string(TimeLimitSeconds) + " s";
	}
	return Signal ? "was ended by signal " + std::to_string(Signal)
				  : "ended with exit code " + std::to_string(ExitCode);
}

FChildResult RunChild(
	const std::vector<std::string>& Arguments, int TimeLimitSeconds, const std::vector<std::string>& Environment)
{
	FChildResult Result;
	int Pipe[2];
	if (Arguments.empty() || pipe2(Pipe, O_CLOEXEC) != 0)
	{
		Result.StartError = Arguments.empty() ? EINVAL : errno;
		return Result;
	}
	const std::vector<std::string> Variables = MakeEnvironment(Environment);
	const std::vector<char*> ArgumentPointers = GetPointers(Arguments);
	const std::vector<char*> VariablePointers = GetPointers(Variables);
	posix_spawn_file_actions_t Actions;
	posix_spawn_file_actions_init(&Actions);
	posix_spawn_file_actions_addopen(&Actions, 0, "/dev/null", O_RDONLY, 0);
	posix_spawn_file_actions_adddup2(&Actions, Pipe[1], 1);
	posix_spawn_file_actions_adddup2(&Actions, Pipe[1], 2);
	posix_spawnattr_t Attributes;
	posix_spawnattr_init(&Attributes);
	posix_spawnattr_setflags(&Attributes, POSIX_SPAWN_SETPGROUP); // its own group, so that all of it can be ended
	posix_spawnattr_setpgroup(&Attributes, 0);
	pid_t Child = 0;
	Result.StartError = posix_spawnp(
		&Child, ArgumentPointers[0], &Actions, &Attributes, ArgumentPointers.data(), VariablePointers.data());
	Result.bStarted = Result.StartError == 0;
	posix_spawnattr_destroy(&Attributes);
	posix_spawn_file_actions_destroy(&Actions);
	close(Pipe[1]);
	if (Result.bStarted)
	{
		const FEndAction End([Child] { kill(-Child, SIGKILL); }); // a terminal's Ctrl+C does not reach another group
		const auto Deadline = std::chrono::steady_clock::now() + std::chrono::seconds(TimeLimitSeconds);
		Result.bTimedOut = !ReadAll(Pipe[0], Deadline, Result.Output);
		if (Result.bTimedOut)
		{
			kill(-Child, SIGKILL);
		}
		int Status = 0;
		while (waitpid(Child, &Status, 0) < 0 && errno == EINTR)
		{
		}
		Result.Signal = WIFSIGNALED(Status) ? WTERMSIG(Status) : 0;
		Result.ExitCode = WIFEXITED(Status) ? WEXITSTATUS(Status) : 0;
		Result.bStarted = Result.ExitCode != 127; // an older posix_spawn reports a missing program this way
		Result.StartError = Result.bStarted ? 0 : ENOENT;
	}
	close(Pipe[0]);
	return Result;
}

std::string FindProgram(const std::string& Name)
{
	if (Name.empty())
	{
		return {};
	}
	if (Name.find('/') != std::string::npos)
	{
		return access(Name.c_str(), X_OK) == 0 && !std::filesystem::is_directory(Name) ? Name : std::string();
	}
	const char* Path = std::getenv("PATH");
	std::istringstream Folders(Path ? Path : "");
	std::string Folder;
	while (std::getline(Folders, Folder, ':'))
	{
		const std::string Candidate = (Folder.empty() ? "." : Folder) + "/" + Name;
		if (access(Candidate.c_str(), X_OK) == 0 && !std::filesystem::is_directory(Candidate))
		{
			return Candidate;
		}
	}
	return {};
}

} // namespace Drydock
