// Whether exposure is metered and local exposure runs, and why. Pure: looks at settings and console variables only.
// Source: engine PostProcess/PostProcessing.cpp (conditions); wording is drydock's.
#pragma once

#include "Effects/EffectDecisions.h"

namespace Drydock
{

/** "AEM_Histogram". */
DRYDOCK_API std::string GetAutoExposureMethodName(EAutoExposureMethod Method);

/** The exposure is the settings' and not a number: asked for, and not switched off. */
DRYDOCK_API bool IsAutoExposureActive(const FChainSettings& Chain);

/** The effect named Exposure: always active. */
DRYDOCK_API FEffectDecision DecideExposure(const FChainSettings& Chain);

DRYDOCK_API FEffectDecision DecideLocalExposure(const FChainSettings& Chain);

} // namespace Drydock
