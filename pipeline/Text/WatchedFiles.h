// Files whose change makes `run --watch` run again.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace Drydock
{

/** Times of last change, taken when a file is added. Equal when no file appeared, went away or changed. */
class FWatchedFiles
{
public:
	/** A file that does not exist is watched for appearing. */
	void AddFile(const std::string& Path);

	/** Every .usf and .ush under the mapped shader folders. */
	void AddShaders();

	/** Ascending. */
	std::vector<std::string> GetPaths() const;

	bool operator==(const FWatchedFiles&) const = default;

private:
	std::map<std::string, int64_t> Times;
};

} // namespace Drydock
