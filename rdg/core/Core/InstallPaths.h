// Finds the library's own files, in a build tree and in an installed one.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Path of the shared object this code is in. */
std::string GetLibraryPath();

/** A folder or file under the prefix that the library is installed in ("share/drydock"): the library lies in lib/ of a
 *  build tree, and in lib/drydock/ of an installation. Empty when there is none. */
DRYDOCK_API std::string FindInstalled(const std::string& Relative);

/** The folder that rdg/graph/Shaders and passes/Shaders lie in. */
DRYDOCK_API std::string FindShippedShaders();

/** Include folders for generated kernels; empty when the headers are nowhere. */
std::vector<std::string> FindKernelIncludes();

} // namespace Drydock
