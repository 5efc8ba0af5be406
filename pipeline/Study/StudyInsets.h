// What errors look like: for a few jobs of a study the reference, what is recommended, what is in use and the cheapest
// of the front, each with a map of its error. Source: drydock.
#pragma once

#include "Study/StudyChart.h"

#include "RunOptions.h"

namespace Drydock
{

/** Runs what is shown once more. Writes PNGs to Folder/insets, parts of the pictures around the largest error, and
 * gives them for DrawStudyInsets; Folder/insets of an earlier study goes. Throws FError (exit code 3) when a file
 * cannot be written. */
DRYDOCK_API std::vector<FStudyInsetRow> WriteStudyInsets(
	const FRunOptions& Options, const FStudyResult& Result, const std::string& Folder);

} // namespace Drydock
