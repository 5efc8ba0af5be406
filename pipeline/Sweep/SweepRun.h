// Runs tasks one after another in this process. What tasks share (shaders, a scene, a session) is kept between them.
#pragma once

#include "DrydockAPI.h"
#include "Sweep/SweepFolder.h"
#include "Sweep/SweepPlan.h"
#include "Templates/UnrealTemplate.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace Drydock
{

class FSceneCache;
class FRunSession;

class DRYDOCK_API FSweepRunner : private FNoncopyable
{
public:
	/** Threads: as of FRunOptions. */
	FSweepRunner(const FSweepPlan& InPlan, std::optional<int> InThreads);
	~FSweepRunner();

	/** Runs the task and writes its files into Folder, which is there and empty: result.json and pictures. The same task
	 * gives the same bytes, whatever ran before. Returns what it took. Throws FError: what the run throws; a file that
	 * cannot be written. MaxFrames: so many frames at most, to measure; 0: all. */
	FSweepTime Run(const FSweepTask& Task, const std::filesystem::path& Folder, size_t MaxFrames = 0);

private:
	FRunOptions MakeOptions(const FSweepTask& Task) const;
	void RunFrames(const FSweepTask& Task, const std::filesystem::path& Folder, size_t MaxFrames);
	std::string RunStudy(const FSweepTask& Task, const std::filesystem::path& Folder);
	void RunHazards(const FSweepTask& Task, const std::filesystem::path& Folder);
	FRunSession& Begin(const FSweepTask& Task);

	const FSweepPlan& Plan;
	const std::optional<int> Threads;
	const std::shared_ptr<FSceneCache> SceneCache;
	std::unique_ptr<FRunSession> Session; // of the last task
	std::vector<std::pair<std::string, std::string>> SessionSet;
};

/** Measures the first task of a plan, with the plan's folder for its files, which go away: of frames the first one, once
 * shaders are compiled. Throws FError as FSweepRunner::Run. */
DRYDOCK_API FSweepCost MeasureSweep(const FSweepPlan& Plan, const FSweepFolder& Folder);

/** The picture of a frame in a result: "final.png", of a sequence "0012.png". Frame: empty of a scene of one frame. */
DRYDOCK_API std::string NameSweepPicture(std::optional<int> Frame, const char* Extension);

} // namespace Drydock
