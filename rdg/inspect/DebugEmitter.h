// A shader as C++ for a debugger: one thread, one function for each of the author's, his variables by their names, and
// a line table that names the .usf files.
#pragma once

#include "InspectedShader.h"

namespace Drydock
{

/** Text of a translation unit that exports GDebugKernelName. Entry: name of the entry point. Its instructions are those
 * of the shader's program, which must be there while it runs. Throws FSpirvError where the shader does something that
 * cannot be written so. */
DRYDOCK_API std::string EmitDebugKernel(const FInspectedShader& Shader, const std::string& Entry);

} // namespace Drydock
