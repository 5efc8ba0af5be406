// Writes aside in a marked folder, and renames from there.
#include "Text/AsideFile.h"

#include "Text/ConfigErrors.h"

#include <system_error>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

const std::string Mark = ".writing.";

} // namespace

FError MakeWriteError(const std::string& Path, const std::string& Why)
{
	return FError({.Code = ErrorFileNotWritten, .Message = "cannot be written: " + Why, .File = Path}, ExitFiles);
}

FAsideFile::FAsideFile(const Files::path& InTarget)
	: Target(InTarget.has_filename() ? InTarget : InTarget.parent_path())
{
	try
	{
		if (Target.has_parent_path())
		{
			Files::create_directories(Target.parent_path());
		}
		RemoveAbandoned(Target.has_parent_path() ? Target.parent_path() : ".",
			[this](const std::string& Name) { return Target.filename() == Name; });
		Aside = std::make_unique<const FMarkedFolder>(Target.string() + Mark);
		Path = Aside->Reserve(Target.filename().string());
	}
	catch (const std::system_error& Error)
	{
		throw MakeWriteError(Target, Error.code().message());
	}
}

void FAsideFile::PutInPlace()
{
	const FEndActionsHeld Held; // else half of a folder might move, while a signal's thread takes it away
	std::error_code Error;
	Files::rename(Path, Target, Error);
	if (Error)
	{
		throw MakeWriteError(Target, Error.message());
	}
	Aside.reset();
}

void FAsideFile::RemoveAbandoned(
	const Files::path& Folder, const std::function<bool(const std::string& Name)>& IsWanted)
{
	RemoveAbandonedFolders(Folder.string(), [&IsWanted](const std::string& Begin)
		{ return Begin.ends_with(Mark) && IsWanted(Begin.substr(0, Begin.size() - Mark.size())); });
}

} // namespace Drydock
