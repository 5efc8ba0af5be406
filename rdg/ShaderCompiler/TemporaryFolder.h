// A folder for the files of one compilation, gone with its scope, or with the process when a signal ends that.
#pragma once

#include "DrydockAPI.h"
#include "EndAction.h"

#include <optional>
#include <string>

namespace Drydock
{

/** drydock-PROCESS-XXXXXX in the system's folder for temporary files, for this user alone. The first one of a process
 * removes those that processes of this user have left which were killed. */
class DRYDOCK_API FTemporaryFolder
{
public:
	FTemporaryFolder();
	~FTemporaryFolder();
	FTemporaryFolder(const FTemporaryFolder&) = delete;
	FTemporaryFolder& operator=(const FTemporaryFolder&) = delete;

	std::string Path; // empty: none could be made

private:
	int Lock = -1; // of the folder: nobody else takes it for abandoned
	std::optional<FScratchPath> Scratch;
};

} // namespace Drydock
