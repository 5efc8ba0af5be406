// Hashes all that the result of a task depends on. A file is read once for all tasks.
#pragma once

#include "Config/Config.h"
#include "Config/FrameSequence.h"
#include "Sweep/SweepPlan.h"

#include <map>
#include <string>
#include <vector>

namespace Drydock
{

class FSweepInputs
{
public:
	/** Plan: whose config, task and outputs are looked at; it must outlive this. */
	explicit FSweepInputs(const FSweepPlan& InPlan);

	/** The config of a task with the files that the task names. Throws FError: mistakes of the config, missing files. */
	const FConfig& GetConfig(const FSweepTask& Task);

	/** Reads what the task names beside frames. The plugins of one task bring shaders that others see: whoever compares
	 * hashes prepares all tasks of a plan in their order before the first hash. Throws FError as GetConfig. */
	void Prepare(const FSweepTask& Task) { Find(Task); }

	/** The task's hash: of the config and the files that it names, shaders, plugins, overlays, drydock's build, the
	 * task's own values and its frames' files. Throws FError as GetConfig, or where a frame's file is missing. */
	std::string Hash(const FSweepTask& Task);

	/** Of all that was asked for so far: the inputs of a config, by the files that tasks name beside it. */
	std::map<std::string, FRunInputs> GetInputs() const;

private:
	struct FKnown
	{
		FConfig Config;
		FRunInputs Inputs;
		std::map<int, std::string> Frames; // paths by number
		std::string Text;                  // of Inputs
	};

	FKnown& Find(const FSweepTask& Task);
	const std::string& FindFile(const std::string& Path);

	const FSweepPlan& Plan;
	std::map<std::string, FKnown> Known;
	std::map<std::string, std::string> FileFingerprints; // by path
};

/** The files that a task names beside the config: "scene a.exr, plugin b.so"; empty: none. */
std::string NameTaskFiles(const FSweepTask& Task);

} // namespace Drydock
