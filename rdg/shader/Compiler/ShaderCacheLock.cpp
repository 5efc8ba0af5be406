// Waits for a lock, not forever, and writes into it who holds it.
#include "ShaderCacheLock.h"

#include "Diagnostics.h"
#include "PrintText.h"
#include "TimeLimit.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace Drydock
{

namespace
{

using FClock = std::chrono::steady_clock;

constexpr int DefaultLimitSeconds = 30;
constexpr int PatienceSeconds = 5; // in silence

/** The text in a lock. */
std::string ReadHolder(const FFileDescriptor& Lock)
{
	char Text[32];
	const ssize_t Count = pread(Lock.Get(), Text, sizeof(Text), 0);
	return std::string(Text, size_t(std::max<ssize_t>(Count, 0)));
}

/** Number of the process that wrote itself into a lock and lives; 0: nobody known. */
pid_t FindHolder(const FFileDescriptor& Lock)
{
	const std::string Text = ReadHolder(Lock);
	pid_t Process = 0;
	std::from_chars(Text.data(), Text.data() + Text.size(), Process);
	const bool bAlive = Process > 0 && (kill(Process, 0) == 0 || errno == EPERM);
	return bAlive ? Process : 0;
}

/** On a full disk it stays unknown. */
void SetHolder(const FFileDescriptor& Lock, const std::string& Text)
{
	[[maybe_unused]] const bool bWritten =
		ftruncate(Lock.Get(), 0) == 0 && pwrite(Lock.Get(), Text.data(), Text.size(), 0) >= 0;
}

void Warn(const std::string& Path, pid_t Holder, const std::string& What)
{
	const std::string Who = Holder ? "process " + std::to_string(Holder) : std::string("another process");
	const FDiagnostic Diagnostic = {ESeverity::Warning, 6052,
		Who + " holds this lock of the shader cache: " + What + " (DRYDOCK_LOCK_SECONDS)", Path, 0, 0, {}};
	PrintText(stderr, Diagnostic.ToString() + "\n");
}

/** Whether it was locked in time. */
bool Wait(const FFileDescriptor& Lock, const std::string& Path)
{
	const int LimitSeconds = GetTimeLimitSeconds("DRYDOCK_LOCK_SECONDS", DefaultLimitSeconds);
	const std::string Limit = std::to_string(LimitSeconds) + " s";
	const FClock::time_point Start = FClock::now();
	bool bTold = LimitSeconds <= PatienceSeconds;
	while (flock(Lock.Get(), LOCK_EX | LOCK_NB) != 0)
	{
		if (errno != EWOULDBLOCK && errno != EINTR)
		{
			return false; // a file system without locks
		}
		const FClock::duration Waited = FClock::now() - Start;
		const pid_t Holder = FindHolder(Lock);
		const bool bOurs = Holder == getpid(); // another thread, which compiles another shader
		if (Waited >= std::chrono::seconds(LimitSeconds))
		{
			if (!bOurs)
			{
				Warn(Path, Holder, "after " + Limit + " the shader is compiled without it");
			}
			return false;
		}
		if (!bTold && !bOurs && Waited >= std::chrono::seconds(PatienceSeconds))
		{
			Warn(Path, Holder, "waiting for it, " + Limit + " at most");
			bTold = true;
		}
		std::this_thread::sleep_for(std::chrono::milliseconds(20));
	}
	return true;
}

} // namespace

FShaderCacheLock::FShaderCacheLock(const FTrustedFolder& Folder, const std::string& Name)
{
	const std::string File = "locks/" + Name;
	FTrustedFile Lock = Folder.OpenOrMake(File);
	if (Lock.Trust != ETrust::Trusted || !Wait(Lock.File, Folder.GetPath() + "/" + File) ||
		ReadHolder(Lock.File).find_first_not_of("0123456789\n") != std::string::npos) // another file than a lock
	{
		return;
	}
	Held = std::move(Lock.File);
	SetHolder(Held, std::to_string(getpid()) + "\n");
}

FShaderCacheLock::~FShaderCacheLock()
{
	if (Held)
	{
		SetHolder(Held, "");
	}
}

} // namespace Drydock
