// Reads a file whole, and writes one aside before it takes its place.
#include "Text/TextFile.h"

#include "Text/ConfigErrors.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace Drydock
{

namespace Files = std::filesystem;

FError MakeWriteError(const std::string& Path, const std::string& Why)
{
	return FError({.Code = ErrorFileNotWritten, .Message = "cannot be written: " + Why, .File = Path}, ExitFiles);
}

std::string ReadTextFile(const std::string& Path)
{
	std::ifstream Stream(Path, std::ios::binary);
	std::string Text(std::istreambuf_iterator<char>(Stream), {});
	if (!Stream)
	{
		throw FError({.Code = ErrorFileMissing, .Message = "cannot be read", .File = Path}, ExitFiles);
	}
	return Text;
}

void WriteWholeFile(const std::string& Path, const std::string& Text)
{
	std::ofstream Stream(Path, std::ios::binary);
	Stream << Text;
	Stream.close();
	if (!Stream)
	{
		throw MakeWriteError(Path, "the disk refuses it");
	}
}

void WriteTextFile(const std::string& Path, const std::string& Text)
{
	const Files::path Target(Path);
	const Files::path Aside(Path + ".writing." + std::to_string(getpid()));
	std::error_code Error;
	if (Target.has_parent_path())
	{
		Files::create_directories(Target.parent_path(), Error);
	}
	if (Error)
	{
		throw MakeWriteError(Path, Error.message());
	}
	WriteWholeFile(Aside.string(), Text);
	Files::rename(Aside, Target, Error);
	if (Error)
	{
		std::error_code Ignored;
		Files::remove(Aside, Ignored);
		throw MakeWriteError(Path, Error.message());
	}
}

} // namespace Drydock
