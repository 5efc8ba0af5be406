// A patch from scratch: the project of templates/MyPatch under another name, with a small frame to run on.
#pragma once

#include "DrydockAPI.h"

#include <filesystem>
#include <string>
#include <vector>

namespace Drydock
{

/** A file of a new project. */
struct FPatchFile
{
	std::string Path; // relative to the project's folder, with /
	std::string Text; // or bytes
};

/** The folder of the files that drydock brings along to make others from, in an installed tree and in its source. */
DRYDOCK_API std::string FindTemplates();

/** The text of one of drydock's own files. Throws FError (exit code 3) where it is not where it was installed. */
DRYDOCK_API std::string ReadOwnFile(const std::filesystem::path& Path);

/** The files below a folder of templates, with their paths from it on. */
DRYDOCK_API std::vector<FPatchFile> ReadTemplate(const std::filesystem::path& Folder);

/** Every "MyPatch" of the text becomes Name. */
DRYDOCK_API std::string RenamePatch(const std::string& Text, const std::string& Name);

/** The files of a patch of that name, sorted by path. Throws FError (exit code 3) when drydock's own files are not
 * where they were installed. */
DRYDOCK_API std::vector<FPatchFile> MakePatchFiles(const std::string& Name);

/** Makes Folder with the files: written aside and renamed, so that all are there or none. Throws FError: exit code 2
 * when there is something of that name, 3 when it cannot be written. */
DRYDOCK_API void WritePatch(const std::string& Folder, const std::vector<FPatchFile>& Files);

} // namespace Drydock
