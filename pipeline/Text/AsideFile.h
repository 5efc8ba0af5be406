// A file or folder that is written beside its place and takes the place in one step, so that nobody ever sees half of
// it.
#pragma once

#include "Diagnostics.h"

#include <filesystem>
#include <string>

namespace Drydock
{

/** "cannot be written: Why", with exit code 3. */
DRYDOCK_API FError MakeWriteError(const std::string& Path, const std::string& Why);

/** Where to write a file or a folder that is not there yet. What was not put in place goes away with the object. */
class DRYDOCK_API FAsideFile
{
public:
	/** Target: the place that it is for, whose folder is made. The name beside it keeps the extension, by which image
	 * files know their format. Throws FError (exit code 3) when the folder cannot be made. */
	explicit FAsideFile(const std::filesystem::path& InTarget);
	~FAsideFile();
	FAsideFile(const FAsideFile&) = delete;
	FAsideFile& operator=(const FAsideFile&) = delete;

	/** Write here. Nothing is there yet. */
	const std::filesystem::path& GetPath() const { return Path; }

	/** Renames it to Target; a file that is there is replaced. Throws FError (exit code 3) when that fails. */
	void PutInPlace();

	/** Whether it is a path of a file or folder that was being written when its process ended. */
	static bool IsAside(const std::filesystem::path& Path);

private:
	const std::filesystem::path Target;
	const std::filesystem::path Path;
};

} // namespace Drydock
