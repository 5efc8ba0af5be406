// A text file read and written whole: written aside and renamed, so that nobody ever sees half of it.
#pragma once

#include "Diagnostics.h"

#include <string>

namespace Drydock
{

/** All its bytes. Throws FError (exit code 3) when it cannot be read. */
DRYDOCK_API std::string ReadTextFile(const std::string& Path);

/** "cannot be written: Why", with exit code 3. */
DRYDOCK_API FError MakeWriteError(const std::string& Path, const std::string& Why);

/** Writes Path in place; for a file in a folder that is not seen yet. Throws FError (exit code 3). */
DRYDOCK_API void WriteWholeFile(const std::string& Path, const std::string& Text);

/** One file, written aside and renamed; its folder is made. Throws FError (exit code 3) when it cannot be written. */
DRYDOCK_API void WriteTextFile(const std::string& Path, const std::string& Text);

} // namespace Drydock
