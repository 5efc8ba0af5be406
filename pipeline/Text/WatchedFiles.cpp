// Lists shader files and compares times of last change.
#include "Text/WatchedFiles.h"

#include "GlobalShader.h"
#include "ShaderCompiler.h"

#include <filesystem>
#include <set>

namespace Drydock
{

namespace Files = std::filesystem;

void FWatchedFiles::AddFile(const std::string& Path)
{
	std::error_code Error;
	const Files::file_time_type Time = Files::last_write_time(Path, Error);
	Times[Path] = Error ? 0 : static_cast<int64_t>(Time.time_since_epoch().count());
}

void FWatchedFiles::AddShaders()
{
	std::set<Files::path> Folders = {Files::path(FindShaderFile("/Engine/Private/Common.ush")).parent_path()};
	ForEachGlobalShader([&](const FGlobalShaderType& Type)
		{ Folders.insert(Files::path(FindShaderFile(Type.GetShaderFilename())).parent_path()); });
	for (const Files::path& Folder : Folders)
	{
		std::error_code Error;
		for (Files::recursive_directory_iterator Entry(Folder, Error), End; !Error && Entry != End;
			 Entry.increment(Error))
		{
			const std::string Extension = Entry->path().extension().string();
			if (Extension == ".usf" || Extension == ".ush")
			{
				AddFile(Entry->path().string());
			}
		}
	}
}

std::vector<std::string> FWatchedFiles::GetPaths() const
{
	std::vector<std::string> Paths;
	for (const auto& [Path, Time] : Times)
	{
		Paths.push_back(Path);
	}
	return Paths;
}

} // namespace Drydock
