// The first half of a run: config and command line read, console variables set for its length, settings final, effects
// decided. Source: drydock.
#pragma once

#include "HAL/ConsoleVariableTools.h"
#include "Run.h"

#include <memory>

namespace Drydock
{

/** Values of one run's console variables; the old ones come back when it ends. */
class FRunVariables
{
public:
	FRunVariables() = default;
	~FRunVariables();
	FRunVariables(const FRunVariables&) = delete;
	FRunVariables& operator=(const FRunVariables&) = delete;

	/** Later calls win. The variable must exist (checked). */
	void Set(const std::string& Name, const std::string& Value);

private:
	std::vector<std::unique_ptr<FScopedConsoleVariable>> Scopes;
};

struct FRunSetup
{
	/** Throws FError (exit code 2 or 3) with everything found when something is wrong. */
	explicit FRunSetup(const FRunOptions& Options);

	FRunVariables Variables;
	FConfig Config;
	std::vector<FDiagnostic> Diagnostics;
	FChainSettings Chain;
	std::vector<FEffectDecision> Effects;
	std::vector<TConfigValue<std::string>> Dump; // of config and command line
};

} // namespace Drydock
