// Names what is written aside by process, makes its folder, renames or removes it.
#include "Text/AsideFile.h"

#include "Text/ConfigErrors.h"

#include <cerrno>
#include <charconv>
#include <csignal>
#include <unistd.h>
#include <vector>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr const char* Mark = ".writing.";

Files::path MakeAsidePath(const Files::path& Target, const std::string& Process)
{
	return Target.parent_path() / (Target.stem().string() + Mark + Process + Target.extension().string());
}

bool IsProcessGone(pid_t Process)
{
	return kill(Process, 0) != 0 && errno == ESRCH;
}

/** What processes that were killed have left for this place. */
void RemoveAbandoned(const Files::path& Target)
{
	std::error_code Ignored;
	std::vector<Files::path> Abandoned;
	const Files::path Folder = Target.has_parent_path() ? Target.parent_path() : ".";
	for (const Files::directory_entry& Entry : Files::directory_iterator(Folder, Ignored))
	{
		const std::optional<Files::path> Place = FAsideFile::FindAbandonedTarget(Entry.path());
		if (Place && Place->filename() == Target.filename())
		{
			Abandoned.push_back(Entry.path());
		}
	}
	for (const Files::path& Path : Abandoned)
	{
		Files::remove_all(Path, Ignored);
	}
}

} // namespace

FError MakeWriteError(const std::string& Path, const std::string& Why)
{
	return FError({.Code = ErrorFileNotWritten, .Message = "cannot be written: " + Why, .File = Path}, ExitFiles);
}

FAsideFile::FAsideFile(const Files::path& InTarget)
	: Target(InTarget.has_filename() ? InTarget : InTarget.parent_path())
	, Path(MakeAsidePath(Target, std::to_string(getpid())))
{
	std::error_code Error;
	Files::remove_all(GetPath(), Error); // of an earlier process of the same number
	if (Target.has_parent_path())
	{
		Files::create_directories(Target.parent_path(), Error);
	}
	if (Error)
	{
		throw MakeWriteError(Target, Error.message());
	}
	RemoveAbandoned(Target);
}

void FAsideFile::PutInPlace()
{
	const FEndActionsHeld Held; // else half of a folder might move, while a signal's thread takes it away
	std::error_code Error;
	Files::rename(GetPath(), Target, Error);
	if (Error)
	{
		throw MakeWriteError(Target, Error.message());
	}
}

std::optional<Files::path> FAsideFile::FindAbandonedTarget(const Files::path& Path)
{
	const std::string Name = Path.filename().string();
	const size_t At = Name.rfind(Mark);
	if (At == std::string::npos || At == 0)
	{
		return std::nullopt;
	}
	const char* const Digits = Name.data() + At + std::char_traits<char>::length(Mark);
	pid_t Process = 0;
	const std::from_chars_result Result = std::from_chars(Digits, Name.data() + Name.size(), Process);
	const Files::path Target = Path.parent_path() / (Name.substr(0, At) + Result.ptr);
	const bool bExact = Result.ec == std::errc() && Process > 0 &&
						MakeAsidePath(Target, std::to_string(Process)).filename() == Path.filename();
	return bExact && IsProcessGone(Process) ? std::optional(Target) : std::nullopt;
}

} // namespace Drydock
