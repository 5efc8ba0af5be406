// Whether a frame has bloom at all: what bloom itself and the effects that change it ask.
#pragma once

#include "Effects/Effect.h"

namespace Drydock
{

/** Why the settings call for no bloom; empty: they do. Source: engine PostProcess/PostProcessing.cpp (conditions). */
std::string FindNoBloomReason(const FEffectInputs& Inputs);

} // namespace Drydock
