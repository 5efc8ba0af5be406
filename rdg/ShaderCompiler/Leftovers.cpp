// Finds what dead processes have left behind.
#include "Leftovers.h"

#include "FileDescriptor.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace Drydock
{

namespace
{

namespace fs = std::filesystem;

constexpr std::string_view Prefix = "drydock-";

/** The process that such a name tells of; 0: it is no such name. */
pid_t GetProcess(const std::string& Name)
{
	if (!Name.starts_with(Prefix))
	{
		return 0;
	}
	pid_t Process = 0;
	const char* const End = Name.data() + Name.size();
	const std::from_chars_result Read = std::from_chars(Name.data() + Prefix.size(), End, Process);
	return Read.ec == std::errc() && Read.ptr != End && *Read.ptr == '-' && Process > 0 ? Process : 0;
}

/** Whether the user made it and no process holds it. A process of another container is not seen by its number, but its
 * lock is. */
bool IsLeft(const fs::path& Path, pid_t Process)
{
	if (kill(Process, 0) == 0 || errno != ESRCH)
	{
		return false;
	}
	const FFileDescriptor File(open(Path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
	struct stat Status;
	return File && fstat(File.Get(), &Status) == 0 && Status.st_uid == geteuid() &&
		   flock(File.Get(), LOCK_EX | LOCK_NB) == 0;
}

} // namespace

std::string GetLeftoverPrefix()
{
	return std::string(Prefix) + std::to_string(getpid()) + "-";
}

void RemoveLeftovers(const std::string& Folder)
{
	std::error_code Error;
	for (fs::directory_iterator It(Folder, Error), End; !Error && It != End; It.increment(Error))
	{
		const pid_t Process = GetProcess(It->path().filename().string());
		if (Process != 0 && IsLeft(It->path(), Process))
		{
			std::error_code Ignored;
			fs::remove_all(It->path(), Ignored);
		}
	}
}

} // namespace Drydock
