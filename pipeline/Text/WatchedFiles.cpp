// Lists shader files, and asks the system for the state of each.
#include "Text/WatchedFiles.h"

#include "GlobalShader.h"
#include "RangeTools.h"
#include "ShaderCompiler.h"
#include "ShaderCore.h"

#include <filesystem>
#include <set>
#include <sys/stat.h>

namespace Drydock
{

namespace Files = std::filesystem;

void FWatchedFiles::AddFile(const std::string& Path)
{
	constexpr int64_t Billion = 1'000'000'000;
	struct stat Status = {};
	// The time of a change, not of a writing: a file that becomes readable again is not written.
	States[Path] =
		stat(Path.c_str(), &Status) != 0
			? std::array<int64_t, 3>()
			: std::array<int64_t, 3>{static_cast<int64_t>(Status.st_ino), static_cast<int64_t>(Status.st_size),
				  static_cast<int64_t>(Status.st_ctim.tv_sec) * Billion + Status.st_ctim.tv_nsec};
}

void FWatchedFiles::AddShaders()
{
	MapShippedShaders(); // before the first shader is compiled nobody has: then it would look as if they had come
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

void FWatchedFiles::AddUnknown(const FWatchedFiles& Others)
{
	States.insert(Others.States.begin(), Others.States.end());
}

std::optional<std::vector<std::string>> FWatchedFiles::FindEdited(const FWatchedFiles& Before) const
{
	constexpr std::array<int64_t, 3> Absent = {};
	if (States.size() != Before.States.size())
	{
		return {};
	}
	std::vector<std::string> Edited;
	for (const auto& [Path, State] : States)
	{
		const auto Known = Before.States.find(Path);
		if (Known == Before.States.end() || (State == Absent) != (Known->second == Absent))
		{
			return {};
		}
		if (State != Known->second)
		{
			Edited.push_back(Path);
		}
	}
	return Edited;
}

std::vector<std::string> FWatchedFiles::GetPaths() const
{
	return ToVector<std::string>(States, [](const auto& Each) { return Each.first; });
}

} // namespace Drydock
