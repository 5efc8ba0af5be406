// Where the files behind virtual shader paths lie on disk.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

/** Maps a virtual directory ("/Project") to a directory on disk. Later mappings of the same prefix win. */
DRYDOCK_API void AddShaderDirectory(const std::string& VirtualDirectory, const std::string& RealDirectory);

/** Real path of a virtual shader path, empty when no mapping fits or the file does not exist. */
DRYDOCK_API std::string FindShaderFile(const std::string& VirtualPath);

} // namespace Drydock
