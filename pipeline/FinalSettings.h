// The settings of a run: defaults, volumes, camera, command line, then console variables and show flags. Source:
// drydock; the order is the engine's.
#pragma once

#include "Config.h"
#include "FinalPostProcessSettings.h"
#include "PostProcess/EffectDecisions.h"

namespace Drydock
{

/** Console variables must be set already. */
DRYDOCK_API FChainSettings MakeChainSettings(const FConfig& Config);

/** Names of all settings that something in the config gives, active or not. */
DRYDOCK_API std::vector<std::string> GetNamedSettings(const FConfig& Config);

} // namespace Drydock
