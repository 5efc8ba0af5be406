// Reads a file whole, and writes one aside before it takes its place.
#include "Text/TextFile.h"

#include "Text/AsideFile.h"
#include "Text/ConfigErrors.h"
#include "Text/LimitErrors.h"

#include <filesystem>
#include <fstream>

namespace Drydock
{

namespace
{

std::string TakeText(FFileBytes Read, const std::string& Path, const char* Message)
{
	if (!Read.Bytes)
	{
		const int Code = Read.bTooLarge ? static_cast<int>(ErrorTextTooLarge) : static_cast<int>(ErrorFileMissing);
		throw FError({.Code = Code, .Message = std::string(Message) + ": " + Read.Problem, .File = Path}, ExitFiles);
	}
	return std::move(*Read.Bytes);
}

} // namespace

std::optional<std::string> TryReadTextFile(const std::string& Path, size_t MaxBytes)
{
	return ReadRegularFile(Path, MaxBytes).Bytes;
}

std::string ReadTextFile(const std::string& Path, const char* Message, size_t MaxBytes)
{
	return TakeText(ReadRegularFile(Path, MaxBytes), Path, Message);
}

std::string ReadStandardInputText()
{
	return TakeText(ReadStandardInput(), "standard input", "cannot be read");
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
