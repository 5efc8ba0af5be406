// Makes folders for files that are written aside. A mark in the folder proves its owner, so that a later process can
// remove what a killed one has left behind, and nothing else.
#pragma once

#include "DrydockAPI.h"
#include "EndAction.h"
#include "FileDescriptor.h"

#include <functional>
#include <string>
#include <sys/types.h>

namespace Drydock
{

/** A new folder that only the user can look into. It goes with its scope, and when a signal ends the process; after any
 * other end RemoveAbandonedFolders removes it. The file .drydock.mark in it holds the numbers of the folder and of
 * itself, which no copy has, and lists what may be removed. A lock on the mark shows that the process lives. Other
 * things in the folder stay. A process that is killed between two steps may leave the folder empty. */
class DRYDOCK_API FMarkedFolder : private FNoncopyable
{
public:
	/** Begin: its path but for the last six characters, which are random. Throws std::system_error. */
	explicit FMarkedFolder(const std::string& Begin);
	~FMarkedFolder();

	const std::string& GetPath() const { return Path; }

	/** The path of a file or folder that is to be made in it, and that is removed with it. Throws std::system_error. */
	std::string Reserve(const std::string& Name) const;

private:
	void Remove(const std::string& From) const;

	std::string Path;
	FFileDescriptor Folder;
	FFileDescriptor Mark;
	pid_t Owner; // a child that forked off removes nothing
	FEndAction Removal;
};

/** Removes the folders in Parent that processes which are dead have made, and whose name without its last six
 * characters IsBegin takes. A folder that cannot be removed stays. */
DRYDOCK_API void RemoveAbandonedFolders(
	const std::string& Parent, const std::function<bool(const std::string& Begin)>& IsBegin);

} // namespace Drydock
