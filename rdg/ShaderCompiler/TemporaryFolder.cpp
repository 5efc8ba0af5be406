// Makes temporary folders by unpredictable names, and checks what is written to them.
#include "TemporaryFolder.h"

#include "Diagnostics.h"
#include "Leftovers.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <unistd.h>

namespace Drydock
{

namespace
{

FError MakeError(const std::string& Path, const std::string& What, int Error)
{
	return FError(
		{ESeverity::Error, 5004, What + ": " + DescribeSystemError(Error) + " (temporary files go where TMPDIR says)",
			Path, 0, 0, {}},
		ExitFiles);
}

} // namespace

std::string GetTemporaryParent()
{
	for (const char* Variable : {"TMPDIR", "TMP", "TEMP", "TEMPDIR"})
	{
		if (const char* const Value = std::getenv(Variable); Value && *Value)
		{
			return Value;
		}
	}
	return "/tmp";
}

FTemporaryFolder::FTemporaryFolder()
	: Owner(getpid())
{
	const FEndActionsHeld Held; // until its end is certain
	const std::string Parent = GetTemporaryParent();
	std::string Pattern = Parent + "/" + GetLeftoverPrefix() + "XXXXXX";
	if (!mkdtemp(Pattern.data()))
	{
		throw MakeError(Parent, "no temporary folder can be made here", errno);
	}
	Path = Pattern;
	Lock = FFileDescriptor(open(Path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
	flock(Lock.Get(), LOCK_EX | LOCK_NB);
	Removal.emplace(
		[Folder = Path]
		{
			std::error_code Ignored;
			std::filesystem::remove_all(Folder, Ignored);
		});
}

FTemporaryFolder::~FTemporaryFolder()
{
	if (Owner == getpid())
	{
		std::error_code Ignored;
		std::filesystem::remove_all(Path, Ignored);
	}
}

std::string FTemporaryFolder::WriteFile(const std::string& Name, const std::string& Bytes) const
{
	const std::string File = Path + "/" + Name;
	FFileDescriptor Stream(open(File.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
	const int Error = Stream ? WriteAndClose(std::move(Stream), Bytes) : errno;
	if (Error != 0)
	{
		throw MakeError(File, "cannot be written", Error);
	}
	return File;
}

void FTemporaryFolder::CheckSpace() const
{
	constexpr size_t Enough = 64 * 1024;
	const std::string Probe = WriteFile("probe", std::string(Enough, ' '));
	unlink(Probe.c_str());
}

} // namespace Drydock
