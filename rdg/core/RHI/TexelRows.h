// Converts rows of texels: the same bits as one by one (PixelFormatConversion.h), in a fraction of the time.
#pragma once

#include "PixelFormatConversion.h"

namespace Drydock
{

/** Decodes Count texels that lie side by side; the first NumChannels (1 to 4) of each, interleaved. The quiet bit of a
 * NaN in 32 bits may stay as it is. */
DRYDOCK_API void DecodeTexelRow(
	ETexelStorage Storage, const void* Texels, int32_t Count, int32_t NumChannels, float* OutValues);

/** RGBA of Count texels. */
DRYDOCK_API void EncodeTexelRow(
	ETexelStorage Storage, const float* RGBA, int32_t Count, void* OutTexels, bool bSaturate = false);

} // namespace Drydock
