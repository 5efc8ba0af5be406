// The first half of a run: config and command line read, console variables set for its length, settings final, effects
// decided. Source: drydock.
#pragma once

#include "Extensions/InsertedPass.h"
#include "HAL/ConsoleVariableTools.h"
#include "Run/Run.h"
#include "SceneViewExtension.h"
#include "Screen/TextureAssets.h"

#include <optional>

namespace Drydock
{

/** Values of one run's console variables; the old ones come back when it ends. */
class DRYDOCK_API FRunVariables
{
public:
	/** As an option of the program's own: beats everyone. The variable must exist (checked). */
	void Set(const std::string& Name, const std::string& Value);

	/** As its source may; Variable must be one that CheckVariable takes. One that is kept out is a warning. */
	void Apply(const FConfigVariable& Variable, const std::string& ConfigFile, std::vector<FDiagnostic>& Diagnostics);

private:
	FConsoleVariableSnapshot Before;
};

struct DRYDOCK_API FRunSetup
{
	/** Throws FError (exit code 2 or 3) with everything found when something is wrong. */
	explicit FRunSetup(const FRunOptions& InOptions);

	/** Before each frame. Frame: of a sequence, whose config, settings and decisions are as if it had been the first;
	 * empty: the one of before. Throws FError when there is no such frame, or something is wrong with it. */
	void BeginFrame(std::optional<int> Frame);

	std::vector<FDiagnostic> Diagnostics;
	/** Files. Loaded before anything else, because they bring console variables, which the rest of the config names and
	 *  which have to be as before afterwards. */
	std::vector<std::string> Plugins;
	FRunVariables Variables;
	FConfig Config;
	std::optional<FScopedTextureLoader> TextureLoader;
	FChainSettings Chain;
	std::vector<FEffectDecision> Effects;
	std::vector<TConfigValue<std::string>> Dump; // of config and command line
	std::string BudgetReason;                    // what a study chose for this run, and why; empty: nothing was asked
	/** Those of the config, its inserted passes among them; alive for the run. */
	std::vector<TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>> Extensions;

private:
	void PlaceFrame(std::optional<int> Frame);
	void CreateExtensions();
	void Decide();

	FRunOptions Options; // with what a budget chose
	FConfig ConfigBeforeFrame;
	// Messages, in the order in which they are given.
	std::vector<FDiagnostic> OfConfig;
	std::vector<FDiagnostic> OfFrame;
	std::vector<FDiagnostic> OfExtensions;
	std::shared_ptr<FPassResults> PassResults;
};

} // namespace Drydock
