// One run of a config, in this process and without writing a file: what the program's verbs, the tests and the
// benchmarks call. Source: drydock.
#pragma once

#include "Budget/RunOptions.h"
#include "Config/Config.h"
#include "Effects/EffectDecisions.h"
#include "Effects/ExposureReport.h"
#include "Extensions/HookLog.h"
#include "PassCounters.h"
#include "Picture/ImageFile.h"
#include "RenderGraphCompiled.h"
#include "SceneFile/SceneFile.h"
#include "SceneViewState.h"
#include "Tonemap/TonemapOutputDevice.h"

#include <memory>
#include <string>
#include <vector>

namespace Drydock
{

/** A resource as it was right after a pass. */
struct FRunDump
{
	int PassIndex = 0; // 0: an external input
	std::string Pass;  // "External" for those
	std::string Resource;
	int Mip = -1;                      // -1: there is only one
	FImage Image;                      // the whole extent, values as stored
	std::vector<std::string> Channels; // "R", "G", ...: those the format has
};

struct FRunPass
{
	int Index = 0;
	double Milliseconds = 0.0;
	FPassCounters Counters;
};

/** One view of several. */
struct FRunView
{
	std::string Name; // "View 0"
	FIntRect Rect;
	float ExposureScale = 1.0f;
	std::vector<FEffectDecision> Effects;
	std::optional<FExposureReport> Exposure;
};

/** Milliseconds of the run's parts. */
struct FRunTimes
{
	double Load = 0.0;    // reading and converting scene channels
	double Compile = 0.0; // building and compiling the graph
	double Execute = 0.0; // the passes
};

struct FRunResult
{
	FConfig Config;
	std::vector<FDiagnostic> Diagnostics; // warnings; errors are thrown
	FRDGCompiledGraph Graph;
	std::vector<FEffectDecision> Effects;
	FFinalPostProcessSettings Settings;
	float ExposureScale = 1.0f;
	std::optional<FExposureReport> Exposure; // of an executed run whose exposure is automatic
	std::string Precision;                   // "float", "double"
	std::string Storage;                     // "native", "float32", "float64"
	std::string BudgetReason;                // what a study chose for this run, and why; empty: nothing was asked
	int Threads = 0;
	FIntPoint SceneExtent = FIntPoint(0, 0);
	FIntRect ViewRect; // of all views
	std::vector<FRunView> Views;
	std::vector<FSceneChannel> Channels;
	uint64_t SceneTextureBytes = 0; // of the scene textures that were loaded, or with bPlanLoads would be
	FLinearColor LightColor;        // of the scene's main light, relative
	EDisplayOutputFormat OutputDevice = EDisplayOutputFormat::SDR_sRGB; // what Final is encoded for
	std::vector<FHookCall> HookCalls;                                   // what view extensions were asked and did
	std::vector<FHookPoint> HookPoints;                                 // the chain's insertion points

	// Only of an executed run.
	std::vector<FRunPass> Passes; // those that executed
	FImage SceneLinear;           // RGBA: the tonemapper's input, the views only, at the scene's resolution
	FImage Final;                 // RGBA, display-encoded, the view rect only
	FImage BandingMap;            // RGB, of the blurred toon shadow; empty where there is none
	FImage BlurredToonShadow;     // one channel, decoded: what lighting reads; empty where there is none
	std::vector<FRunDump> Dumps;
	std::vector<FViewHistory> ViewStates; // what lives on to the next frame
	FRunTimes Times;

	/** Text of run.json: the same bytes for the same run. */
	std::string RunJson;
};

/** Reads the config, decides, builds and compiles the graph and, where asked, executes it. Console variables are put
 * back afterwards. Throws FError with everything collected; not for two threads at once. */
DRYDOCK_API FRunResult RunConfig(const FRunOptions& Options);

struct FRunSetup;

/** One config, frame after frame: its extensions and console variables live as long as the session, and what lives on
 * of the views goes from one frame to the next by the caller's hand. One session at a time. */
class DRYDOCK_API FRunSession
{
public:
	/** Reads the config and decides. Throws as RunConfig. Options.Frame: the first frame. */
	explicit FRunSession(const FRunOptions& InOptions);
	~FRunSession();
	FRunSession(const FRunSession&) = delete;
	FRunSession& operator=(const FRunSession&) = delete;

	/** As of the last frame; before one, of the first. */
	const FConfig& GetConfig() const;

	/** Frame: of a sequence; empty: the one of before. Last: the ViewStates of the frame before; empty: there was none.
	 * The same arguments give the same result, whatever the session ran before, unless extensions keep a history of
	 * their own. */
	FRunResult Run(std::optional<int> Frame, const std::vector<FViewHistory>& Last);

private:
	const FRunOptions Options;
	const std::unique_ptr<FRunSetup> Setup;
	std::vector<std::shared_ptr<FSceneViewState>> Caches; // by view
};

/** Only what comes before the scene: config with the options' arguments, and the decisions. Throws FError on errors. */
struct FCheckResult
{
	FConfig Config;
	std::vector<FDiagnostic> Diagnostics;
	FFinalPostProcessSettings Settings;
	std::vector<FEffectDecision> Effects;
};
DRYDOCK_API FCheckResult CheckConfig(const FRunOptions& Options);

} // namespace Drydock
