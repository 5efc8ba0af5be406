// Finds the library's own files beside the shared object that this code is in.
#include "InstallPaths.h"

#include <dlfcn.h>
#include <filesystem>

namespace Drydock
{

namespace fs = std::filesystem;

std::string GetLibraryPath()
{
	Dl_info Info;
	if (dladdr(reinterpret_cast<const void*>(&FindInstalled), &Info) && Info.dli_fname)
	{
		std::error_code Error;
		const fs::path Path = fs::canonical(Info.dli_fname, Error);
		return Error ? std::string(Info.dli_fname) : Path.string();
	}
	return {};
}

std::string FindInstalled(const std::string& Relative)
{
	const fs::path Folder = fs::path(GetLibraryPath()).parent_path();
	fs::path Installation = Folder;
	for ([[maybe_unused]] const fs::path& Level : fs::path(DRYDOCK_INSTALL_LIBRARIES))
	{
		Installation = Installation.parent_path();
	}
	for (const fs::path& Prefix : {Folder.parent_path(), Installation})
	{
		std::error_code Error;
		const fs::path Candidate = Prefix / Relative;
		if (fs::exists(Candidate, Error))
		{
			return Candidate.string();
		}
	}
	return {};
}

std::string FindShippedShaders()
{
	return FindInstalled("share/drydock/rdg/graph/Shaders").empty() ? DRYDOCK_SOURCE_DIR
																	: FindInstalled("share/drydock");
}

std::vector<std::string> FindKernelIncludes()
{
	for (const std::string& Root : {FindInstalled("include/drydock"), std::string(DRYDOCK_SOURCE_DIR)})
	{
		std::error_code Error;
		const fs::path Lanes = fs::path(Root) / "rdg/shader/Lanes";
		if (!Root.empty() && fs::exists(Lanes / "Lanes.h", Error))
		{
			return {Lanes.string(), (fs::path(Root) / "rdg/core/Kernel").string()};
		}
	}
	return {};
}

} // namespace Drydock
