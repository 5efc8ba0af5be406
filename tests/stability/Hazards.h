// The hazards of the library, by the names that the table uses: its columns.
#pragma once

#include "Hazards/Hazards.h"

namespace Stability
{

using Drydock::EHazard;
using Drydock::EHazardGroup;
using Drydock::FHazard;
using Drydock::Hazards;
using Drydock::NumHazards;

} // namespace Stability
