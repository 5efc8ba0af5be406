// Checks what is in the way of outputs, and moves them into place.
#include "Text/OutputFolder.h"

#include "Diagnostics.h"
#include "Text/OutputErrors.h"
#include "Text/TextFile.h"

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

Files::path RequireFolder(const Files::path& Path)
{
	std::error_code Ignored;
	if (Files::exists(Path, Ignored) && !Files::is_directory(Path, Ignored))
	{
		throw MakeWriteError(Path.string(), "there is a file of that name");
	}
	return Path.has_filename() ? Path : Path.parent_path();
}

} // namespace

FError MakeForeignError(const Files::path& Path, const std::string& Why)
{
	return FError({.Code = ErrorForeignContent,
					  .Message = Why + ", and outputs would take its place: move it away, or name another folder with "
									   "--out",
					  .File = Path.string()},
		ExitUsage);
}

FOutputFolder::FOutputFolder(const Files::path& InFolder, const FOutputNames& InNames)
	: Folder(RequireFolder(InFolder.lexically_normal()))
	, Names(InNames)
	, Lock(Folder)
	, Before(FFileList::Read(GetListPath()))
	, Aside(Folder / InNames.Name)
{
	for (const std::string& Name : Names.Files)
	{
		RequireOwn(Name);
	}
	for (const std::string& Name : Before.GetNames())
	{
		RequireOwn(Name);
	}
	RequireOwnFolders();
	std::error_code Error;
	Files::create_directory(GetAside(), Error);
	if (Error)
	{
		throw MakeWriteError(GetAside().string(), Error.message());
	}
}

Files::path FOutputFolder::GetListPath() const
{
	return Folder / (".drydock." + Names.Name + ".files");
}

void FOutputFolder::WriteList(const FFileList& List) const
{
	WriteTextFile(GetListPath().string(), List.GetText());
}

void FOutputFolder::RequireOwn(const std::string& Name) const
{
	std::error_code Ignored;
	const Files::path Path = Folder / Name;
	const Files::file_status Status = Files::symlink_status(Path, Ignored);
	const bool bNothing = Files::is_regular_file(Status) && Files::file_size(Path, Ignored) == 0;
	if (Files::exists(Status) && !bNothing && !Before.FindFault(Folder, Name).empty())
	{
		throw MakeForeignError(
			Path, Before.Has(Name) ? "this was changed since drydock wrote it" : "drydock did not write this");
	}
}

void FOutputFolder::RequireOwnFolders() const
{
	for (const std::string& Sub : Names.Folders)
	{
		const std::string Foreign = Before.FindForeign(Folder, Sub);
		if (!Foreign.empty())
		{
			throw MakeForeignError(Folder / Foreign, "drydock did not write this");
		}
	}
}

void FOutputFolder::PutInPlace()
{
	const FFileList After = FFileList::Make(GetAside(), Names.Unsteady);
	const std::set<std::string> NewNames = After.GetNames();
	for (const std::string& Name : NewNames)
	{
		if (!Before.Has(Name)) // the others were looked at
		{
			RequireOwn(Name);
		}
	}
	RequireOwnFolders();
	const FEndActionsHeld Held;
	FFileList Both = Before;
	Both.Add(After);
	WriteList(Both); // whenever this ends, all that is there is on the list
	std::set<std::string> Gone = Before.GetNames();
	std::erase_if(Gone, [&](const std::string& Name) { return NewNames.count(Name) > 0 && Name != Names.Last; });
	RemoveFiles(Folder, Gone);
	try
	{
		const auto Move = [&](const std::string& Name)
		{
			Files::create_directories((Folder / Name).parent_path());
			Files::rename(GetAside() / Name, Folder / Name);
		};
		for (const std::string& Name : NewNames)
		{
			if (Name != Names.Last)
			{
				Move(Name);
			}
		}
		if (NewNames.count(Names.Last) > 0)
		{
			Move(Names.Last);
		}
	}
	catch (const Files::filesystem_error& Error)
	{
		throw MakeWriteError(Error.path1().string(), Error.code().message());
	}
	WriteList(After);
}

} // namespace Drydock
