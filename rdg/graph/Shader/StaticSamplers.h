// Samplers that a shader may name without binding them: the binder gives them by name, as a GPU's root signature does.
// Source: the names of the engine's Common.ush.
#pragma once

#include "RHIStates.h"

#include <string>

namespace Drydock
{

/** GlobalPointClampedSampler, GlobalBilinearWrappedSampler, ...: null for any other name. */
DRYDOCK_API FRHISamplerState* FindStaticSampler(const std::string& HlslName);

} // namespace Drydock
