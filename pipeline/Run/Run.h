// One run of a config, in this process and without writing a file: what the program's verbs, the tests and the
// benchmarks call.
#pragma once

#include "Budget/RunOptions.h"
#include "Run/PluginShaders.h"
#include "Run/RunResult.h"

#include <memory>
#include <optional>
#include <vector>

namespace Drydock
{

/** Reads the config, decides, builds and compiles the graph and, where asked, executes it. Console variables are put
 * back afterwards. Throws FError with everything collected; not for two threads at once. */
DRYDOCK_API FRunResult RunConfig(const FRunOptions& Options);

struct FRunSetup;

/** One config, frame after frame: its extensions and console variables live as long as the session, and what lives on
 * of the views goes from one frame to the next by the caller's hand. One session at a time. */
class DRYDOCK_API FRunSession : private FNoncopyable
{
public:
	/** Reads the config and decides. Throws as RunConfig. Options.Frame: the first frame. */
	explicit FRunSession(const FRunOptions& InOptions);
	~FRunSession();

	/** Config of the last frame; before one, of the first. */
	const FConfig& GetConfig() const;

	/** Frame: of a sequence; empty: the one of before. Last: the ViewStates of the frame before; empty: there was none.
	 * The same arguments give the same result, whatever the session ran before, unless extensions keep a history of
	 * their own. */
	FRunResult Run(std::optional<int> Frame, const std::vector<FViewHistory>& Last);

private:
	std::optional<std::chrono::steady_clock::time_point> Begin; // of the session, until its first frame counts it
	double StartMilliseconds;                                   // of the session, until its first frame counts it
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
	FPluginShaders Shaders = {}; // of CheckRun
};
DRYDOCK_API FCheckResult CheckConfig(const FRunOptions& Options);

/** Checks as CheckConfig does. If a scene is named, its frame is compiled too, which finds mistakes of extensions and
 * passes, and of the shaders of all passes that settings let run. The shader classes of its plugins are checked in any
 * case (FindPluginShaders). Nothing is drawn, and no picture is decoded. */
DRYDOCK_API FCheckResult CheckRun(const FRunOptions& Options);

/** Compiles the shader classes of the config's plugins, with its console variables. Throws FError with the messages of
 * all that fail. */
DRYDOCK_API FPluginShaders WarmPluginShaders(const FRunOptions& Options);

} // namespace Drydock
