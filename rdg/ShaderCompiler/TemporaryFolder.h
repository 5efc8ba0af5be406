// A folder for the files of one compilation, gone with its scope, and with the next run where the process was killed.
#pragma once

#include "DrydockAPI.h"
#include "EndAction.h"
#include "FileDescriptor.h"

#include <optional>
#include <string>
#include <sys/types.h>

namespace Drydock
{

/** Where temporary files go: TMPDIR, TMP, TEMP or TEMPDIR, the first that is set; else /tmp. */
DRYDOCK_API std::string GetTemporaryParent();

/** A folder drydock-PROCESS-RANDOM in GetTemporaryParent() that only the user can look into. */
class DRYDOCK_API FTemporaryFolder
{
public:
	/** Throws FError (DD5004, exit code 3) with the folder that does not take it. */
	FTemporaryFolder();
	~FTemporaryFolder();
	FTemporaryFolder(const FTemporaryFolder&) = delete;
	FTemporaryFolder& operator=(const FTemporaryFolder&) = delete;

	/** A new file, for the user alone. Returns its path; throws FError (DD5004, exit code 3) unless all is written. */
	std::string WriteFile(const std::string& Name, const std::string& Bytes) const;

	/** After something else failed that should have written here. Throws FError (DD5004, exit code 3) when nothing can
	 * be written, as on a full disk. */
	void CheckSpace() const;

	std::string Path;

private:
	FFileDescriptor Lock; // tells other processes, whatever numbers they see, that this one lives
	pid_t Owner;          // a child that forked off removes nothing
	std::optional<FEndAction> Removal;
};

} // namespace Drydock
