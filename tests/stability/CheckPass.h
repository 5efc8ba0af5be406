// Runs one cell of a pass and holds it to what the table expects.
#pragma once

#include "Table.h"

#include <string>

namespace Stability
{

/** Empty where the cell holds; else what was found in its place. */
std::string CheckPass(const FRow& Row, EHazard Hazard);

/** The same of a rule of blending. */
std::string CheckBlend(const FRow& Row, EHazard Hazard);

} // namespace Stability
