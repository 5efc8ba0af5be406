// A text file read and written whole. Only regular files of a stated size are read: whoever names a pipe or a device in
// a config gets a message, not a program that waits.
#pragma once

#include "Diagnostics.h"
#include "RegularFile.h"

#include <optional>
#include <string>

namespace Drydock
{

/** Limit for drydock's own files that hold pictures or the state of views: 16 GB. */
constexpr size_t MaxBinaryBytes = size_t(1) << 34;

/** All bytes of the file; nothing if it cannot be read, is not a regular file, or has more than MaxBytes. */
DRYDOCK_API std::optional<std::string> TryReadTextFile(const std::string& Path, size_t MaxBytes = MaxTextBytes);

/** All its bytes. Throws FError (exit code 3): Message and why, or DD5007 where it has more than MaxBytes. */
DRYDOCK_API std::string ReadTextFile(
	const std::string& Path, const char* Message = "cannot be read", size_t MaxBytes = MaxTextBytes);

/** All that stdin gives. Throws as ReadTextFile. */
DRYDOCK_API std::string ReadStandardInputText();

/** Writes Path in place; for a file in a folder that is not seen yet. Throws FError (exit code 3). */
DRYDOCK_API void WriteWholeFile(const std::string& Path, const std::string& Text);

/** Writes one file aside and renames it; its folder is made. Throws FError (exit code 3) when it cannot be written. */
DRYDOCK_API void WriteTextFile(const std::string& Path, const std::string& Text);

} // namespace Drydock
