// Makes a folder for the files of one compilation. It is removed with its scope, or by the next run if the process was
// killed.
#pragma once

#include "DrydockAPI.h"
#include "MarkedFolder.h"

#include <string>

namespace Drydock
{

/** "drydock-4711-" for process 4711: how the names of its temporary folders begin. */
DRYDOCK_API std::string MakeTemporaryName();

/** Removes the folders of such names in Parent that dead processes have left. */
DRYDOCK_API void RemoveTemporaryFolders(const std::string& Parent);

/** The folder of temporary files: TMPDIR, TMP, TEMP or TEMPDIR, the first that is set; else /tmp. */
DRYDOCK_API std::string GetTemporaryParent();

/** A folder drydock-PROCESS-RANDOM in GetTemporaryParent() that only the user can look into. */
class DRYDOCK_API FTemporaryFolder
{
public:
	/** Throws FError (DD5004, exit code 3) with the folder that does not take it. */
	FTemporaryFolder();

	/** The path of a file or folder that the caller is to make here; no other name in it is removed. */
	std::string Reserve(const std::string& Name) const;

	/** A new file, for the user alone. Returns its path; throws FError (DD5004, exit code 3) unless all is written. */
	std::string WriteFile(const std::string& Name, const std::string& Bytes) const;

	/** Called after a program failed that should have written here. Throws FError (DD5004, exit code 3) when nothing
	 * can be written, as on a full disk. */
	void CheckSpace() const;

private:
	const FMarkedFolder Folder;
};

} // namespace Drydock
