// Decides whether a frame has bloom at all, for bloom itself and for the effects that change it.
#pragma once

#include "Effects/Effect.h"

namespace Drydock
{

/** Why the settings call for no bloom; empty: they do. Source: engine PostProcess/PostProcessing.cpp (conditions). */
std::string FindNoBloomReason(const FEffectInputs& Inputs);

/** Whether bloom's setup pass, where an effect alone brings it, changes every pixel by a ramp: without a threshold, in
 * the engine's versions before 5.4. */
bool HasRampWithoutThreshold(const FEffectInputs& Inputs);

} // namespace Drydock
