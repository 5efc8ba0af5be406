// The handler only tells a thread, which may do what no handler may: wait for others, and remove files.
#include "Program/EndingSignals.h"

#include "EndAction.h"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <fcntl.h>
#include <string_view>
#include <thread>
#include <unistd.h>

namespace Drydock
{

namespace
{

constexpr int ExitSignalled = 128; // and the signal's number, as shells have it

int GPipe[2] = {-1, -1};
std::atomic<int64_t> GFirstMilliseconds = 0;

static_assert(std::atomic<int64_t>::is_always_lock_free);

int64_t GetMilliseconds()
{
	timespec Now = {};
	clock_gettime(CLOCK_MONOTONIC, &Now);
	return int64_t(Now.tv_sec) * 1000 + Now.tv_nsec / 1000000 + 1;
}

/** Calls nothing but what POSIX allows in a handler. */
void TellThread(int Signal)
{
	// `timeout` sends its signal twice at the same time, to the process and to its group.
	constexpr int64_t LeastMilliseconds = 200;
	const int Error = errno;
	const int64_t Now = GetMilliseconds();
	int64_t First = 0;
	if (GFirstMilliseconds.compare_exchange_strong(First, Now))
	{
		const auto Byte = static_cast<unsigned char>(Signal);
		if (write(GPipe[1], &Byte, 1) != 1)
		{
			_exit(ExitSignalled + Signal);
		}
	}
	else if (Now - First >= LeastMilliseconds)
	{
		_exit(ExitSignalled + Signal);
	}
	errno = Error;
}

void WaitForSignal()
{
	unsigned char Signal = 0;
	while (read(GPipe[0], &Signal, 1) != 1)
	{
		if (errno != EINTR)
		{
			return;
		}
	}
	DoEndActions();
	if (isatty(STDERR_FILENO) != 0)
	{
		constexpr std::string_view ClearLine = "\r\x1b[2K\x1b[0m";
		static_cast<void>(!write(STDERR_FILENO, ClearLine.data(), ClearLine.size()));
	}
	_exit(ExitSignalled + Signal);
}

} // namespace

void CatchEndingSignals()
{
	if (pipe2(GPipe, O_CLOEXEC) != 0)
	{
		return; // then signals do what they do everywhere
	}
	std::thread(WaitForSignal).detach();
	struct sigaction Action = {};
	Action.sa_handler = TellThread;
	Action.sa_flags = SA_RESTART;
	sigemptyset(&Action.sa_mask);
	std::signal(SIGXFSZ, SIG_IGN); // a file beyond the limit is an error of writing (EFBIG, DD5004)
	for (const int Signal : {SIGINT, SIGTERM})
	{
		sigaction(Signal, &Action, nullptr);
	}
	struct sigaction Before = {};
	if (sigaction(SIGHUP, nullptr, &Before) == 0 && Before.sa_handler != SIG_IGN) // nohup ignores it
	{
		sigaction(SIGHUP, &Action, nullptr);
	}
}

} // namespace Drydock
