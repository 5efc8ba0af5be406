// Reads PNG files by libpng.
#pragma once

#include "Picture/ImageReader.h"

namespace Drydock
{

/** The header must have passed CheckImageHeader. Palettes and few bits become 8 bits, a transparent colour becomes
 * alpha, and colours are multiplied by alpha. The values are encoded unless the file declares that it is linear or has
 * another gamma. Throws std::exception. */
std::unique_ptr<IImageReader> MakePngReader(std::unique_ptr<std::istream> Stream);

} // namespace Drydock
