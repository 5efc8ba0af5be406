// Makes a folder and locks a file in it.
#include "Text/FolderLock.h"

#include "Diagnostics.h"
#include "Text/AsideFile.h"
#include "Text/OutputErrors.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <thread>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** Those of Folder and the ones around it that are not there, the innermost first. */
std::list<Files::path> FindMissing(Files::path Folder)
{
	std::list<Files::path> Missing;
	std::error_code Ignored;
	while (!Folder.empty() && !Files::exists(Files::symlink_status(Folder, Ignored)))
	{
		Missing.push_back(Folder);
		Folder = Folder.parent_path();
	}
	return Missing;
}

void RemoveEmpty(const std::list<Files::path>& Folders)
{
	for (const Files::path& Folder : Folders)
	{
		rmdir(Folder.c_str());
	}
}

bool IsSameFile(int File, const Files::path& Path)
{
	struct stat Opened;
	struct stat Named;
	return fstat(File, &Opened) == 0 && stat(Path.c_str(), &Named) == 0 && Opened.st_ino == Named.st_ino &&
		   Opened.st_dev == Named.st_dev;
}

/** The first bytes of the file. */
std::string ReadOwner(int File)
{
	char Text[16] = {};
	const ssize_t Size = pread(File, Text, sizeof(Text), 0);
	return std::string(Text, Size > 0 ? static_cast<size_t>(Size) : 0);
}

/** Whether it is what a lock holds. */
bool IsNumber(const std::string& Owner)
{
	return Owner.find_first_not_of("0123456789\n") == std::string::npos;
}

/** "process 1234", if the file holds a number; else "another process". */
std::string DescribeOwner(int File)
{
	const std::string Number = ReadOwner(File);
	const bool bNumber = !Number.empty() && IsNumber(Number);
	return bNumber ? "process " + Number.substr(0, Number.find('\n')) : "another process";
}

} // namespace

FFolderLock::FFolderLock(const Files::path& InFolder, std::chrono::seconds Wait)
	: Folder(InFolder)
	, Path(InFolder / ".drydock.lock")
	, Removal(
		  [this]
		  {
			  if (File >= 0)
			  {
				  unlink(Path.c_str());
			  }
			  RemoveEmpty(Made);
		  })
{
	constexpr int MostTries = 100; // each time somebody else has just ended
	const auto WaitEnd = std::chrono::steady_clock::now() + Wait;
	for (int Try = 0; Try < MostTries || std::chrono::steady_clock::now() < WaitEnd; ++Try)
	{
		MakeFolders();
		if (TryLock(WaitEnd))
		{
			return;
		}
	}
	throw MakeWriteError(Path.string(), "others take it away again and again");
}

FFolderLock::~FFolderLock()
{
	const FEndActionsHeld Held;
	unlink(Path.c_str());
	close(File);
	RemoveEmpty(Made);
	File = -1; // from here on, a file of that name is another's
	Made.clear();
}

void FFolderLock::MakeFolders()
{
	const FEndActionsHeld Held;
	const std::list<Files::path> Missing = FindMissing(Folder);
	std::error_code Error;
	Files::create_directories(Folder, Error);
	if (Error)
	{
		RemoveEmpty(Missing);
		throw MakeWriteError(Folder.string(), Error.message());
	}
	Made.insert(Made.end(), Missing.begin(), Missing.end());
}

bool FFolderLock::TryLock(std::chrono::steady_clock::time_point WaitEnd)
{
	const FEndActionsHeld Held;
	const int Opened = open(Path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
	if (Opened < 0 && errno == ENOENT)
	{
		return false;
	}
	const auto Fail = [&](const std::string& Why)
	{
		close(Opened);
		RemoveEmpty(Made);
		return MakeWriteError(Path.string(), Why);
	};
	if (Opened < 0)
	{
		throw Fail(std::strerror(errno));
	}
	if (flock(Opened, LOCK_EX | LOCK_NB) != 0)
	{
		if (errno != EWOULDBLOCK)
		{
			throw Fail(std::string("it cannot be locked: ") + std::strerror(errno));
		}
		const std::string Owner = DescribeOwner(Opened);
		close(Opened);
		if (std::chrono::steady_clock::now() < WaitEnd)
		{
			std::this_thread::sleep_for(std::chrono::milliseconds(50));
			return false;
		}
		RemoveEmpty(Made);
		throw FError({.Code = ErrorFolderInUse,
						 .Message = Owner + " is writing to this folder: wait for it, or name another with --out",
						 .File = Folder.string()},
			ExitFiles);
	}
	if (!IsSameFile(Opened, Path))
	{
		close(Opened); // its owner has ended between the two steps, and the file with it
		return false;
	}
	if (!IsNumber(ReadOwner(Opened)))
	{
		close(Opened);
		throw FError({.Code = ErrorForeignContent,
						 .Message = "drydock did not write this, and its lock would take its place: move it away, or "
									"name another folder with --out",
						 .File = Path.string()},
			ExitUsage);
	}
	const std::string Number = std::to_string(getpid()) + "\n";
	if (ftruncate(Opened, 0) != 0 ||
		pwrite(Opened, Number.data(), Number.size(), 0) != static_cast<ssize_t>(Number.size()))
	{
		const std::string Why = std::strerror(errno);
		unlink(Path.c_str());
		throw Fail(Why);
	}
	File = Opened;
	return true;
}

} // namespace Drydock
