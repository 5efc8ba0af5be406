// The folder that a verb writes its outputs to: they replace those of an earlier call all at once, and nothing that
// drydock did not write is ever replaced or removed.
#pragma once

#include "DrydockAPI.h"
#include "Text/AsideFile.h"
#include "Text/FileList.h"
#include "Text/FolderLock.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace Drydock
{

/** The names that a verb writes into a folder, where other verbs' outputs and the user's own files may lie beside them.
 */
struct FOutputNames
{
	std::string Name;                 // of the verb: its list is .drydock.NAME.files
	std::vector<std::string> Files;   // that it writes unless it is asked for less; it may write others, too
	std::string Last;                 // of these: it goes first and comes last, so that where it is, all is there
	std::vector<std::string> Folders; // that hold its outputs and nothing else
	std::set<std::string> Unsteady;   // files whose bytes differ from run to run (FFileList::Make)
};

/** "X is not drydock's ...", with exit code 2. Path: what is in the way. */
DRYDOCK_API FError MakeForeignError(const std::filesystem::path& Path, const std::string& Why);

class DRYDOCK_API FOutputFolder
{
public:
	/** Locks the folder, which is made where there is none. Throws FError: something that drydock did not write, or
	 * that was changed since, is in the way (DD1080, exit code 2); the folder is in use, its list is damaged, or it
	 * cannot be written (3). Then nothing was written. */
	FOutputFolder(const std::filesystem::path& InFolder, const FOutputNames& InNames);

	const std::filesystem::path& GetPath() const { return Folder; }

	/** The folder to write to, inside the output folder. Its files become the outputs when PutInPlace is called. */
	const std::filesystem::path& GetAside() const { return Aside.GetPath(); }

	/** Replaces the outputs of the call before. Throws FError as the constructor. */
	void PutInPlace();

private:
	std::filesystem::path GetListPath() const;
	void WriteList(const FFileList& List) const;
	/** Throws where a file of this name is there that drydock did not write like that. */
	void RequireOwn(const std::string& Name) const;
	void RequireOwnFolders() const;

	const std::filesystem::path Folder;
	const FOutputNames Names;
	const FFolderLock Lock;
	const FFileList Before; // what stands in the folder
	FAsideFile Aside;
};

} // namespace Drydock
