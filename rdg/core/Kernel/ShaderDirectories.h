// Finds the files behind virtual shader paths on disk.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Maps a virtual directory ("/Project") to a directory on disk. Later mappings of the same prefix win. bByDrydock: in
 * place of a plugin that may do so itself. */
DRYDOCK_API void AddShaderDirectory(
	const std::string& VirtualDirectory, const std::string& RealDirectory, bool bByDrydock = false);

/** Forgets all mappings that were added after the first Keep ones. */
DRYDOCK_API void ForgetShaderDirectories(size_t Keep);
DRYDOCK_API size_t CountShaderDirectories();

/** Folders in the engine's layout (Engine/Shaders of overlays), whose files stand before those of every mapping of
 * /Engine; a later folder stands before an earlier one. Returns the folders of before. */
DRYDOCK_API std::vector<std::string> SetShaderOverlays(std::vector<std::string> Folders);
DRYDOCK_API std::vector<std::string> GetShaderOverlays();

/** Real path of a virtual shader path, empty when no mapping fits or the file does not exist. */
DRYDOCK_API std::string FindShaderFile(const std::string& VirtualPath);

struct FShaderDirectory
{
	std::string Virtual; // no slash at the end
	std::string Real;
	bool bByDrydock = false;
};

/** Every mapping, in the order in which they were made. */
DRYDOCK_API std::vector<FShaderDirectory> GetShaderDirectories();

/** The virtual path of a file in the mapped directories that VirtualPath may have meant: the same name in another
 * folder or with another extension, else a similar name in the same folder, else one in another; empty when none is
 * near. */
DRYDOCK_API std::string FindNearestShaderFile(const std::string& VirtualPath);

} // namespace Drydock
