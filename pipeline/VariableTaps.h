// Taps of passes whose loops run over a count that is a parameter, which a count of the shader's text does not see.
// Source: drydock.
#pragma once

#include "PassCounters.h"

class FRDGPass;

namespace Drydock
{

/** Counters.Taps where that is known; else from the parameters: SampleCount (one more where Additive_Texture is bound),
 * or Reach, of which (2 x + 1) (2 y + 1) texels are read; times Pixels. 0 where there is neither. */
uint64_t CountTaps(const FRDGPass& Pass, const FPassCounters& Counters);

} // namespace Drydock
