// Taps of passes whose loops run over a count that is a parameter, which a count of the shader's text does not see.
#pragma once

#include "CoreMinimal.h"
#include "PassCounters.h"

#include <optional>

class FRDGPass;

namespace Drydock
{

/** Counters.Taps where that is known; else, of a hand-written kernel, from the parameters: SampleCount (one more where
 * Additive_Texture is bound), or Reach, of which (2 x + 1) (2 y + 1) texels are read; times CountWantedPixels. Empty
 * where there is neither. */
std::optional<uint64_t> CountTaps(const FRDGPass& Pass, const FPassCounters& Counters);

/** The part of its textures that a pass writes: the viewport named Output in its parameters; empty where there is none.
 */
std::optional<FIntRect> FindOutputRect(const FRDGPass& Pass);

/** Pixels that a pass is asked for: of its Output rect where it has one, else Counters.Pixels. The threads that fill up
 * the last groups of a compute shader are in Counters.Pixels, and store nothing. */
uint64_t CountWantedPixels(const FRDGPass& Pass, const FPassCounters& Counters);

} // namespace Drydock
