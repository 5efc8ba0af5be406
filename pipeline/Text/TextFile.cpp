// Reads a file whole, and writes one aside before it takes its place.
#include "Text/TextFile.h"

#include "Text/AsideFile.h"
#include "Text/ConfigErrors.h"
#include "Text/LimitErrors.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

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
	const int File = open(Path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
	int Error = File < 0 ? errno : 0;
	for (size_t Done = 0; Error == 0 && Done < Text.size();)
	{
		const ssize_t Count = write(File, Text.data() + Done, Text.size() - Done);
		Error = Count < 0 && errno != EINTR ? errno : 0;
		Done += Count > 0 ? static_cast<size_t>(Count) : 0;
	}
	if (File >= 0 && close(File) != 0 && Error == 0)
	{
		Error = errno; // file systems across a network say it here
	}
	if (Error != 0)
	{
		throw MakeWriteError(Path, std::strerror(Error));
	}
}

void WriteTextFile(const std::string& Path, const std::string& Text)
{
	FAsideFile Aside{std::filesystem::path(Path)};
	WriteWholeFile(Aside.GetPath().string(), Text);
	Aside.PutInPlace();
}

} // namespace Drydock
