// Starts a child process, reads what it prints, and stops it when its time is over.
#include "ChildProcess.h"

#include "EndAction.h"
#include "TextTools.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <poll.h>
#include <spawn.h>
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

/** Starts a program in a process group; 0: a new one. Its stdin and its output: -1 is /dev/null. 0, or why not. */
int Spawn(const std::vector<std::string>& Arguments, char* const* Environment, pid_t Group, int Input, int Output,
	pid_t& OutProcess)
{
	const std::vector<char*> Pointers = GetPointers(Arguments);
	posix_spawn_file_actions_t Actions;
	posix_spawn_file_actions_init(&Actions);
	for (const int Stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
	{
		const int From = Stream == STDIN_FILENO ? Input : Output;
		From >= 0 ? posix_spawn_file_actions_adddup2(&Actions, From, Stream)
				  : posix_spawn_file_actions_addopen(&Actions, Stream, "/dev/null", O_RDWR, 0);
	}
	posix_spawnattr_t Attributes;
	posix_spawnattr_init(&Attributes);
	posix_spawnattr_setflags(&Attributes, POSIX_SPAWN_SETPGROUP);
	posix_spawnattr_setpgroup(&Attributes, Group);
	const int Error = posix_spawnp(&OutProcess, Pointers[0], &Actions, &Attributes, Pointers.data(), Environment);
	posix_spawnattr_destroy(&Attributes);
	posix_spawn_file_actions_destroy(&Actions);
	return Error;
}

int WaitFor(pid_t Process)
{
	int Status = 0;
	while (waitpid(Process, &Status, 0) < 0 && errno == EINTR)
	{
	}
	return Status;
}

/** A process group for a child and all that it starts, so that all of it can be ended. A shell in it waits for the end
 * of this process, however that comes, and ends the group then. */
class FProcessGroup : private FNoncopyable
{
public:
	FProcessGroup()
	{
		int Life[2];
		if (pipe2(Life, O_CLOEXEC) == 0)
		{
			const bool bStarted =
				Spawn({"/bin/sh", "-c", "read -r Nothing; kill -KILL 0"}, environ, 0, Life[0], -1, Guard) == 0;
			Guard = bStarted ? Guard : 0;
			close(Life[0]);
			Held = Life[1];
		}
	}
	~FProcessGroup()
	{
		if (Guard != 0)
		{
			kill(Guard, SIGKILL);
			WaitFor(Guard);
		}
		if (Held >= 0)
		{
			close(Held);
		}
	}

	pid_t Guard = 0; // the group has its number; 0: the shell is missing, and the child has a group of its own

private:
	int Held = -1;
};

} // namespace

std::string FChildResult::Describe(int TimeLimitSeconds) const
{
	return !bStarted   ? "could not be started"
		   : bTimedOut ? "took longer than " + std::to_string(TimeLimitSeconds) + " s"
		   : Signal    ? "was ended by signal " + std::to_string(Signal)
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
	const FProcessGroup Group;
	pid_t Child = 0;
	Result.StartError = Spawn(Arguments, GetPointers(Variables).data(), Group.Guard, -1, Pipe[1], Child);
	Result.bStarted = Result.StartError == 0;
	close(Pipe[1]);
	if (Result.bStarted)
	{
		const pid_t All = -(Group.Guard != 0 ? Group.Guard : Child);
		const FEndAction End([All] { kill(All, SIGKILL); }); // a terminal's Ctrl+C does not reach another group
		const auto Deadline = std::chrono::steady_clock::now() + std::chrono::seconds(TimeLimitSeconds);
		Result.bTimedOut = !ReadAll(Pipe[0], Deadline, Result.Output);
		if (Result.bTimedOut)
		{
			kill(All, SIGKILL);
		}
		const int Status = WaitFor(Child);
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
	for (const std::string& Folder : SplitText(Path ? Path : "", ':'))
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
