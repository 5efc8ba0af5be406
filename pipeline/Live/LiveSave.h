// The state of a session as files and as text to copy.
#pragma once

#include "Text/Json.h"

#include <string>

namespace Drydock
{

class FLiveSession;

/** Writes the state's config. Request: {"path", "again"}. The path is relative to the config's folder, or absolute; it
 * lies in that folder or, where one was given, in the folder of outputs, and ends in .json. In another folder, paths of
 * files are written so that they lead from there. Returns {"saved": path}. Throws FError: DD1121 for any other place,
 * DD1124 where there is such a file and "again" is not true, exit code 3 where it cannot be written. */
std::string SaveConfig(FLiveSession& Session, const FJsonValue& Request);

/** The state as text. Asked: "as", which is "config", "engine" (actors to paste into the editor), "lines" (the changes
 * since the start: JSON lines of edits) or "variables" (r.X=Y, a line each). Throws FError (DD1120) for another word.
 */
std::string MakeLiveText(FLiveSession& Session, const FJsonValue& Asked);

} // namespace Drydock
