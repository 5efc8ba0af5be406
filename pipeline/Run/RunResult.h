// Holds the result of a run: plain data, which reports, files and tests read.
#pragma once

#include "Config/Config.h"
#include "Effects/Effects.h"
#include "Effects/ExposureReport.h"
#include "Extensions/HookLog.h"
#include "PassCounters.h"
#include "Picture/Picture.h"
#include "RenderGraphCompiled.h"
#include "Run/NonFiniteSpread.h"
#include "Run/PassValues.h"
#include "Run/RunInputs.h"
#include "SceneFile/SceneChannel.h"
#include "SceneViewState.h"
#include "Tonemap/TonemapOutputDevice.h"

#include <chrono>
#include <map>
#include <optional>
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
	FPicture Image;                    // the whole extent, values as stored; 0 where nothing was written
	FIntRect Window;                   // what passes have drawn of it so far, pixels; all of it where that is not known
	std::vector<std::string> Channels; // "R", "G", ...: those the format has
};

/** Fingerprint of a texture right after a pass. */
struct FRunFingerprint
{
	std::string Resource;
	std::string Fingerprint; // FFingerprint of size and values of all mips
};

/** A texture right after a pass, small, for a quick look. */
struct FRunThumbnail
{
	std::string Resource;
	FIntPoint Extent; // of the texture, pixels
	FImage Image;     // linear
};

struct FRunPass
{
	int Index = 0;
	double Milliseconds = 0.0;
	FPassCounters Counters;
	std::optional<uint64_t> Taps = {};          // texture samples, gathers and loads; none: not known
	std::vector<FRunFingerprint> Written = {};  // where FRunOptions::bFingerprints asked for them
	std::vector<FRunThumbnail> Thumbnails = {}; // where FRunOptions::bKeepForReport asked: textures not dumped
	std::string SameAs = {};                    // texture that it read and whose bits it wrote again; empty: none
	std::string SameBecause = {};               // likely reason

	/** All that its shaders wrote was taken from FRunOptions::ReuseCache. */
	bool IsReused() const { return Counters.Dispatches > 0 && Counters.Reused == Counters.Dispatches; }
};

/** One view of several. */
struct FRunView
{
	std::string Name; // "View 0"
	FIntRect Rect;
	float ExposureScale = 1.0f;
	std::vector<FEffectDecision> Effects;
	FFiguresByEffect Figures; // where FRunOptions::bMeasureEffects asked for them
	std::optional<FExposureReport> Exposure;
};

/** Milliseconds of the run's parts, which add up. */
struct FRunTimes
{
	double Start = 0.0;   // of the process, before the run (FRunOptions::StartMilliseconds)
	double Setup = 0.0;   // reading the config, blending settings, loading plugins, the scene's header
	double Load = 0.0;    // reading and converting scene channels
	double Compile = 0.0; // building and compiling the graph, and its shaders
	double Execute = 0.0; // the passes
	double Report = 0.0;  // looking for what is not finite, measuring effects, run.json

	std::chrono::steady_clock::time_point Begin = std::chrono::steady_clock::now(); // of Setup

	double GetSum() const { return Start + Setup + Load + Compile + Execute + Report; }
};

struct FRunResult
{
	DRYDOCK_DECLARE_COPIES(FRunResult)

	FConfig Config;
	std::vector<FDiagnostic> Diagnostics; // warnings; errors are thrown
	FRDGCompiledGraph Graph;
	std::map<int, std::vector<FPassValue>>
		PassValues; // by index, where FRunOptions::bPassValues or bKeepForReport asked for them
	std::vector<FEffectDecision> Effects;
	FFiguresByEffect Figures; // of the first view, where FRunOptions::bMeasureEffects asked for them
	FFinalPostProcessSettings Settings;
	float ExposureScale = 1.0f;
	std::optional<FExposureReport> Exposure; // of an executed run whose exposure is automatic
	std::string Precision;                   // "float", "double"
	std::string Device;                      // that shaders ran on; empty: the CPU
	std::string Storage;                     // "native", "float32", "float64"
	std::vector<std::string> Arguments;      // of the command line, as far as they change a bit: ListRunArguments
	FRunInputs Inputs;                       // where FRunOptions::bRecordInputs asked for them
	std::vector<FRunVariable> Variables;     // by name
	bool bHistory = false;                   // it began with what lives on of a frame before
	std::string BudgetReason;                // what a study chose for this run, and why; empty: nothing was asked
	int Threads = 0;
	FOutputKinds Write; // which of the outputs WriteRunOutputs writes
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
	FPicture SceneLinear;         // RGBA: the tonemapper's input, the views only, at the scene's resolution
	FPicture Final;               // RGBA, display-encoded, the view rect only
	FNonFiniteSpread NonFinite;   // where the scene's NaN and infinities went
	std::vector<FRunDump> Dumps;
	std::vector<FViewHistory> ViewStates; // what lives on to the next frame
	FRunTimes Times;

	/** Text of run.json: the same bytes for the same run. */
	std::string RunJson;
};

} // namespace Drydock
