// A look at an OpenEXR header before the library that decodes the file sees it. OpenEXR believes what a header says: an
// attribute of 2 GB, a table of 2^31 chunks or a tile of 2 GB is allocated first and found to be missing afterwards.
// Source of the format: "OpenEXR File Layout", ASWF.
#pragma once

#include "Picture/HeaderBytes.h"

namespace Drydock
{

/** Reads the headers of all parts, and no pixels. Throws FError (exit code 3): attributes that do not lie within the
 * file, a window larger than a frame, more pixels or chunks than a file of this size can hold, a deep picture. */
void CheckExrHeader(FHeaderBytes& Bytes);

} // namespace Drydock
