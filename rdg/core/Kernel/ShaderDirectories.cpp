// Maps virtual shader directories ("/Engine", "/Project") to folders on disk.
#include "ShaderDirectories.h"

#include "Diagnostics.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace Drydock
{

namespace
{

namespace fs = std::filesystem;

struct FMappings
{
	std::mutex Mutex;
	std::vector<FShaderDirectory> List;
	std::vector<std::string> Overlays;
};

FMappings& GetMappings()
{
	static FMappings Mappings;
	return Mappings;
}

bool EqualsIgnoringCase(const std::string& A, const std::string& B)
{
	return ToLowerCase(A) == ToLowerCase(B);
}

/** Shaders written on Windows name files in any case: what is not found as written is looked up by folder listing. */
std::string FindIgnoringCase(const fs::path& Root, const fs::path& Relative)
{
	fs::path Found = Root;
	for (const fs::path& Part : Relative)
	{
		std::error_code Error;
		if (fs::exists(Found / Part, Error))
		{
			Found /= Part;
			continue;
		}
		std::string Match;
		for (fs::directory_iterator It(Found, Error), End; !Error && It != End; It.increment(Error))
		{
			const std::string Name = It->path().filename().string();
			if (EqualsIgnoringCase(Name, Part.string()) && (Match.empty() || Name < Match))
			{
				Match = Name;
			}
		}
		if (Match.empty())
		{
			return {};
		}
		Found /= Match;
	}
	std::error_code Error;
	return fs::exists(Found, Error) ? Found.string() : std::string(); // the reader reports what else it may be
}

constexpr size_t MaxListed = 20000; // files; a whole disk may be mapped

/** Virtual paths of the shader files in every mapped directory. */
std::vector<std::string> ListShaderFiles()
{
	std::vector<std::string> Files;
	for (const FShaderDirectory& Mapping : GetShaderDirectories())
	{
		std::error_code Error;
		fs::recursive_directory_iterator It(Mapping.Real, fs::directory_options::skip_permission_denied, Error);
		for (const fs::recursive_directory_iterator End; !Error && It != End && Files.size() < MaxListed;
			 It.increment(Error))
		{
			const std::string Extension = It->path().extension().string();
			if (EqualsIgnoringCase(Extension, ".ush") || EqualsIgnoringCase(Extension, ".usf") || Extension == ".spv")
			{
				Files.push_back(Mapping.Virtual + "/" + It->path().lexically_relative(Mapping.Real).generic_string());
			}
		}
	}
	std::sort(Files.begin(), Files.end());
	return Files;
}

} // namespace

void AddShaderDirectory(const std::string& VirtualDirectory, const std::string& RealDirectory, bool bByDrydock)
{
	FShaderDirectory Mapping{VirtualDirectory, RealDirectory, bByDrydock};
	while (!Mapping.Virtual.empty() && Mapping.Virtual.back() == '/')
	{
		Mapping.Virtual.pop_back();
	}
	FMappings& Mappings = GetMappings();
	const std::lock_guard Lock(Mappings.Mutex);
	Mappings.List.push_back(std::move(Mapping));
}

size_t CountShaderDirectories()
{
	FMappings& Mappings = GetMappings();
	const std::lock_guard Lock(Mappings.Mutex);
	return Mappings.List.size();
}

void ForgetShaderDirectories(size_t Keep)
{
	FMappings& Mappings = GetMappings();
	const std::lock_guard Lock(Mappings.Mutex);
	Mappings.List.resize(std::min(Keep, Mappings.List.size()));
}

std::vector<std::string> SetShaderOverlays(std::vector<std::string> Folders)
{
	FMappings& Mappings = GetMappings();
	const std::lock_guard Lock(Mappings.Mutex);
	return std::exchange(Mappings.Overlays, std::move(Folders));
}

std::vector<std::string> GetShaderOverlays()
{
	FMappings& Mappings = GetMappings();
	const std::lock_guard Lock(Mappings.Mutex);
	return Mappings.Overlays;
}

namespace
{

/** The file of an overlay; empty: none has it. */
std::string FindOverlaidFile(const std::string& VirtualPath)
{
	constexpr std::string_view Root = "/Engine/";
	if (!EqualsIgnoringCase(VirtualPath.substr(0, Root.size()), std::string(Root)))
	{
		return {};
	}
	const std::vector<std::string> Overlays = GetShaderOverlays();
	for (auto Folder = Overlays.rbegin(); Folder != Overlays.rend(); ++Folder)
	{
		std::string Found = FindIgnoringCase(*Folder, VirtualPath.substr(Root.size()));
		if (!Found.empty())
		{
			return Found;
		}
	}
	return {};
}

} // namespace

std::string FindShaderFile(const std::string& VirtualPath)
{
	if (std::string Overlaid = FindOverlaidFile(VirtualPath); !Overlaid.empty())
	{
		return Overlaid;
	}
	std::vector<FShaderDirectory> Fitting;
	{
		FMappings& Mappings = GetMappings();
		const std::lock_guard Lock(Mappings.Mutex);
		for (const FShaderDirectory& Mapping : Mappings.List)
		{
			const std::string Prefix = Mapping.Virtual + "/";
			if (VirtualPath.size() > Prefix.size() && EqualsIgnoringCase(VirtualPath.substr(0, Prefix.size()), Prefix))
			{
				Fitting.push_back(Mapping);
			}
		}
	}
	// The longest prefix wins ("/Engine/Generated" before "/Engine"), then the latest mapping; the others stand behind
	// it.
	std::reverse(Fitting.begin(), Fitting.end());
	std::stable_sort(Fitting.begin(), Fitting.end(),
		[](const FShaderDirectory& A, const FShaderDirectory& B) { return A.Virtual.size() > B.Virtual.size(); });
	for (const FShaderDirectory& Mapping : Fitting)
	{
		const std::string Found = FindIgnoringCase(Mapping.Real, VirtualPath.substr(Mapping.Virtual.size() + 1));
		if (!Found.empty())
		{
			return Found;
		}
	}
	return {};
}

std::vector<FShaderDirectory> GetShaderDirectories()
{
	FMappings& Mappings = GetMappings();
	const std::lock_guard Lock(Mappings.Mutex);
	return Mappings.List;
}

std::string FindNearestShaderFile(const std::string& VirtualPath)
{
	const fs::path Wanted(VirtualPath);
	const std::string Stem = Wanted.stem().string();
	std::map<std::string, std::string> Beside; // name without extension, path: in the same folder
	std::map<std::string, std::string> Elsewhere;
	for (const std::string& File : ListShaderFiles())
	{
		const fs::path Path(File);
		if (EqualsIgnoringCase(Path.stem().string(), Stem))
		{
			return File;
		}
		const bool bBeside = EqualsIgnoringCase(Path.parent_path().string(), Wanted.parent_path().string());
		(bBeside ? Beside : Elsewhere).emplace(Path.stem().string(), File);
	}
	for (const std::map<std::string, std::string>& Files : {Beside, Elsewhere})
	{
		std::vector<std::string> Names = ToVector<std::string>(Files, [](const auto& Each) { return Each.first; });
		const std::string Nearest = FindNearestName(Stem, Names);
		if (!Nearest.empty())
		{
			return Files.at(Nearest);
		}
	}
	return {};
}

} // namespace Drydock
