// Writes the outputs of a run into a folder. Everything is written aside first and renamed when it is complete, so that
// nobody ever sees half a run.
#pragma once

#include "Run/RunResult.h"
#include "Text/OutputFolder.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace Drydock
{

/** final.png, final.exr, scene_linear.exr, run.json, timing.json, graph.dot, trace.json, report.html and passes/, of
 * which FRunResult::Write chooses those to write; run.json is always written. inspect/ holds the results of shader
 * inspection. */
DRYDOCK_API const FOutputNames& GetRunOutputNames();

/** Writes final.exr alone: the picture's numbers, encoded for its device. Throws FError (exit code 3). */
DRYDOCK_API void WriteFinalExr(const FRunResult& Result, const std::string& File);

/** Called when all other files lie in Aside and writing them took SaveMs; what it writes there are outputs, too. */
using FFurtherOutputs = std::function<void(const std::filesystem::path& Aside, double SaveMs)>;

/** These files, and those of effects that were measured, in place of an earlier run's. Returns the milliseconds it
 * took. Throws FError: something else is in the way (exit code 2), or a file cannot be written (3); then the folder is
 * as it was. */
DRYDOCK_API double WriteRunOutputs(
	const FRunResult& Result, FOutputFolder& Folder, const FFurtherOutputs& Further = nullptr);

/** The same into the folder of this path. Throws FError as FOutputFolder, too. */
DRYDOCK_API double WriteRunOutputs(const FRunResult& Result, const std::string& Folder);

/** In a folder that WriteNewRunFolder wrote: the list of its files (FFileList). */
inline constexpr const char* RunFolderListName = ".drydock.frame.files";

/** The same files into a folder that is not there yet and appears complete, with further files (name to contents) in
 * it. Throws FError (exit code 3): it is there, or it cannot be written. */
DRYDOCK_API double WriteNewRunFolder(
	const FRunResult& Result, const std::string& Folder, const std::map<std::string, std::string>& Further);

} // namespace Drydock
