// A folder for the files of one compilation, gone with its scope.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace Drydock
{

class FTemporaryFolder
{
public:
	FTemporaryFolder()
	{
		std::error_code Error;
		std::filesystem::path Parent = std::filesystem::temp_directory_path(Error);
		std::string Pattern = ((Error ? std::filesystem::path("/tmp") : Parent) / "drydock-XXXXXX").string();
		if (mkdtemp(Pattern.data()))
		{
			Path = Pattern;
		}
	}
	~FTemporaryFolder()
	{
		std::error_code Error;
		if (!Path.empty())
		{
			std::filesystem::remove_all(Path, Error);
		}
	}
	FTemporaryFolder(const FTemporaryFolder&) = delete;
	FTemporaryFolder& operator=(const FTemporaryFolder&) = delete;

	std::string Path; // empty: none could be made
};

} // namespace Drydock
