// final.png of a picture that is not for an sRGB display: what of it such a display can show. Pure. Source of the
// transfer functions: SMPTE ST 2084, ITU-R BT.709, BT.2020, IEC 61966-2-1.
#pragma once

#include "Picture/ImageFile.h"
#include "Tonemap/TonemapOutputDevice.h"

namespace Drydock
{

/** sRGB code values of an RGB picture encoded for a device. sRGB and powers: as they are. Rec.709: decoded. Light above
 * 100 nits (ST 2084 and scRGB) or above 1 (linear) is cut off, so is what Rec.709 cannot show. */
DRYDOCK_API FImage MakeDisplayPreview(const FImage& Picture, EDisplayOutputFormat OutputDevice);

} // namespace Drydock
