// Starts the process again with the edits that its last good frame had.
#include "Live/LiveKeeper.h"

#include "EndAction.h"
#include "Live/LiveErrors.h"
#include "PrintText.h"
#include "TemporaryFolder.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
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

/** By its name, under which people find it among processes; where it was replaced meanwhile, as it runs here. */
std::string FindOwnProgram()
{
	const std::string Own = "/proc/self/exe";
	std::error_code Error;
	const std::filesystem::path Named = std::filesystem::read_symlink(Own, Error);
	return !Error && std::filesystem::equivalent(Named, Own, Error) ? Named.string() : Own;
}

/** A child that runs this program; its stderr comes through a pipe. */
class FKept
{
public:
	explicit FKept(const std::string& Folder)
	{
		std::vector<std::string> Arguments;
		std::string Line;
		if (FILE* const File = std::fopen("/proc/self/cmdline", "re"))
		{
			for (int C; (C = std::fgetc(File)) != EOF;)
			{
				Line += static_cast<char>(C);
			}
			std::fclose(File);
		}
		Arguments = SplitText(Line, '\0');
		std::vector<char*> Pointers;
		for (std::string& Argument : Arguments)
		{
			Pointers.push_back(Argument.data());
		}
		Pointers.push_back(nullptr);
		setenv(FolderVariable, Folder.c_str(), 1);
		int Pipe[2] = {-1, -1};
		posix_spawn_file_actions_t Actions;
		posix_spawn_file_actions_init(&Actions);
		if (pipe2(Pipe, O_CLOEXEC) == 0)
		{
			posix_spawn_file_actions_adddup2(&Actions, Pipe[1], STDERR_FILENO);
			const int Fault =
				posix_spawn(&Process, FindOwnProgram().c_str(), &Actions, nullptr, Pointers.data(), environ);
			Process = Fault == 0 ? Process : -1;
			close(Pipe[1]);
			Errors = Pipe[0];
		}
		posix_spawn_file_actions_destroy(&Actions);
		unsetenv(FolderVariable);
		if (Process <= 0)
		{
			throw FError({.Code = ErrorNoServer, .Message = "this program cannot start itself"}, ExitFiles);
		}
	}

	~FKept() { close(Errors); }
	FKept(const FKept&) = delete;
	FKept& operator=(const FKept&) = delete;

	/** Waits for its end, and passes on what it says. Returns the exit code, as shells have it. */
	int Wait(std::string& OutLastLine) const
	{
		std::string Said;
		char Bytes[4096];
		for (ssize_t Count; (Count = read(Errors, Bytes, sizeof(Bytes))) > 0 || (Count < 0 && errno == EINTR);)
		{
			if (Count > 0)
			{
				const std::string Part(Bytes, static_cast<size_t>(Count));
				PrintText(stderr, Part);
				Said =
					(Said + Part).substr(Said.size() + Part.size() > MaxSaid ? Said.size() + Part.size() - MaxSaid : 0);
			}
		}
		int Status = 0;
		while (waitpid(Process, &Status, 0) < 0 && errno == EINTR)
		{
		}
		const std::vector<std::string> Lines = SplitText(Trim(Said));
		OutLastLine = Lines.empty() ? "" : Lines.back();
		return WIFEXITED(Status) ? WEXITSTATUS(Status) : 128 + WTERMSIG(Status);
	}

	pid_t GetProcess() const { return Process; }

private:
	static constexpr size_t MaxSaid = 10'000;

	pid_t Process = -1;
	int Errors = -1;
};

} // namespace

FLiveKeep::FLiveKeep(std::string InFolder)
	: Folder(std::move(InFolder))
{
	prctl(PR_SET_PDEATHSIG, SIGTERM); // it does not outlive the one that keeps it
}

std::optional<FLiveKeep::FDoor> FLiveKeep::ReadDoor() const
{
	const std::vector<std::string> Parts = SplitText(ReadIfAny(GetFile("door")), ' ');
	return Parts.size() == 2 ? std::optional(FDoor{std::stoi(Parts[0]), Parts[1]}) : std::nullopt;
}

void FLiveKeep::WriteDoor(const FDoor& Door) const
{
	WriteWholeFile(GetFile("door"), std::to_string(Door.Port) + " " + Door.Token);
}

std::optional<FEditHistory> FLiveKeep::ReadHistory() const
{
	const std::string Record = ReadIfAny(GetFile("before"));
	return Record.empty() ? std::nullopt : std::optional(FEditHistory::Replay(Record, "the record of this session"));
}

std::string FLiveKeep::ReadCrash() const
{
	return ReadIfAny(GetFile("crash"));
}

void FLiveKeep::Write(const FEditHistory& History) const
{
	WriteTextFile(GetFile("well"), History.GetRecord());
}

const char* FindLiveFolder()
{
	return std::getenv(FolderVariable);
}

int KeepLive()
{
	const FTemporaryFolder Temporary;
	const std::string Folder = Temporary.Reserve("live");
	std::filesystem::create_directory(Folder);
	while (true)
	{
		const FKept Kept(Folder);
		const FEndAction EndKept(
			[Process = Kept.GetProcess()]
			{
				kill(Process, SIGTERM);
				waitpid(Process, nullptr, 0);
			});
		std::string LastLine;
		const int ExitCode = Kept.Wait(LastLine);
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
