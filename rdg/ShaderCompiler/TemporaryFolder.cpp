// Makes temporary folders, and removes those that nobody holds any more.
#include "TemporaryFolder.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr std::string_view Prefix = "drydock-";
constexpr std::string_view Suffix = "-XXXXXX"; // of mkdtemp

/** Locked, or -1 where another process holds it. */
int LockFolder(const Files::path& Folder)
{
	const int Opened = open(Folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
	if (Opened >= 0 && flock(Opened, LOCK_EX | LOCK_NB) != 0)
	{
		close(Opened);
		return -1;
	}
	return Opened;
}

/** Whether it has exactly such a name, of a process that is no more. */
bool IsNameAbandoned(std::string_view Name)
{
	if (!Name.starts_with(Prefix) || Name.size() <= Prefix.size() + Suffix.size())
	{
		return false;
	}
	const char* const End = Name.data() + Name.size() - Suffix.size();
	pid_t Process = 0;
	const std::from_chars_result Result = std::from_chars(Name.data() + Prefix.size(), End, Process);
	return Result.ec == std::errc() && Result.ptr == End && *End == '-' && Process > 0 && kill(Process, 0) != 0 &&
		   errno == ESRCH;
}

void RemoveAbandoned(const Files::path& Parent)
{
	std::error_code Ignored;
	std::vector<Files::path> Abandoned;
	for (const Files::directory_entry& Entry : Files::directory_iterator(Parent, Ignored))
	{
		if (IsNameAbandoned(Entry.path().filename().string()))
		{
			Abandoned.push_back(Entry.path());
		}
	}
	for (const Files::path& Folder : Abandoned)
	{
		const int Lock = LockFolder(Folder); // a process of another container has another number here
		struct stat Status;
		if (Lock >= 0 && fstat(Lock, &Status) == 0 && Status.st_uid == geteuid())
		{
			Files::remove_all(Folder, Ignored);
		}
		if (Lock >= 0)
		{
			close(Lock);
		}
	}
}

} // namespace

FTemporaryFolder::FTemporaryFolder()
{
	std::error_code Error;
	Files::path Parent = Files::temp_directory_path(Error);
	Parent = Error ? Files::path("/tmp") : Parent;
	static const bool bOnce = (RemoveAbandoned(Parent), true);
	static_cast<void>(bOnce);
	const FEndActionsHeld Held; // until its end is certain
	std::string Pattern = (Parent / (std::string(Prefix) + std::to_string(getpid()) + std::string(Suffix))).string();
	if (mkdtemp(Pattern.data()))
	{
		Path = Pattern;
		Lock = LockFolder(Path);
		Scratch.emplace(Path);
	}
}

FTemporaryFolder::~FTemporaryFolder()
{
	if (Lock >= 0)
	{
		close(Lock);
	}
}

} // namespace Drydock
