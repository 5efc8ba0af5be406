// A file or folder that is written beside its place and takes the place in one step, so that nobody ever sees half of
// it.
#pragma once

#include "Diagnostics.h"
#include "EndAction.h"

#include <filesystem>
#include <optional>
#include <string>

namespace Drydock
{

/** "cannot be written: Why", with exit code 3. */
DRYDOCK_API FError MakeWriteError(const std::string& Path, const std::string& Why);

/** Where to write a file or a folder that is not there yet: NAME.writing.PROCESS.EXTENSION beside it. What was not put
 * in place goes away with the object, or when a signal ends the process; after any other end with the next aside file
 * for that place. Nothing is synchronised with the disk: who pulls the plug may find the latest files empty. */
class DRYDOCK_API FAsideFile
{
public:
	/** Target: the place that it is for, whose folder is made. The name beside it keeps the extension, by which image
	 * files know their format. Throws FError (exit code 3) when the folder cannot be made. */
	explicit FAsideFile(const std::filesystem::path& InTarget);
	FAsideFile(const FAsideFile&) = delete;
	FAsideFile& operator=(const FAsideFile&) = delete;

	/** Write here. Nothing is there yet. */
	const std::filesystem::path& GetPath() const { return Path.Get(); }

	/** Renames it to Target; a file that is there is replaced. Throws FError (exit code 3) when that fails. */
	void PutInPlace();

	/** The place that a path was for, which a process that has ended since was writing; none where it is no such path.
	 */
	static std::optional<std::filesystem::path> FindAbandonedTarget(const std::filesystem::path& Path);

private:
	const std::filesystem::path Target;
	const FScratchPath Path;
};

} // namespace Drydock
