// Reads a file whole, and writes one aside before it takes its place.
#include "Text/TextFile.h"

#include "Text/AsideFile.h"
#include "Text/ConfigErrors.h"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace Drydock
{

std::optional<std::string> TryReadTextFile(const std::string& Path)
{
	std::error_code Ignored;
	std::ifstream Stream(Path, std::ios::binary);
	if (!Stream || std::filesystem::is_directory(Path, Ignored))
	{
		return std::nullopt;
	}
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

std::string ReadTextFile(const std::string& Path, const char* Message)
{
	std::optional<std::string> Text = TryReadTextFile(Path);
	if (!Text)
	{
		throw FError({.Code = ErrorFileMissing, .Message = Message, .File = Path}, ExitFiles);
	}
	return std::move(*Text);
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
	FAsideFile Aside{std::filesystem::path(Path)};
	WriteWholeFile(Aside.GetPath().string(), Text);
	Aside.PutInPlace();
}

} // namespace Drydock
