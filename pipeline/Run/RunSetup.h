// Sets up a run: reads config and command line, sets console variables for its length, blends settings. Each step takes
// what the one before made and returns what it makes.
#pragma once

#include "Budget/RunOptions.h"
#include "Config/Config.h"
#include "Effects/Effect.h"
#include "Extensions/InsertedPass.h"
#include "HAL/ConsoleVariableTools.h"
#include "Overlay/Overlays.h"
#include "SceneFile/SceneCheck.h"
#include "SceneViewExtension.h"
#include "Screen/TextureAssets.h"

#include <optional>

namespace Drydock
{

/** Values of one run's console variables; the old ones come back when it ends. */
class DRYDOCK_API FRunVariables
{
public:
	/** Sets an option of the program's own, which beats every other source. The variable must exist (checked). */
	void Set(const std::string& Name, const std::string& Value);

	/** Sets a variable as far as its source may; Variable must be one that CheckVariable takes. A variable that is kept
	 * out is a warning. */
	void Apply(const FConfigVariable& Variable, const std::string& ConfigFile, std::vector<FDiagnostic>& Diagnostics);

private:
	FConsoleVariableSnapshot Before;
};

/** A config with the command line's say, and with what a study chose where it has a budget. */
struct FConfigOfRun
{
	FConfig Config;
	FRunOptions Options;
	ESceneNeed Need = ESceneNeed::None; // None, too, if a mistake about the scene is reported already
	std::string BudgetReason;           // what a study chose, and why; empty: nothing was asked
	std::vector<FDiagnostic> Diagnostics;
};

struct FFrameOfRun
{
	FConfig Config;
	std::vector<FDiagnostic> Diagnostics;
};

/** View extensions of a config, its inserted passes among them, and what these left in the graph of the last frame. */
struct FRunExtensions
{
	std::vector<TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>> Extensions; // alive as long as this
	std::shared_ptr<FPassResults> PassResults;
};

struct DRYDOCK_API FRunSetup
{
	/** Throws FError with all mistakes of config, command line, plugins, extensions, study and budget, and of the scene
	 * as far as it is needed; exit code 3 where files are all that is wrong, else 2. A JSON syntax error is reported
	 * alone. */
	explicit FRunSetup(const FRunOptions& Options, ESceneNeed Need = ESceneNeed::None);

	/** Called before each frame. Frame: of a sequence, whose config and settings are as if it had been the first;
	 * empty: the one of before. Throws FError when there is no such frame, or something is wrong with it. */
	void BeginFrame(std::optional<int> Frame);

	/** Messages of all steps, in the order in which they are given. */
	std::vector<FDiagnostic> Diagnostics;
	/** Files of plugins, loaded before anything else is read. */
	std::vector<std::string> Plugins;
	/** The engine overlays that act, in the order in which they stack. */
	std::vector<FOverlayFolder> Overlays;
	/** The config of this frame. */
	FConfig Config;
	FViewSettings Settings;                      // at the view's location
	std::vector<TConfigValue<std::string>> Dump; // of config and command line
	FOutputKinds Write;                          // of config and command line
	std::string BudgetReason;                    // see FConfigOfRun

private:
	/** Blends the frame's settings. */
	void TakeFrame(FFrameOfRun Frame);

	std::optional<FScopedOverlays> ActiveOverlays;
	std::optional<FRunVariables> Variables;
	std::optional<FScopedTextureLoader> TextureLoader;
	FRunExtensions Extensions;
	FConfigOfRun OfRun;                    // of any frame
	std::vector<FDiagnostic> OfExtensions; // of the variables, too
};

} // namespace Drydock
