// Holds a sweep as the member "sweep" of a config describes it. Its keys are in ConfigKeys.txt.
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
	int NumFrames = 1;      // of a piece
	int Lead = 0;           // frames before each piece that are rendered for their history
	bool bCheckAll = false; // every cut is rendered unsplit, too; else the first alone
};

struct FSweep
{
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
	bool bExr = false;                     // results keep final.exr, too
	bool bMeasure = true;                  // the figures of effects
};

/** Names of an axis beside settings, console variables and places of the config: scene, frames, engine, plugin,
 * overlay, resolution (percent), precision, storage. */
DRYDOCK_API const std::vector<std::string>& GetSweepNames();

/** Every mistake that can be found beside those of types and keys, which reading the config reports, is appended to
 * Diagnostics, in the order of the file. Console variables of plugins must be there. */
DRYDOCK_API FSweep ReadSweep(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
