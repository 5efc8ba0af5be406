// Shows how errors look, for a few jobs of a study: the reference and three variants, each over a map of its error. The
// recommended variant and the one in use come first, then those of the front and of the largest errors.
#pragma once

#include "Study/StudyInsetSheet.h"
#include "Study/StudyRun.h"

namespace Drydock
{

/** Runs what is shown once more. Writes PNGs to Folder/insets, parts of the pictures around the largest error, and
 * gives them for DrawStudyInsets; for a folder that is not seen yet. Throws FError (exit code 3) when a file
 * cannot be written. */
DRYDOCK_API std::vector<FStudyInsetRow> WriteStudyInsets(
	FStudyRun& Run, const FStudyResult& Result, const std::string& Folder);

} // namespace Drydock
