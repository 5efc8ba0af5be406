// Locks a folder, so that only one process at a time writes its outputs there.
#pragma once

#include "DrydockAPI.h"
#include "EndAction.h"
#include "Templates/UnrealTemplate.h"

#include <chrono>
#include <filesystem>
#include <list>

namespace Drydock
{

/** Keeps others out of a folder by .drydock.lock, a file in it that holds the number of this process and goes with the
 * lock. The lock is the system's (flock): it goes with the process, however that ends. */
class DRYDOCK_API FFolderLock : private FNoncopyable
{
public:
	/** Makes the folder where there is none. Wait: for another process that has it. Throws FError (exit code 3):
	 * another process still has it (DD5021, with its number), or it cannot be written. */
	explicit FFolderLock(const std::filesystem::path& InFolder, std::chrono::seconds Wait = {});
	/** Folders that it made and that hold nothing go, too. */
	~FFolderLock();

private:
	void MakeFolders();
	/** False: another process has taken folder or lock away meanwhile, so try again. */
	bool TryLock(std::chrono::steady_clock::time_point WaitEnd);

	const std::filesystem::path Folder;
	const std::filesystem::path Path;
	std::list<std::filesystem::path> Made; // the innermost first
	int File = -1;
	FEndAction Removal;
};

} // namespace Drydock
