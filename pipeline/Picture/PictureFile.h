// Pictures to look at, from and to files.
#pragma once

#include "DrydockAPI.h"
#include "Picture/ImageFile.h"

#include <string>

namespace Drydock
{

/** Display-encoded, three channels (grey three times). 8-bit formats give their own values; of EXR files a run's
 * final.exr does, too, and what is linear is cut at 1 and encoded. Throws FError (exit code 3) when it cannot be read.
 */
DRYDOCK_API FImage ReadPicture(const std::string& Path);

/** A PNG as small as it gets without loss, written aside and renamed; folders on the way are made. Throws FError (exit
 * code 3) when it cannot be written. */
DRYDOCK_API void WritePicture(const std::string& Path, const FImage& Picture);

} // namespace Drydock
