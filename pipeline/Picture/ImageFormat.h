// Lists the image formats that are read, and checks a file's header before a library trusts it.
#pragma once

#include "DrydockAPI.h"
#include "Picture/HeaderBytes.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Lower-case ends of file names, with the dot: ".exr". */
DRYDOCK_API const std::vector<std::string>& GetImageExtensions();

/** Whether the end of the name, in any case, is one of GetImageExtensions. */
DRYDOCK_API bool IsImagePath(const std::string& Path);

/** Looks at the header. The name's end chooses the format, and the first bytes have to agree. Returns OpenImageIO's
 * name of its reader. Throws FError (exit code 3): a format that is not read, a format other than that of the name, a
 * picture larger than any frame, or more pixels than a file of this size can hold. */
std::string CheckImageHeader(const std::string& Path, FHeaderBytes& Bytes);

} // namespace Drydock
