// Names what is written aside by process, makes its folder, renames or removes it.
#include "Text/AsideFile.h"

#include "Text/ConfigErrors.h"

#include <unistd.h>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr const char* Mark = ".writing.";

Files::path MakeAsidePath(const Files::path& Target)
{
	return Target.parent_path() /
		   (Target.stem().string() + Mark + std::to_string(getpid()) + Target.extension().string());
}

} // namespace

FError MakeWriteError(const std::string& Path, const std::string& Why)
{
	return FError({.Code = ErrorFileNotWritten, .Message = "cannot be written: " + Why, .File = Path}, ExitFiles);
}

FAsideFile::FAsideFile(const Files::path& InTarget)
	: Target(InTarget.has_filename() ? InTarget : InTarget.parent_path())
	, Path(MakeAsidePath(Target))
{
	std::error_code Error;
	Files::remove_all(Path, Error); // of an earlier process of the same number
	if (Target.has_parent_path())
	{
		Files::create_directories(Target.parent_path(), Error);
	}
	if (Error)
	{
		throw MakeWriteError(Target, Error.message());
	}
}

FAsideFile::~FAsideFile()
{
	std::error_code Ignored;
	Files::remove_all(Path, Ignored);
}

void FAsideFile::PutInPlace()
{
	std::error_code Error;
	Files::rename(Path, Target, Error);
	if (Error)
	{
		throw MakeWriteError(Target, Error.message());
	}
}

bool FAsideFile::IsAside(const Files::path& Path)
{
	return Path.filename().string().find(Mark) != std::string::npos;
}

} // namespace Drydock
