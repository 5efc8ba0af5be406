// Opens, checks, reads and writes what lies in a folder of code.
#include "TrustedFolder.h"

#include "TemporaryFolder.h"

#include <algorithm>
#include <cerrno>
#include <dirent.h>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace Drydock
{

namespace
{

namespace fs = std::filesystem;

/** "ab/entry.so": "ab" and "entry.so"; the first is empty where there is no folder. */
std::pair<std::string, std::string> SplitName(const std::string& Name)
{
	const size_t Slash = Name.find('/');
	return Slash == std::string::npos ? std::pair(std::string(), Name)
									  : std::pair(Name.substr(0, Slash), Name.substr(Slash + 1));
}

/** Why what is open is not to be trusted; empty: it is. */
std::string FindFault(const FFileDescriptor& File, bool bFolder, const std::vector<uid_t>& Owners)
{
	struct stat Status;
	if (fstat(File.Get(), &Status) != 0)
	{
		return DescribeSystemError(errno);
	}
	if (bFolder ? !S_ISDIR(Status.st_mode) : !S_ISREG(Status.st_mode))
	{
		return bFolder ? "is not a folder" : "is not a file";
	}
	if (std::find(Owners.begin(), Owners.end(), Status.st_uid) == Owners.end())
	{
		return "belongs to another user (uid " + std::to_string(Status.st_uid) + ")";
	}
	if (Status.st_mode & (S_IWGRP | S_IWOTH))
	{
		char Mode[16];
		std::snprintf(Mode, sizeof(Mode), "%04o", unsigned(Status.st_mode & 07777));
		return std::string("can be written by others (mode ") + Mode + ")";
	}
	return {};
}

/** Opens Name as seen from the folder At, and checks it. */
FTrustedFile OpenAt(int At, const std::string& Name, int Flags, const std::vector<uid_t>& Owners)
{
	const bool bFolder = Flags & O_DIRECTORY;
	FTrustedFile Result;
	Result.File = FFileDescriptor(openat(At, Name.c_str(), Flags | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0644));
	if (!Result.File)
	{
		const int Error = errno;
		struct stat Status;
		const bool bThere = fstatat(At, Name.c_str(), &Status, AT_SYMLINK_NOFOLLOW) == 0;
		const bool bLink = bThere && S_ISLNK(Status.st_mode);
		Result.Trust = bLink || (bThere && bFolder && !S_ISDIR(Status.st_mode)) ? ETrust::Foreign : ETrust::Absent;
		Result.Fault = bLink                             ? "is a symbolic link"
					   : Result.Trust == ETrust::Foreign ? "is not a folder"
														 : DescribeSystemError(Error);
		return Result;
	}
	Result.Fault = FindFault(Result.File, bFolder, Owners);
	Result.Trust = Result.Fault.empty() ? ETrust::Trusted : ETrust::Foreign;
	if (Result.Trust == ETrust::Foreign)
	{
		Result.File.Close();
	}
	return Result;
}

/** An open folder that opendir may close. */
DIR* OpenList(int Folder)
{
	const int Copy = openat(Folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
	DIR* const List = Copy >= 0 ? fdopendir(Copy) : nullptr;
	if (Copy >= 0 && !List)
	{
		close(Copy);
	}
	return List;
}

} // namespace

FTrustedFolder::FTrustedFolder(const std::string& InPath, const std::vector<uid_t>& InOwners)
	: Path(InPath)
	, Owners(InOwners)
{
	while (Path.size() > 1 && Path.back() == '/')
	{
		Path.pop_back(); // behind a slash, a link would be followed
	}
	Folder = OpenAt(AT_FDCWD, Path, O_RDONLY | O_DIRECTORY, Owners);
}

int FTrustedFolder::Make(const std::string& Path)
{
	const fs::path Wanted(Path);
	std::error_code Ignored;
	if (fs::is_directory(Wanted, Ignored))
	{
		return 0;
	}
	std::error_code Error;
	if (Wanted.has_parent_path())
	{
		fs::create_directories(Wanted.parent_path(), Error);
	}
	return Error ? Error.value() : mkdir(Path.c_str(), 0700) == 0 || errno == EEXIST ? 0 : errno;
}

int FTrustedFolder::FindWriteError() const
{
	return faccessat(Folder.File.Get(), ".", W_OK | X_OK, AT_EACCESS) == 0 ? 0 : errno;
}

FTrustedFile FTrustedFolder::OpenSubfolder(const std::string& Subfolder) const
{
	return OpenAt(Folder.File.Get(), Subfolder, O_RDONLY | O_DIRECTORY, Owners);
}

FTrustedFile FTrustedFolder::OpenIn(const FTrustedFile& In, const std::string& Name, int Flags) const
{
	FTrustedFile Result;
	if (In.Trust != ETrust::Trusted)
	{
		Result.Trust = In.Trust;
		Result.Fault = In.Fault;
		return Result;
	}
	return OpenAt(In.File.Get(), Name, Flags, Owners);
}

FTrustedFile FTrustedFolder::OpenByName(const std::string& Name, int Flags) const
{
	const auto [Subfolder, File] = SplitName(Name);
	return Subfolder.empty() ? OpenIn(Folder, File, Flags) : OpenIn(OpenSubfolder(Subfolder), File, Flags);
}

FTrustedFile FTrustedFolder::Open(const std::string& Name) const
{
	return OpenByName(Name, O_RDONLY);
}

FTrustedFile FTrustedFolder::OpenOrMake(const std::string& Name) const
{
	if (const std::string Subfolder = SplitName(Name).first; !Subfolder.empty())
	{
		mkdirat(Folder.File.Get(), Subfolder.c_str(), 0755);
	}
	return OpenByName(Name, O_RDWR | O_CREAT);
}

std::vector<std::string> FTrustedFolder::List(const std::string& Subfolder) const
{
	std::vector<std::string> Names;
	const FTrustedFile Opened = OpenSubfolder(Subfolder);
	DIR* const Entries = Opened.Trust == ETrust::Trusted ? OpenList(Opened.File.Get()) : nullptr;
	while (const dirent* const Entry = Entries ? readdir(Entries) : nullptr)
	{
		Names.emplace_back(Entry->d_name);
	}
	if (Entries)
	{
		closedir(Entries);
	}
	return Names;
}

int FTrustedFolder::Write(const std::vector<FFileToWrite>& Files) const
try
{
	const int At = Folder.File.Get();
	const FMarkedFolder Aside(GetLoadPath(MakeTemporaryName()));
	std::vector<std::string> Asides;
	int Error = 0;
	for (size_t Index = 0; Error == 0 && Index < Files.size(); ++Index)
	{
		Asides.push_back(Aside.Reserve(std::to_string(Index)));
		FFileDescriptor File(open(Asides.back().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644));
		Error = File ? WriteAndClose(std::move(File), Files[Index].Bytes) : errno;
	}
	for (size_t Index = 0; Error == 0 && Index < Files.size(); ++Index)
	{
		const auto [Subfolder, Name] = SplitName(Files[Index].Name);
		FTrustedFile Target;
		int To = At;
		if (!Subfolder.empty())
		{
			mkdirat(At, Subfolder.c_str(), 0755);
			Target = OpenSubfolder(Subfolder);
			To = Target.File.Get();
			Error = Target.Trust == ETrust::Trusted ? 0 : EPERM;
		}
		Error = Error == 0 && renameat(AT_FDCWD, Asides[Index].c_str(), To, Name.c_str()) != 0 ? errno : Error;
	}
	return Error;
}
catch (const std::system_error& Unmade)
{
	return Unmade.code().value();
}

std::string FTrustedFolder::GetLoadPath(const std::string& Name) const
{
	const std::string Opened = "/proc/self/fd/" + std::to_string(Folder.File.Get());
	std::error_code Ignored;
	return (fs::is_directory(Opened, Ignored) ? Opened : Path) + "/" + Name; // some sandboxes have no /proc
}

} // namespace Drydock
