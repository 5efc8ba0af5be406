// The state of a session as files and as text to copy.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

class FLiveSession;

enum class ELiveSave
{
	Done,
	Exists, // and nobody asked to replace it
};

/** Writes the state's config. Path: relative to the config's folder, or absolute; it lies in that folder or, where one
 * was given, in the folder of outputs, and ends in .json. In another folder, paths of files are written so that they
 * lead from there. Throws FError: DD1121 for any other place, exit code 3 where it cannot be written. */
ELiveSave SaveConfig(FLiveSession& Session, const std::string& Path, bool bAgain);

/** The state as text. As: "config", "engine" (actors to paste into the editor), "lines" (the changes since
 * the start: JSON lines of edits), "variables" (r.X=Y, a line each). Throws FError (DD1120) for another word. */
std::string MakeLiveText(FLiveSession& Session, const std::string& As);

} // namespace Drydock
