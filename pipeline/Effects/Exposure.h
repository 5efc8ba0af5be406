// Decides whether exposure is metered, for the chain and for reports.
#pragma once

#include "Effects/Effect.h"

namespace Drydock
{

/** "AEM_Histogram". */
DRYDOCK_API std::string GetAutoExposureMethodName(EAutoExposureMethod Method);

/** The exposure is the settings' and not a number: asked for, and not switched off. */
DRYDOCK_API bool IsAutoExposureActive(const FViewConditions& Conditions);

/** A setting of metering: it does nothing where exposure is a number. */
DRYDOCK_API bool IsMeteringSetting(std::string_view Name);

} // namespace Drydock
