// Reads and writes lists of files, and compares them with what stands in a folder.
#include "Text/FileList.h"

#include "Diagnostics.h"
#include "Text/AsideFile.h"
#include "Text/Fingerprint.h"
#include "Text/OutputErrors.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <functional>
#include <sstream>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

const std::string Head = "drydock files 1\n";
const std::string Foot = "end ";
constexpr size_t FingerprintSize = 32;
const std::string NoFingerprint(FingerprintSize, '-');

std::string MakeFoot(const std::string& Body)
{
	FFingerprint Fingerprint;
	Fingerprint.AddText(Body);
	return Foot + Fingerprint.Get() + "\n";
}

/** As Make writes them: a path that leads down from the folder. A list may come from a stranger. */
bool LeadsDown(const std::string& Name)
{
	const Files::path Path(Name);
	return !Name.empty() && Path.is_relative() && Path == Path.lexically_normal() && *Path.begin() != ".." &&
		   *Path.begin() != "." && Path.has_filename();
}

/** Whether Name is reached without a symbolic link. */
bool HasOwnFolders(const Files::path& Folder, const std::string& Name)
{
	std::error_code Ignored;
	Files::path At = Folder;
	for (const Files::path& Part : Files::path(Name).parent_path())
	{
		At /= Part;
		if (Files::is_symlink(Files::symlink_status(At, Ignored)))
		{
			return false;
		}
	}
	return true;
}

FError MakeDamageError(const Files::path& File)
{
	return FError({.Code = ErrorListDamaged,
					  .Message = "the list of the files that drydock wrote here is damaged, so that nothing here is "
								 "known to be drydock's: remove it with those files, or name another folder with "
								 "--out",
					  .File = File.string()},
		ExitFiles);
}

} // namespace

FFileList FFileList::Read(const Files::path& File)
{
	std::error_code Ignored;
	FFileList List;
	if (!Files::exists(Files::symlink_status(File, Ignored)))
	{
		return List;
	}
	const std::string Text = ReadTextFile(File.string());
	const size_t FootSize = Foot.size() + FingerprintSize + 1;
	const std::string Body = Text.substr(0, Text.size() - std::min(Text.size(), FootSize));
	if (Body.compare(0, Head.size(), Head) != 0 || Text != Body + MakeFoot(Body))
	{
		throw MakeDamageError(File);
	}
	std::istringstream Lines(Body.substr(Head.size()));
	for (std::string Line; std::getline(Lines, Line) && Line.size() > FingerprintSize;)
	{
		const std::string Fingerprint = Line.substr(0, FingerprintSize);
		const std::string Name = Line.substr(FingerprintSize + 1);
		if (!LeadsDown(Name))
		{
			throw MakeDamageError(File);
		}
		List.Add(Name, Fingerprint == NoFingerprint ? "" : Fingerprint);
	}
	return List;
}

FFileList FFileList::Make(const Files::path& Folder, const std::set<std::string>& Unsteady)
{
	FFileList List;
	for (const Files::directory_entry& Entry : Files::recursive_directory_iterator(Folder))
	{
		if (!Entry.is_directory())
		{
			const std::string Name = Entry.path().lexically_relative(Folder).generic_string();
			List.Add(Name, Unsteady.count(Name) > 0 ? "" : FingerprintFile(Entry.path().string()));
		}
	}
	return List;
}

std::string FFileList::GetText() const
{
	std::string Body = Head;
	for (const auto& [Name, Fingerprint] : Files)
	{
		Body += (Fingerprint.empty() ? NoFingerprint : Fingerprint) + " " + Name + "\n";
	}
	return Body + MakeFoot(Body);
}

void FFileList::Add(const std::string& Name, const std::string& Fingerprint)
{
	Files.emplace(Name, Fingerprint);
}

void FFileList::Add(const FFileList& Other)
{
	Files.insert(Other.Files.begin(), Other.Files.end());
}

void FFileList::Remove(const std::string& Name)
{
	std::erase_if(Files, [&](const auto& File) { return File.first == Name; });
}

bool FFileList::Has(const std::string& Name) const
{
	const auto Found = Files.lower_bound({Name, ""});
	return Found != Files.end() && Found->first == Name;
}

std::set<std::string> FFileList::GetNames() const
{
	std::set<std::string> Names;
	for (const auto& [Name, Fingerprint] : Files)
	{
		Names.insert(Name);
	}
	return Names;
}

std::string FFileList::FindFault(const Files::path& Folder, const std::string& Name) const
{
	std::error_code Ignored;
	const Files::path Path = Folder / Name;
	const Files::file_status Status = Files::symlink_status(Path, Ignored);
	if (!Has(Name))
	{
		return "is not on the list";
	}
	if (!HasOwnFolders(Folder, Name))
	{
		return "is behind a symbolic link";
	}
	if (!Files::exists(Status))
	{
		return "is missing";
	}
	if (!Files::is_regular_file(Status))
	{
		return "is not as it was written";
	}
	if (Files::file_size(Path, Ignored) == 0)
	{
		return "is empty";
	}
	const bool bAsWritten = Files.count({Name, ""}) > 0 || Files.count({Name, FingerprintFile(Path.string())}) > 0;
	return bAsWritten ? "" : "is not as it was written";
}

bool FFileList::Settle(const Files::path& Folder)
{
	bool bSettled = false;
	for (const std::string& Name : GetNames())
	{
		const auto bSameName = [&Name](const auto& Entry)
		{
			return Entry.first == Name;
		};
		if (std::count_if(Files.begin(), Files.end(), bSameName) > 1 && FindFault(Folder, Name).empty())
		{
			const std::string Fingerprint = FingerprintFile((Folder / Name).string());
			bSettled = std::erase_if(Files, [&](const auto& Entry)
						   { return bSameName(Entry) && !Entry.second.empty() && Entry.second != Fingerprint; }) > 0 ||
					   bSettled;
		}
	}
	return bSettled;
}

std::string FFileList::FindForeign(
	const Files::path& Folder, const std::string& Sub, const std::set<std::string>& Besides) const
{
	std::error_code Ignored;
	const Files::path Root = (Folder / Sub).lexically_normal();
	const Files::file_status Status = Files::symlink_status(Root, Ignored);
	if (!Files::exists(Status))
	{
		return "";
	}
	if (!Files::is_directory(Status))
	{
		return Sub;
	}
	std::set<std::string> Folders; // of the listed files
	for (const std::string& Name : GetNames())
	{
		for (Files::path Parent = Files::path(Name).parent_path(); !Parent.empty(); Parent = Parent.parent_path())
		{
			Folders.insert(Parent.generic_string());
		}
	}
	std::set<std::string> Foreign; // the first by name is told, whatever the order on the disk
	for (Files::recursive_directory_iterator Entry(Root, Files::directory_options::skip_permission_denied), End;
		 Entry != End; ++Entry)
	{
		const std::string Name = Entry->path().lexically_relative(Folder.lexically_normal()).generic_string();
		const bool bFolder = Entry->is_directory() && !Entry->is_symlink();
		if (bFolder ? Folders.count(Name) == 0 : !Has(Name) && Besides.count(Name) == 0)
		{
			Foreign.insert(Name);
		}
	}
	return Foreign.empty() ? "" : *Foreign.begin();
}

void RemoveFiles(const Files::path& Folder, const std::set<std::string>& Names)
{
	std::error_code Error;
	std::set<std::string, std::greater<>> Folders; // the inner before the outer
	for (const std::string& Name : Names)
	{
		Files::remove(Folder / Name, Error);
		if (Error)
		{
			throw MakeWriteError((Folder / Name).string(), "it cannot be removed: " + Error.message());
		}
		for (Files::path Parent = Files::path(Name).parent_path(); !Parent.empty(); Parent = Parent.parent_path())
		{
			Folders.insert(Parent.generic_string());
		}
	}
	for (const std::string& Emptied : Folders)
	{
		Files::remove(Folder / Emptied, Error); // refused where something else is in it
	}
}

} // namespace Drydock
