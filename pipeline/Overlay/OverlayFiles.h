// Makes a new overlay's files, and compares an overlay's files with those that it began with.
#pragma once

#include "Overlay/OverlayFolder.h"
#include "Patch/PatchTemplate.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Short names of the passes that an overlay can begin with: "BloomSetup", "Tonemap", ... */
DRYDOCK_API std::vector<std::string> ListOverlayPasses();

/** The files of a new overlay for that pass, sorted by path: the pass's shader, its C++ in the engine's form as far as
 * drydock has it, a config and a small frame. Throws FError (exit code 2) for a name that is not in the list, 3 where
 * drydock's own files are missing. */
DRYDOCK_API std::vector<FPatchFile> MakeOverlayFiles(const std::string& Name, const std::string& Pass);

/** A run of changed lines. */
struct FOverlayHunk
{
	std::string File;     // in the engine's tree
	std::string Function; // its result and name, or that of a struct; empty: the hunk stands outside
	std::string Lines;    // each with - or + before it
	bool bOwn = false;    // it touches something of drydock's own
};

/** As a unified diff without line numbers: each file's name once, the function's name in the head of a hunk. */
DRYDOCK_API std::string FormatHunks(const std::vector<FOverlayHunk>& Hunks);

struct FOverlayDifference
{
	std::vector<FOverlayHunk> Hunks;
	std::vector<std::string> NewFiles; // that drydock has no text of; all of their lines are added ones
};

/** Compares the overlay's files with drydock's. Throws FError (exit code 3) where `diff` cannot be started. */
DRYDOCK_API FOverlayDifference CompareOverlay(const FOverlayFolder& Folder);

} // namespace Drydock
