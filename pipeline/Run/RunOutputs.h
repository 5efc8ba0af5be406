// Writes what a run made into a folder. Everything is written aside first and renamed when it is complete, so that
// nobody ever sees half a run.
#pragma once

#include "Run/RunResult.h"

#include <map>
#include <string>

namespace Drydock
{

/** final.png, final.exr, scene_linear.exr, run.json, timing.json, graph.dot, trace.json and passes/. What the folder
 * holds beside these stays; a passes/ of an earlier run goes. Returns the milliseconds it took. Throws FError (exit
 * code 3); then the folder is as it was. */
DRYDOCK_API double WriteRunOutputs(const FRunResult& Result, const std::string& Folder);

/** The same into a folder that is not there yet and appears complete, with further files (name to contents) in it.
 * Throws FError (exit code 3): it is there, or it cannot be written. */
DRYDOCK_API double WriteNewRunFolder(
	const FRunResult& Result, const std::string& Folder, const std::map<std::string, std::string>& Further);

} // namespace Drydock
