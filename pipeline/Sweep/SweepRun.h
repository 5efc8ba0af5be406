// Runs tasks one after another in this process. Shaders, a scene and a session that tasks share are kept.
#pragma once

#include "DrydockAPI.h"
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
	/** Plan must outlive this. Threads: as of FRunOptions. */
	FSweepRunner(const FSweepPlan& InPlan, std::optional<int> InThreads);
	~FSweepRunner();

	/** Runs the task and writes its files into Folder, which is there and empty: result.json and pictures. The same
	 * task gives the same bytes, whatever ran before. Returns study_timing.json of a study, else nothing. Throws
	 * FError: what the run throws; a file that cannot be written. bFirstAlone: only the first frame, to measure. */
	std::string Run(const FSweepTask& Task, const std::filesystem::path& Folder, bool bFirstAlone = false);

private:
	FRunOptions MakeOptions(const FSweepTask& Task) const;
	FRunSession& Begin(const FSweepTask& Task);
	void RunFrames(const FSweepTask& Task, const std::filesystem::path& Folder, bool bFirstAlone);
	std::string RunStudy(const FSweepTask& Task, const std::filesystem::path& Folder);
	void RunHazards(const FSweepTask& Task, const std::filesystem::path& Folder);

	const FSweepPlan& Plan;
	const std::optional<int> Threads;
	const std::shared_ptr<FSceneCache> SceneCache;
	std::unique_ptr<FRunSession> Session; // of the last task
	FSweepSet SessionSet;
};

/** Measures the first task of the plan, of frames the first one once its shaders are compiled, and sets the plan's
 * seconds and bytes. Folder: of the plan; the files go away. Throws FError as FSweepRunner::Run. */
DRYDOCK_API void MeasureSweep(const std::filesystem::path& Folder, FSweepPlan& Plan);

} // namespace Drydock
