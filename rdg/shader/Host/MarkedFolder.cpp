// Makes folders with a mark, and removes what a mark lists.
#include "MarkedFolder.h"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <vector>

namespace Drydock
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* MarkName = ".drydock.mark";
constexpr std::string_view Random = "XXXXXX";

void Require(int Error)
{
	if (Error != 0)
	{
		throw std::system_error(Error, std::generic_category());
	}
}

std::string MakeMark(const FFileDescriptor& Folder, const FFileDescriptor& Mark)
{
	struct stat OfFolder = {};
	struct stat OfMark = {};
	fstat(Folder.Get(), &OfFolder);
	fstat(Mark.Get(), &OfMark);
	return "drydock made this folder, and removes from it what is listed here: " + std::to_string(OfFolder.st_ino) +
		   " " + std::to_string(OfMark.st_ino) + std::string(1, '\0');
}

/** A path to the open folder, whatever its own path leads to by now; the own path where /proc is missing. */
std::string GetOpened(const std::string& Path, const FFileDescriptor& Folder)
{
	const std::string Opened = "/proc/self/fd/" + std::to_string(Folder.Get());
	std::error_code Ignored;
	return fs::is_directory(Opened, Ignored) ? Opened : Path;
}

/** Whether nothing but the mark is in the folder. */
bool IsAlone(const FFileDescriptor& Folder)
{
	std::error_code Error;
	const fs::directory_iterator First(GetOpened({}, Folder), Error);
	return !Error && First != fs::directory_iterator() && First->path().filename() == MarkName &&
		   std::distance(First, fs::directory_iterator()) == 1;
}

/** The names that the mark lists, without one that was cut short. bOutMark: whether it is this folder's. */
std::vector<std::string> ReadNames(const FFileDescriptor& Folder, const FFileDescriptor& Mark, bool& bOutMark)
{
	int Error = lseek(Mark.Get(), 0, SEEK_SET) == 0 ? 0 : errno;
	const std::string Text = Error == 0 ? ReadToEnd(Mark, Error) : std::string();
	const std::string Head = MakeMark(Folder, Mark);
	const bool bCutShort = Head.starts_with(Text) && IsAlone(Folder); // killed while it made the mark
	bOutMark = Error == 0 && (Text.starts_with(Head) || bCutShort);
	std::vector<std::string> Names;
	for (size_t At = Head.size(), End; bOutMark && (End = Text.find('\0', At)) != std::string::npos; At = End + 1)
	{
		Names.push_back(Text.substr(At, End - At));
	}
	return Names;
}

/** Removes what the mark lists, the mark and then the folder, unless other things are in it. */
void RemoveListed(const std::string& Path, const FFileDescriptor& Folder, const FFileDescriptor& Mark)
{
	bool bMark = false;
	const std::vector<std::string> Names = ReadNames(Folder, Mark, bMark);
	const std::string Opened = GetOpened(Path, Folder);
	bool bRemoved = bMark;
	for (const std::string& Name : Names)
	{
		const fs::path Plain(Name);
		if (!Name.empty() && Plain == Plain.filename() && Name != "." && Name != "..")
		{
			std::error_code Error;
			fs::remove_all(fs::path(Opened) / Plain, Error);
			bRemoved = bRemoved && !Error;
		}
	}
	if (bRemoved)
	{
		unlinkat(Folder.Get(), MarkName, 0);
		rmdir(Path.c_str());
	}
}

void RemoveAbandoned(const std::string& Path)
{
	const FFileDescriptor Folder(open(Path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
	struct stat Status;
	if (!Folder || fstat(Folder.Get(), &Status) != 0 || Status.st_uid != geteuid() || (Status.st_mode & 0777) != 0700)
	{
		return;
	}
	const FFileDescriptor Mark(openat(Folder.Get(), MarkName, O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
	if (Mark && fstat(Mark.Get(), &Status) == 0 && S_ISREG(Status.st_mode) && Status.st_uid == geteuid() &&
		flock(Mark.Get(), LOCK_EX | LOCK_NB) == 0)
	{
		RemoveListed(Path, Folder, Mark);
	}
}

} // namespace

FMarkedFolder::FMarkedFolder(const std::string& Begin)
	: Path(Begin + std::string(Random))
	, Owner(getpid())
	, Removal(
		  [this]
		  {
			  // Other threads may still be writing into the folder: under another name they do not find it. Who has it
			  // open does, so it is tried again for a moment. The other name is one that is looked for.
			  const std::string Going = Path.substr(0, Path.size() - Random.size()) + "going.";
			  const std::string& Place = Mark && rename(Path.c_str(), Going.c_str()) == 0 ? Going : Path;
			  for (int Try = 0; Mark && Try < 100 && access(Place.c_str(), F_OK) == 0; ++Try)
			  {
				  Remove(Place);
				  std::this_thread::sleep_for(std::chrono::milliseconds(Try == 0 ? 0 : 5));
			  }
		  })
{
	const FEndActionsHeld Held; // until its end is certain
	const std::string Template = Path;
	int Error = 0;
	struct stat Status = {};
	do // again where somebody took the folder for an abandoned one before it was locked
	{
		Path = Template;
		Require(mkdtemp(Path.data()) ? 0 : errno);
		Folder = FFileDescriptor(open(Path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
		Mark = FFileDescriptor(
			openat(Folder.Get(), MarkName, O_RDWR | O_APPEND | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
		Error = Mark ? 0 : errno;
		flock(Mark.Get(), LOCK_EX); // before the mark is one
	} while (Mark && fstat(Mark.Get(), &Status) == 0 && Status.st_nlink == 0);
	Error = Error == 0 ? WriteAll(Mark, MakeMark(Folder, Mark)) : Error;
	if (Error != 0)
	{
		unlinkat(Folder.Get(), MarkName, 0);
		rmdir(Path.c_str());
	}
	Require(Error);
}

FMarkedFolder::~FMarkedFolder()
{
	if (Owner == getpid())
	{
		Remove(Path);
	}
}

std::string FMarkedFolder::Reserve(const std::string& Name) const
{
	Require(WriteAll(Mark, Name + std::string(1, '\0')));
	return Path + "/" + Name;
}

void FMarkedFolder::Remove(const std::string& From) const
{
	RemoveListed(From, Folder, Mark);
}

void RemoveAbandonedFolders(const std::string& Parent, const std::function<bool(const std::string& Begin)>& IsBegin)
{
	std::error_code Error;
	std::vector<std::string> Found;
	for (fs::directory_iterator It(Parent, Error), End; !Error && It != End; It.increment(Error))
	{
		const std::string Name = It->path().filename().string();
		if (Name.size() > Random.size() && IsBegin(Name.substr(0, Name.size() - Random.size())))
		{
			Found.push_back(It->path().string());
		}
	}
	for (const std::string& Path : Found)
	{
		RemoveAbandoned(Path);
	}
}

} // namespace Drydock
