// Adds to a message about a shader the line of the source with a caret, and the file's place on disk.
#pragma once

#include "Diagnostics.h"
#include "ShaderCompileRequest.h"

namespace Drydock
{

/** The same errors: those that follow from one name that is not there are one, an entry that is missing gets the
 * nearest name, and each with a line gets "12 | float A = Foo;", a caret below the name that it is about, and the path
 * on disk. */
DRYDOCK_API FError ExplainShaderErrors(const FError& Error, const FShaderCompileRequest& Request);

} // namespace Drydock
