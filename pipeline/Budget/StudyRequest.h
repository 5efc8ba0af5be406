// Turns a study's assignments into options of a run, and makes the hash by which a later run knows what was studied.
#pragma once

#include "Budget/RunOptions.h"
#include "Budget/StudyConfig.h"

namespace Drydock
{

/** Hash of what was studied: of a config's members without budget, outputs, sweep and $schema; comments and blanks
 * do not count.
 */
DRYDOCK_API std::string GetStudyFingerprint(const std::string& ConfigText);

/** Text of the config that Options name. Throws FError (exit code 3) when it cannot be read. */
DRYDOCK_API std::string GetConfigText(const FRunOptions& Options);

/** Sets these assignments as options of a run. */
DRYDOCK_API void ApplyToRun(const std::vector<FStudyAssignment>& Set, FRunOptions& Options);

} // namespace Drydock
