// Opens, checks and reads by the system's own calls: streams of the library open a pipe and wait.
#include "RegularFile.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace Drydock
{

namespace
{

std::string DescribeError(int Error)
{
	return std::generic_category().message(Error);
}

/** Describes what is in the place of a regular file; empty if the file is one. */
std::string DescribeOther(mode_t Mode)
{
	return S_ISREG(Mode)    ? ""
		   : S_ISDIR(Mode)  ? "it is a folder"
		   : S_ISFIFO(Mode) ? "it is a pipe, and only files are read"
		   : S_ISSOCK(Mode) ? "it is a socket, and only files are read"
							: "it is a device, and only files are read";
}

/** Reads up to Count bytes; fewer at the end, or with an error. */
size_t ReadAll(int Descriptor, char* To, size_t Count, int& OutError)
{
	size_t NumRead = 0;
	while (NumRead < Count)
	{
		const ssize_t Step = read(Descriptor, To + NumRead, Count - NumRead);
		if (Step < 0 && errno == EINTR)
		{
			continue;
		}
		OutError = Step < 0 ? errno : 0;
		if (Step <= 0)
		{
			break;
		}
		NumRead += static_cast<size_t>(Step);
	}
	return NumRead;
}

/** Reads to the end by Read(Bytes, Count), whatever size was said; a byte more than MaxBytes is too much. */
template<typename TFunction>
FFileBytes ReadToEnd(size_t SizeSaid, size_t MaxBytes, const TFunction& Read)
{
	FFileBytes Result;
	std::string Bytes;
	size_t Step = std::min(SizeSaid, MaxBytes) + 1;
	for (bool bMore = true; bMore;)
	{
		const size_t NumBefore = Bytes.size();
		Step = std::min(std::max<size_t>(Step, 4096), MaxBytes + 1 - NumBefore);
		Bytes.resize(NumBefore + Step);
		const size_t NumRead = Read(Bytes.data() + NumBefore, Step, Result.Problem);
		Bytes.resize(NumBefore + NumRead);
		bMore = NumRead == Step && Bytes.size() <= MaxBytes;
		Step = Bytes.size();
	}
	Result.bTooLarge = Bytes.size() > MaxBytes;
	if (Result.bTooLarge)
	{
		Result.Problem = "it has more than " + std::to_string(MaxBytes) + " bytes, and no more are read";
	}
	if (Result.Problem.empty())
	{
		Result.Bytes = std::move(Bytes);
	}
	return Result;
}

} // namespace

std::string DescribeWindowsPath(const std::string& Path)
{
	const size_t Colon = Path.find(':');
	const bool bDrive = Colon != std::string::npos && Colon > 0 && Colon + 1 < Path.size() &&
						std::isalpha(static_cast<unsigned char>(Path[Colon - 1])) &&
						(Colon == 1 || Path[Colon - 2] == '/') && (Path[Colon + 1] == '\\' || Path[Colon + 1] == '/');
	if (!bDrive)
	{
		return Path.find('\\') == std::string::npos ? "" : "; folders of a path are parted by /, not by \\";
	}
	std::string Here = Path.substr(Colon + 1);
	std::replace(Here.begin(), Here.end(), '\\', '/');
	return std::string("; the drive of Windows is /mnt/") +
		   static_cast<char>(std::tolower(static_cast<unsigned char>(Path[Colon - 1]))) + " in WSL: /mnt/" +
		   static_cast<char>(std::tolower(static_cast<unsigned char>(Path[Colon - 1]))) + Here;
}

FRegularFile::FRegularFile(const std::string& Path)
{
	if (Path.find('\0') != std::string::npos)
	{
		Problem = "its path holds the character NUL";
		return;
	}
	Descriptor = open(Path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
	struct stat Status = {};
	if (Descriptor < 0)
	{
		const int Error = errno;
		const bool bSocket = Error == ENXIO && stat(Path.c_str(), &Status) == 0 && !S_ISREG(Status.st_mode);
		Problem = bSocket ? DescribeOther(Status.st_mode) : DescribeError(Error) + DescribeWindowsPath(Path);
		return;
	}
	Problem = fstat(Descriptor, &Status) != 0 ? DescribeError(errno) : DescribeOther(Status.st_mode);
	Size = Problem.empty() ? static_cast<uint64_t>(Status.st_size) : 0;
}

FRegularFile::~FRegularFile()
{
	if (Descriptor >= 0)
	{
		close(Descriptor);
	}
}

size_t FRegularFile::Read(void* Bytes, size_t Count)
{
	int Error = 0;
	const size_t NumRead = Problem.empty() ? ReadAll(Descriptor, static_cast<char*>(Bytes), Count, Error) : 0;
	if (Error != 0)
	{
		Problem = DescribeError(Error);
	}
	return NumRead;
}

FFileBytes ReadRegularFile(const std::string& Path, size_t MaxBytes)
{
	FRegularFile File(Path);
	if (!File.GetProblem().empty())
	{
		return {std::nullopt, File.GetProblem(), false};
	}
	if (File.GetSize() > MaxBytes)
	{
		return {std::nullopt,
			"it has " + std::to_string(File.GetSize()) + " bytes, and at most " + std::to_string(MaxBytes) +
				" are read",
			true};
	}
	return ReadToEnd(static_cast<size_t>(File.GetSize()), MaxBytes,
		[&File](char* To, size_t Count, std::string& OutProblem)
		{
			const size_t NumRead = File.Read(To, Count);
			OutProblem = File.GetProblem();
			return NumRead;
		});
}

FFileBytes ReadStandardInput(size_t MaxBytes)
{
	return ReadToEnd(0, MaxBytes,
		[](char* To, size_t Count, std::string& OutProblem)
		{
			int Error = 0;
			const size_t NumRead = ReadAll(STDIN_FILENO, To, Count, Error);
			OutProblem = Error != 0 ? DescribeError(Error) : "";
			return NumRead;
		});
}

} // namespace Drydock
