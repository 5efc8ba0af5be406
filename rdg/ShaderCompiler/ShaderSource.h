// One text from a .usf and all it includes: virtual paths, every file once, macros replaced, `#line N "/Virtual/path"`
// at each seam, rewritten for the front end (ShaderRewrites.h). That text is what is compiled and what the cache key
// covers.
#pragma once

#include "Diagnostics.h"
#include "ShaderCompileRequest.h"
#include "ShaderText.h"

namespace Drydock
{

/** Flattens Request's file behind its defines. Throws FError (DD6001 file or include not found, DD6002 a directive or a
 * macro that is wrong, DD6003 sources that cannot be flattened) with every fault found. */
DRYDOCK_API FShaderSource FlattenShader(const FShaderCompileRequest& Request);

/** Plain ASCII with \n line ends: byte-order mark, CRLF, NUL and the bytes of any encoding of comments removed, without
 *  moving a line. A double-byte encoding's second byte may be a backslash; it does not join lines. */
DRYDOCK_API std::string NormalizeShaderText(const std::string& Bytes);

/** "/A/B/../C.ush" -> "/A/C.ush"; relative paths are taken from the folder of Includer. */
DRYDOCK_API std::string ResolveVirtualPath(const std::string& Path, const std::string& Includer);

} // namespace Drydock
