// Where r.REDPostprocessAfterTranslucency puts the RED effects, which go one after another.
#pragma once

#include "Effects/Effect.h"

namespace Drydock
{

/** Turn: among the RED effects. */
FChainPlace GetREDPlace(int32 Turn);

/** "; after bloom", to end a reason with. */
const char* DescribeREDPlace();

} // namespace Drydock
