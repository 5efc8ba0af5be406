// Computes the toon-shadow blur without the rounding of textures, as the reference for the stored one.
#pragma once

#include "FinalPostProcessSettings.h"
#include "Picture/ImageFile.h"

namespace Drydock
{

/** ToonShadow: the shadow buffer over the view's rect, red and green at least, values of 8 bit. Runs the same passes on
 * 64-bit storage, in the arithmetic of the run, in a graph of its own; no other builder may be alive. Four
 * channels, the blurred shadow in A, linear. */
FImage BlurToonShadowExactly(const FImage& ToonShadow, const FFinalPostProcessSettings& Settings);

} // namespace Drydock
