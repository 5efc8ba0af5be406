// Chooses the place of the RED effects, which run one after another, by r.REDPostprocessAfterTranslucency.
#pragma once

#include "Effects/Effect.h"

namespace Drydock
{

/** Turn: among the RED effects. */
FChainPlace GetREDPlace(int32 Turn);

/** "; after bloom", to end a reason with. */
const char* DescribeREDPlace();

} // namespace Drydock
