// Hashes all that the result of a task depends on. A file is read once for all tasks.
#pragma once

#include "Config/Config.h"
#include "Sweep/SweepPlan.h"

#include <map>
#include <string>

namespace Drydock
{

class FSweepInputs
{
public:
	/** Plan must outlive this. bInPlanning: code that tasks name is not loaded into this process, but runs in one of
	 * its own; else all tasks that are asked for must name the same code. */
	FSweepInputs(const FSweepPlan& InPlan, bool bInPlanning)
		: Plan(InPlan)
		, bPlanning(bInPlanning)
	{
	}

	/** The config with the scene that the task names. Throws FError: mistakes, missing files, code that does not run.
	 */
	const FConfig& Prepare(const FSweepTask& Task) { return Find(Task).Config; }

	/** A hash of the config without its sweep, the files that it names, shaders, plugins, overlays, drydock's build,
	 * the task's own values and its frames' files. Throws FError as Prepare, or where a frame is missing. */
	std::string Hash(const FSweepTask& Task);

	/** The inputs that Prepare found, by the files that tasks name: "scene a.exr, plugin b.so". */
	std::map<std::string, FRunInputs> GetInputs() const;

	static std::string NameFiles(const FSweepTask& Task);

	/** Whether it names a plugin or an overlay. */
	static bool NamesCode(const FSweepTask& Task);

private:
	struct FKnown
	{
		FConfig Config;
		FRunInputs Inputs;
		std::map<int, std::string> Frames; // paths by number
	};

	const FKnown& Find(const FSweepTask& Task);

	const FSweepPlan& Plan;
	const bool bPlanning;
	std::map<std::string, FKnown> Known;
	std::map<std::string, std::string> FrameFingerprints; // by path
};

} // namespace Drydock
