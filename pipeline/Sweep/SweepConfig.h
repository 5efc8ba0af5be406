// Holds a sweep as its JSON file describes it, and reads it. docs/sweeps.md describes the keys.
#pragma once

#include "Budget/StudyConfig.h"
#include "DrydockAPI.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** What a task does. */
enum class ESweepTask
{
	Run,     // a frame, or frames in order
	Study,   // the study of the config
	Hazards, // the hazards of the stability table
};

/** "run", "study", "hazards", in the order of ESweepTask. */
DRYDOCK_API const std::vector<std::string>& GetSweepTaskNames();

/** A long cut in pieces. */
struct FSweepSplit
{
	int NumFrames = 0;      // of a piece, at least 1
	int Lead = 0;           // frames before each piece that are rendered for their history
	bool bCheckAll = false; // every cut is rendered unsplit, too; else the first alone
};

struct FSweep
{
	std::string File;   // of the sweep
	std::string Config; // path of the config
	ESweepTask Task = ESweepTask::Run;
	std::string Pass;   // of hazards: pattern; empty: all passes of plugins
	std::string Frames; // a list (FrameList.h); empty: the config's
	FConfigPlace FramesPlace;
	int Lead = 0; // frames before the first that are rendered for their history
	std::optional<FSweepSplit> Split;
	bool bList = false;           // one axis, "case", whose values are the entries of a list
	std::vector<FStudyAxis> Axes; // their values are combined, the last axis the fastest
	std::vector<std::vector<FStudyAssignment>> Exclude;
	std::vector<FStudyAssignment> Against; // the variant that errors are measured against: values of some axes
	FConfigPlace AgainstPlace;
	bool bExr = false;    // results keep final.exr, too
	bool bMeasure = true; // the figures of effects
};

/** Names of an axis beside settings, console variables and places of the config: scene, frames, engine, plugin,
 * overlay, resolution (percent), precision, storage. */
DRYDOCK_API const std::vector<std::string>& GetSweepNames();

/** The part of reading that needs nothing of plugins: the config's path. Nothing: the file has none, which is in
 * Diagnostics. */
DRYDOCK_API std::optional<std::string> ReadSweepConfigPath(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics);

/** All of it. Every mistake that can be found is appended to Diagnostics, in the order of the file. Console variables of
 * plugins must be there. */
DRYDOCK_API FSweep ReadSweep(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
