// Starts the process with glslang in it, asks it, and finds out how it ended where it does not answer.
#include "FrontEndProcess.h"

#include "FileDescriptor.h"
#include "FrontEndProtocol.h"
#include "InstallPaths.h"
#include "ToolFault.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <mutex>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace Drydock
{

namespace
{

using FTime = std::chrono::steady_clock::time_point;

class FFrontEndProcess
{
public:
	FFrontEndProcess() = default;
	~FFrontEndProcess();
	FFrontEndProcess(const FFrontEndProcess&) = delete;
	FFrontEndProcess& operator=(const FFrontEndProcess&) = delete;

	FFrontEndReply Ask(const std::string& Program, const std::string& Text, const FShaderCompileRequest& Request,
		int TimeLimitSeconds);
	FFrontEndCounts GetCounts();

private:
	int Start(const std::string& Program);
	bool SendRequest(const std::string& Text, const FShaderCompileRequest& Request, int TimeLimitSeconds);
	bool Receive(void* Bytes, size_t Size, FTime Deadline, bool& bTimedOut);
	bool ReceiveReply(FFrontEndReply& Reply, FTime Deadline);
	void End(FChildResult& Child);

	std::mutex Mutex;
	FFileDescriptor Socket;
	pid_t Process = 0; // 0: none
	pid_t Owner = 0;   // who started it; a child that forked off has its own
	FFrontEndCounts Counts;
};

/** The run ends: its time counts as that of a child, and nothing is left. */
FFrontEndProcess::~FFrontEndProcess()
{
	if (Process && Owner == getpid())
	{
		kill(Process, SIGKILL);
		waitpid(Process, nullptr, 0);
	}
}

/** 0, or the error. */
int FFrontEndProcess::Start(const std::string& Program)
{
	int Ends[2];
	if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, Ends) != 0)
	{
		return errno;
	}
	FFileDescriptor Own(Ends[0]);
	const FFileDescriptor Others(Ends[1]);
	posix_spawn_file_actions_t Actions;
	posix_spawn_file_actions_init(&Actions);
	posix_spawn_file_actions_adddup2(&Actions, Others.Get(), 0);
	posix_spawn_file_actions_addopen(&Actions, 1, "/dev/null", O_WRONLY, 0);
	posix_spawn_file_actions_addopen(&Actions, 2, "/dev/null", O_WRONLY, 0);
	char* const Arguments[] = {const_cast<char*>(Program.c_str()), nullptr};
	const int Error = posix_spawn(&Process, Program.c_str(), &Actions, nullptr, Arguments, environ);
	posix_spawn_file_actions_destroy(&Actions);
	if (Error != 0)
	{
		Process = 0;
		return Error;
	}
	Socket = std::move(Own);
	Owner = getpid();
	++Counts.Processes;
	return 0;
}

bool FFrontEndProcess::SendRequest(const std::string& Text, const FShaderCompileRequest& Request, int TimeLimitSeconds)
{
	const FrontEnd::FRequestHead Head = {uint32_t(Request.Stage), Request.bKeepFunctions, uint32_t(TimeLimitSeconds),
		uint32_t(Request.EntryPoint.size()), uint32_t(Text.size())};
	return FrontEnd::Send(Socket.Get(), &Head, sizeof(Head)) &&
		   FrontEnd::Send(Socket.Get(), Request.EntryPoint.data(), Request.EntryPoint.size()) &&
		   FrontEnd::Send(Socket.Get(), Text.data(), Text.size());
}

bool FFrontEndProcess::Receive(void* Bytes, size_t Size, FTime Deadline, bool& bTimedOut)
{
	for (size_t Done = 0; Done < Size;)
	{
		const auto Left = std::chrono::ceil<std::chrono::milliseconds>(Deadline - std::chrono::steady_clock::now());
		bTimedOut = Left.count() <= 0;
		if (bTimedOut)
		{
			return false;
		}
		pollfd Poll{Socket.Get(), POLLIN, 0};
		if (poll(&Poll, 1, int(Left.count())) <= 0)
		{
			continue;
		}
		const ssize_t Count = read(Socket.Get(), static_cast<char*>(Bytes) + Done, Size - Done);
		if (Count == 0 || (Count < 0 && errno != EINTR && errno != EAGAIN))
		{
			return false;
		}
		Done += Count > 0 ? size_t(Count) : 0;
	}
	return true;
}

bool FFrontEndProcess::ReceiveReply(FFrontEndReply& Reply, FTime Deadline)
{
	FrontEnd::FReplyHead Head;
	bool& bTimedOut = Reply.Child.bTimedOut;
	if (!Receive(&Head, sizeof(Head), Deadline, bTimedOut))
	{
		return false;
	}
	Reply.Child.Output.resize(Head.OutputSize);
	Reply.Words.resize(Head.NumWords);
	Reply.Child.ExitCode = Head.bSucceeded ? 0 : 2; // as glslangValidator has it
	return Receive(Reply.Child.Output.data(), Reply.Child.Output.size(), Deadline, bTimedOut) &&
		   Receive(Reply.Words.data(), Reply.Words.size() * sizeof(uint32_t), Deadline, bTimedOut);
}

/** Ends a process that gave no answer, and fills in how it ended. */
void FFrontEndProcess::End(FChildResult& Child)
{
	if (Child.bTimedOut)
	{
		kill(Process, SIGKILL);
	}
	Socket.Close();
	int Status = 0;
	while (waitpid(Process, &Status, 0) < 0 && errno == EINTR)
	{
	}
	Process = 0;
	Child.Signal = WIFSIGNALED(Status) ? WTERMSIG(Status) : 0;
	Child.ExitCode = WIFEXITED(Status) ? WEXITSTATUS(Status) : 0;
}

FFrontEndReply FFrontEndProcess::Ask(
	const std::string& Program, const std::string& Text, const FShaderCompileRequest& Request, int TimeLimitSeconds)
{
	const std::lock_guard Lock(Mutex);
	++Counts.Shaders;
	if (Process && Owner != getpid())
	{
		Socket.Close(); // it answers to the process that this one was forked off
		Process = 0;
	}
	for (;;)
	{
		const bool bKept = Process != 0;
		FFrontEndReply Reply;
		Reply.Child.StartError = bKept ? 0 : Start(Program);
		Reply.Child.bStarted = Reply.Child.StartError == 0;
		if (!Reply.Child.bStarted)
		{
			return Reply;
		}
		const FTime Deadline = std::chrono::steady_clock::now() + std::chrono::seconds(TimeLimitSeconds);
		if (SendRequest(Text, Request, TimeLimitSeconds) && ReceiveReply(Reply, Deadline))
		{
			return Reply;
		}
		End(Reply.Child);
		if (!bKept || Reply.Child.bTimedOut)
		{
			return Reply;
		}
		// One that was kept may have died of something else: a new one tells.
	}
}

FFrontEndCounts FFrontEndProcess::GetCounts()
{
	const std::lock_guard Lock(Mutex);
	return Counts;
}

FFrontEndProcess& GetFrontEndProcess()
{
	static FFrontEndProcess Process;
	return Process;
}

} // namespace

std::string FindFrontEndProgram()
{
	return FindProgram(FindInstalled("libexec/drydock/drydock_front_end"));
}

FFrontEndReply AskFrontEnd(
	const std::string& Program, const std::string& Text, const FShaderCompileRequest& Request, int TimeLimitSeconds)
{
	return GetFrontEndProcess().Ask(Program, Text, Request, TimeLimitSeconds);
}

FFrontEndCounts GetFrontEndCounts()
{
	return GetFrontEndProcess().GetCounts();
}

} // namespace Drydock
