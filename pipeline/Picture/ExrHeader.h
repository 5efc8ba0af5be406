// A look at an OpenEXR header before the library that decodes the file sees it. OpenEXR believes what a header says: an
// attribute of 2 GB, a table of 2^31 chunks or a tile of 2 GB is allocated first and found to be missing afterwards.
// Source of the format: "OpenEXR File Layout", ASWF.
#pragma once

#include <cstdint>
#include <string>

namespace Drydock
{

/** No frame is larger. In pixels: along a side, and in all. */
constexpr int64_t MaxImageSide = 32768;
constexpr int64_t MaxImagePixels = int64_t(1) << 28;

/** Whether the file at Path says by its name or by its first bytes that it is OpenEXR. */
bool IsExrFile(const std::string& Path);

/** Reads the headers of all parts, and no pixels. Throws FError (exit code 3): attributes that do not lie within the
 * file, a window larger than a frame, more pixels or chunks than a file of this size can hold, a deep picture. */
void CheckExrHeader(const std::string& Path);

} // namespace Drydock
