// Holds the options of a run. The header is plain: it needs none of the engine's headers, whose macros would break
// others'.
#pragma once

#include "Config/OutputKinds.h"
#include "DrydockAPI.h"

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

enum class ERunStorage
{
	Default, // Native; Float64 with double precision
	Native,  // the formats' own
	Float32,
	Float64,
};

class FReuseCache;
class FSceneCache;
struct FPassWrites;

struct FRunOptions
{
	DRYDOCK_DECLARE_COPIES(FRunOptions)

	std::string ConfigFile;
	std::optional<std::string> ConfigText; // read in place of the file; paths are still relative to ConfigFile
	std::vector<std::string> Variables;    // "r.Name=Value" (--set), beat the config's
	struct FExec
	{
		std::string Text;              // "r.A 1, r.B=2"
		size_t NumVariablesBefore = 0; // of Variables: where it stands among them
	};
	std::vector<FExec> Exec;                           // beat Variables
	std::vector<std::string> ConfigPlaces;             // "/objects/UMySettings/Intensity=0.5", beat the config's
	std::vector<std::string> Settings;                 // "Setting=Value", beat all volumes and the camera
	std::vector<std::string> Dump;                     // patterns, beside the config's
	std::optional<FOutputKinds> Write;                 // what of the outputs is written; beats the config's
	FOutputKinds WriteByDefault = GetAllOutputKinds(); // where neither says anything
	std::string Engine;                                // "5.6"; beats the config's; empty: that
	std::vector<std::string> Plugins;                  // shared objects; one in place of the config's of its file name
	std::vector<std::string> Overlays;                 // folders, beside the config's
	std::optional<std::array<double, 3>> Location;     // of the view, cm; beats the config's and the scene's
	std::optional<std::array<int, 4>> Padding;         // left, top, right, bottom, texels; beats the config's
	std::optional<double> ScreenPercentage;            // above 0; beats the config's
	/** Rects of the views, in pixels of the picture, in place of the config's view or views, the first of which gives
	 * all else; empty: the config's. */
	std::vector<std::array<int, 4>> ViewRects;
	std::optional<int> Frame;   // which of a sequence, the lowest by default; shaders see it as View.FrameNumber
	std::optional<int> Threads; // 0: all cores
	bool bDouble = false;       // double arithmetic
	bool bNoPlugins = false;    // a config that names plugins is an error
	ERunStorage Storage = ERunStorage::Default;
	bool bExecute = true;       // false: stop when the graph is compiled
	bool bPlanLoads = false;    // of a graph that is not executed: find out which channels it would decode
	bool bLookAtContent = true; // false: settings alone decide what runs, so that no picture is decoded for it
	/** Nothing is left out because no output needs it: culled passes run, all channels are decoded, effects whose
	 * values are neutral or whose input is empty run. Effects that are switched off stay off. The outputs are the same
	 * bits. */
	bool bNoSkip = false;
	bool bMeasureEffects = false;            // figures and pictures of effects (FEffect::Measure), after the frame
	bool bFingerprints = false;              // of what each pass wrote, in run.json
	bool bRecordInputs = false;              // fingerprints of what the run depends on, in run.json
	bool bKeepForReport = false;             // of each pass its parameters and small pictures (FRunPass)
	bool bPassValues = false;                // the constants of each pass's parameters (FRunResult::PassValues)
	bool bFollowUnwritten = true;            // warn of texels that nothing wrote and a pass reads
	bool bUseBudget = true;                  // a config with a budget and a study runs what the study recommends
	std::shared_ptr<FSceneCache> SceneCache; // of runs in a row: decoded channels; null: each run reads for itself
	std::shared_ptr<FReuseCache> ReuseCache; // of runs in a row: results of passes; null: every pass is computed
	double StartMilliseconds = 0.0;          // that the process took before the run, for the run's times
	/** Called before each pass that executes. */
	std::function<void(int Done, int Total, const std::string& Pass)> Progress;
	/** Called after each pass with the textures that it wrote. Texels that nobody has written are then 0, but for
	 * r.RDG.ClobberResources. */
	std::function<void(const FPassWrites& Writes)> OnPassExecuted;
};

/** "out/toon_bloom" for configs/toon_bloom.json. */
DRYDOCK_API std::string GetDefaultOutputFolder(const std::string& ConfigFile);

} // namespace Drydock
