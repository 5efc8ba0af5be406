// A sweep expanded into tasks: plain data, which a folder keeps as plan.json and tasks.jsonl.
#pragma once

#include "Budget/RunOptions.h"
#include "DrydockAPI.h"
#include "Run/RunInputs.h"
#include "Sweep/SweepConfig.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Drydock
{

struct FSweepTask
{
	std::string Hash; // 32 hexadecimal digits, of all that the result depends on
	std::vector<std::string> Values; // labels, axis by axis of the plan; "" on the axis "piece": of an unsplit cut
	std::vector<std::pair<std::string, std::string>> Set; // names and values, the config's patch
	std::string Frames;     // of a sequence, in order (FrameList.h); empty: the scene's one frame
	std::string LeadFrames; // rendered before them for their history, and not written; empty: none
	bool bUnsplit = false;  // a cut in one, which its pieces are compared with
};

struct FSweepAxis
{
	std::string Name; // as in the sweep; "piece" of a cut in pieces
	std::vector<std::string> Values;
};

/** The measured cost of one frame, or of a whole task that is not of frames. */
struct FSweepCost
{
	double Seconds = 0.0; // on one process with all cores
	uint64_t Bytes = 0;   // of the results
};

struct FSweepPlan
{
	std::string Config; // path, absolute
	ESweepTask Task = ESweepTask::Run;
	std::string Pass; // of hazards
	bool bExr = false;
	bool bMeasure = true;
	std::vector<FSweepAxis> Axes;
	std::vector<std::pair<std::string, std::string>> Against; // names and values
	std::vector<FSweepTask> Tasks;
	std::map<std::string, FRunInputs> Inputs; // by the files that a task names (FSweepInputs)
	FSweepCost Cost;

	/** Seconds that all tasks take, one after another. */
	DRYDOCK_API double GetSeconds() const;
	DRYDOCK_API uint64_t GetBytes() const;
};

/** Frames that a task renders, those before its first among them. 1 of a task that is not of frames. */
DRYDOCK_API size_t CountRendered(const FSweepTask& Task);

/** The numbers of a list of frames; empty for an empty one. */
DRYDOCK_API std::vector<int> ListTaskFrames(const std::string& List);

/** Options of a run that does what the task says. */
DRYDOCK_API FRunOptions MakeTaskOptions(const FSweepPlan& Plan, const FSweepTask& Task);

/** The value that a task sets a name to; empty: it does not. */
DRYDOCK_API std::string GetTaskValue(const FSweepTask& Task, const std::string& Name);

/** "BloomIntensity 2, engine 5.6": the task by its values. */
DRYDOCK_API std::string DescribeTask(const FSweepPlan& Plan, const FSweepTask& Task);

/** What a sweep of these axes would have, before anything is looked at: the product of the axes. */
DRYDOCK_API size_t CountCombinations(const FSweep& Sweep);

/** The tasks of a sweep, with hashes and without a cost. Remarks on axes that change nothing are appended to
 * Diagnostics. Throws FError with all mistakes that the config and the values of the axes make, each at its place in the
 * sweep. */
DRYDOCK_API FSweepPlan PlanSweep(const FSweep& Sweep, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
