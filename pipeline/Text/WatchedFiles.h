// Files whose change makes `run --watch` run again.
#pragma once

#include "DrydockAPI.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** The system's data about files when they are added: the file's identity, its size, and when it or its permissions
 * last changed. Equal when no file appeared, went away or changed. */
class DRYDOCK_API FWatchedFiles
{
public:
	/** A file that does not exist is watched for appearing. */
	void AddFile(const std::string& Path);

	/** Every .usf and .ush under the mapped shader folders. */
	void AddShaders();

	/** Those of Others that are not there yet. */
	void AddUnknown(const FWatchedFiles& Others);

	/** The files that differ from Before, ascending; nothing where a file has come or gone. */
	std::optional<std::vector<std::string>> FindEdited(const FWatchedFiles& Before) const;

	/** Ascending. */
	std::vector<std::string> GetPaths() const;

	bool operator==(const FWatchedFiles&) const = default;

private:
	std::map<std::string, std::array<int64_t, 3>> States;
};

} // namespace Drydock
