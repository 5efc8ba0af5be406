// Reads PNG files by libpng.
#pragma once

#include "Picture/ImageReader.h"

namespace Drydock
{

/** The header must have passed CheckImageHeader. Palettes and few bits become 8 bits, a transparent colour becomes
 * alpha, and colours are multiplied by alpha. Encoded unless the file says that it is linear or has another gamma.
 * Throws std::exception. */
std::unique_ptr<IImageReader> MakePngReader(const std::string& Path, FImageBytesPointer Bytes);

} // namespace Drydock
