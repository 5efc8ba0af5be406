// A file or folder that is written beside its place and takes the place in one step, so that nobody ever sees half of
// it.
#pragma once

#include "Diagnostics.h"
#include "MarkedFolder.h"
#include "Templates/UnrealTemplate.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace Drydock
{

/** "cannot be written: Why", with exit code 3. */
DRYDOCK_API FError MakeWriteError(const std::string& Path, const std::string& Why);

/** A path to write a file or a folder to that does not exist yet: by its own name, in the folder NAME.writing.XXXXXX
 * beside it (MarkedFolder.h). A file that was not put in place goes away with the object, or when a signal ends the
 * process; after any other end with the next aside file for that place. Nothing is synchronised with the disk: after a
 * power failure the latest files may be empty. */
class DRYDOCK_API FAsideFile : private FNoncopyable
{
public:
	/** Target: the place that it is for, whose folder is made. Throws FError (exit code 3) when that cannot be done. */
	explicit FAsideFile(const std::filesystem::path& InTarget);

	/** Write here. Nothing is there yet. */
	const std::filesystem::path& GetPath() const { return Path; }

	/** Renames it to Target; a file that is there is replaced. Throws FError (exit code 3) when that fails. */
	void PutInPlace();

	/** Removes what processes that have ended since were writing in Folder for the names that IsWanted takes. */
	static void RemoveAbandoned(
		const std::filesystem::path& Folder, const std::function<bool(const std::string& Name)>& IsWanted);

private:
	const std::filesystem::path Target;
	std::unique_ptr<const FMarkedFolder> Aside;
	std::filesystem::path Path;
};

} // namespace Drydock
