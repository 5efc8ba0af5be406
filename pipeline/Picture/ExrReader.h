// Reads OpenEXR files by OpenEXR itself: every part, tiled or not, channel by channel.
#pragma once

#include "Picture/ImageReader.h"

namespace Drydock
{

/** The header must have passed CheckExrHeader. Throws std::exception. */
std::unique_ptr<IImageReader> MakeExrReader(const std::string& Path, std::unique_ptr<std::istream> Stream);

} // namespace Drydock
