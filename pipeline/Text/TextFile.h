// A text file read and written whole.
#pragma once

#include "Diagnostics.h"

#include <optional>
#include <string>

namespace Drydock
{

/** All its bytes; nothing where it cannot be read, or is a folder. */
DRYDOCK_API std::optional<std::string> TryReadTextFile(const std::string& Path);

/** All its bytes. Throws FError (exit code 3) with Message when it cannot be read. */
DRYDOCK_API std::string ReadTextFile(const std::string& Path, const char* Message = "cannot be read");

/** Writes Path in place; for a file in a folder that is not seen yet. Throws FError (exit code 3). */
DRYDOCK_API void WriteWholeFile(const std::string& Path, const std::string& Text);

/** Writes one file aside and renames it; its folder is made. Throws FError (exit code 3) when it cannot be written. */
DRYDOCK_API void WriteTextFile(const std::string& Path, const std::string& Text);

} // namespace Drydock
