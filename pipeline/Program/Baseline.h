// Baselines: the pictures of a run that a person accepted, with a record by which a comparison knows that nobody
// changed them since.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Whether the folder has the record of a baseline. */
DRYDOCK_API bool IsBaseline(const std::string& Folder);

/** Copies pictures of a run's folder into a baseline in place of what it held, and writes its record, baseline.json.
 * Files: relative to Run. Because: the reason that the person gives. Throws FError (exit code 3) for what cannot be
 * read or written. */
DRYDOCK_API void WriteBaseline(const std::string& Run, const std::string& Folder, const std::vector<std::string>& Files,
	const std::string& Because);

/** Throws FError (exit code 2), DD5036: the folder has no record, a file is not the one that was blessed, or a file is
 * missing or was added. */
DRYDOCK_API void CheckBaseline(const std::string& Folder);

} // namespace Drydock
