// A sweep as tasks: plain data, which a folder keeps as plan.json and tasks.jsonl.
#pragma once

#include "Budget/RunOptions.h"
#include "DrydockAPI.h"
#include "Run/RunInputs.h"
#include "Text/Json.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Drydock
{

using FSweepSet = std::vector<std::pair<std::string, std::string>>; // names and values

struct FSweepTask
{
	std::string Hash;                // 32 hexadecimal digits, of all that the result depends on
	std::vector<std::string> Values; // labels, axis by axis of the plan; "" on the axis "piece": of the unsplit cut
	FSweepSet Set;                   // the config's patch
	std::string Frames;              // of a sequence (FrameList.h); empty: the scene's one frame
	std::string LeadFrames;          // rendered before them for their history, and not written; empty: none
	bool bUnsplit = false;           // a whole cut, which its pieces are compared with
};

struct FSweepAxis
{
	std::string Name; // as in the config; "piece" where frames are cut into pieces
	std::vector<std::string> Values;
};

struct FSweepPlan
{
	std::string Config;   // path, absolute
	std::string Kind;     // of tasks: "run", "study", "hazards"
	std::string Pass;     // of hazards: pattern; empty: all passes of plugins
	bool bExr = false;    // results keep final.exr, too
	bool bMeasure = true; // the figures of effects
	std::vector<FSweepAxis> Axes;
	FSweepSet Against; // values of some axes: errors are measured against the task that has them
	std::vector<FSweepTask> Tasks;
	std::map<std::string, FRunInputs> Inputs; // by the files that tasks name (FSweepInputs)
	double SecondsPerFrame = 0.0;             // measured, on all cores; of a study or hazards: per task
	uint64_t BytesPerFrame = 0;               // of results

	DRYDOCK_API double GetSeconds() const; // of all tasks, one after another
	DRYDOCK_API uint64_t GetBytes() const;
};

/** The numbers of a list of frames; none of an empty one. */
DRYDOCK_API std::vector<int> ListTaskFrames(const std::string& List);

/** Options of a run that does what the task says. */
DRYDOCK_API FRunOptions MakeTaskOptions(const FSweepPlan& Plan, const FSweepSet& Set);

/** "BloomIntensity 2, engine 5.6": the task by its values. Without: an axis that is left out; -1: none. */
DRYDOCK_API std::string DescribeTask(const FSweepPlan& Plan, const FSweepTask& Task, int Without = -1);

/** The object that the text is; nothing where it is not one. */
std::optional<FJsonValue> ParseSweepJson(const std::string& Text);

} // namespace Drydock
