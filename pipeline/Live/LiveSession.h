// A session of `drydock live`: the state of a config under edits, and its frames. One thread calls all of it.
#pragma once

#include "Live/EditHistory.h"
#include "Live/LiveEvents.h"
#include "Live/LivePictures.h"
#include "Run/Run.h"
#include "Text/WatchedFiles.h"

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

struct FLiveOptions
{
	FRunOptions Run;          // ConfigFile, and what no config says
	bool bReuse = true;       // passes that no change reaches are taken from the frame before
	std::string OutputFolder; // where configs may be saved, beside the config's own folder; empty: nowhere else
	/** The messages of whatever was thrown. */
	std::function<FError(const std::exception_ptr& Thrown)> Explain;
	/** The crash that ended the process which ran the session before; empty: there was none. The page is told until the
	 * next edit. */
	std::string Crash = {};
	/** Called when a frame of the state was well. */
	std::function<void(const FEditHistory& History)> OnFrame = {};
};

/** A state that was kept. */
struct FLivePin
{
	int Number = 0;
	std::string Name;
	uint64_t Revision = 0;
};

/** A setting of the session's price, by the clock of this machine. */
struct FLiveDot
{
	uint64_t Revision = 0;
	std::string Label = {}; // what differs from the start
	double Milliseconds = 0.0;
	double Error = 0.0;
	std::string Metric;
};

class DRYDOCK_API FLiveSession
{
public:
	/** The state is that of the history. Nothing is run yet. */
	FLiveSession(FLiveOptions InOptions, FEditHistory InHistory, FLiveEvents& InEvents, FLivePictures& InPictures);
	~FLiveSession();

	const FLiveOptions& GetOptions() const { return Options; }
	const FEditHistory& GetHistory() const { return History; }

	/** Changes the state (FEditHistory::Plan); where the scene gives the volumes, an edit of one writes them all into
	 * the config first. A state that does not check is refused, and the one before stays: throws FError. */
	void Change(FJsonValue Asked);

	/** Keeps the state and its picture. Returns the pin's number. */
	int Pin(const std::string& Name);
	/** Throws FError where there is none. */
	void Unpin(int Number);

	/** Whether the state has no frame yet. */
	bool IsFrameWanted() const { return bFrameWanted; }

	/** Runs the state's frame, and tells of it. A failure is told, too; the frame before stays. */
	void RunFrame();

	/** Looks whether files have changed, and takes over a config that was edited elsewhere. */
	void LookAtFiles();

	/** The options of a run of the state. */
	FRunOptions MakeOptions() const;

	/** Lets go of the frame's own run: before anything else runs. */
	void EndRun() { Run.reset(); }

	/** Makes console variables what the state sets them to, until EndRun. Throws FError. */
	const FConfig& BeginRun();

	/** The last frame that succeeded; null: none has. */
	const FRunResult* GetFrame() const { return Frame ? &*Frame : nullptr; }
	/** Settings of the first. */
	const std::optional<FFinalPostProcessSettings>& GetStartSettings() const { return StartSettings; }
	const std::string& GetFrameJson() const { return FrameJson; }
	const std::string& GetFaultJson() const { return FaultJson; }
	const std::vector<FLivePin>& GetPins() const { return Pins; }
	const std::vector<FLiveDot>& GetDots() const { return Dots; }
	void AddDot(FLiveDot Dot);
	std::vector<std::string> GetFiles() const { return Files.GetPaths(); }

	/** Changes that wait for their turn. From any thread. */
	std::atomic<int> NumChanges = 0;

private:
	/** Throws FError where the text does not check. */
	void Prepare(const std::string& Text);
	/** The frame of the start: its settings and its picture. */
	void RunStart();
	void TellState();
	void TellFault(const std::vector<FDiagnostic>& Messages);

	const FLiveOptions Options;
	FEditHistory History;
	FLiveEvents& Events;
	FLivePictures& Pictures;
	std::shared_ptr<FSceneCache> SceneCache;
	std::shared_ptr<FReuseCache> ReuseCache; // null: every pass is computed
	std::unique_ptr<FRunSession> Run;        // of RunText
	std::string RunText;
	bool bFrameWanted = true;
	std::optional<FRunResult> Frame;
	std::optional<FFinalPostProcessSettings> StartSettings;
	std::string FrameJson = "null";
	std::string FaultJson = "null";
	std::string CrashJson = "null";
	std::vector<FLivePin> Pins;
	int NumPins = 0;
	std::vector<FLiveDot> Dots;
	FWatchedFiles Files;
	bool bNewFiles = true; // Files are to be listed anew before they are compared
	std::string FileText;  // of the config, when it was last looked at
};

} // namespace Drydock
