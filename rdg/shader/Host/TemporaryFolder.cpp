// Makes temporary folders by unpredictable names, and checks what is written to them.
#include "TemporaryFolder.h"

#include "Diagnostics.h"

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <string_view>
#include <system_error>
#include <unistd.h>

namespace Drydock
{

namespace
{

constexpr std::string_view NameBegin = "drydock-";

FError MakeError(const std::string& Path, const std::string& What, int Error)
{
	return FError(
		{ESeverity::Error, 5004, What + ": " + DescribeSystemError(Error) + " (temporary files go where TMPDIR says)",
			Path, 0, 0, {}},
		ExitFiles);
}

} // namespace

std::string MakeTemporaryName()
{
	return std::string(NameBegin) + std::to_string(getpid()) + "-";
}

void RemoveTemporaryFolders(const std::string& Parent)
{
	RemoveAbandonedFolders(Parent, [](const std::string& Begin) { return Begin.starts_with(NameBegin); });
}

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
try : Folder(GetTemporaryParent() + "/" + MakeTemporaryName())
{
}
catch (const std::system_error& Error)
{
	throw MakeError(GetTemporaryParent(), "no temporary folder can be made here", Error.code().value());
}

std::string FTemporaryFolder::Reserve(const std::string& Name) const
{
	try
	{
		return Folder.Reserve(Name);
	}
	catch (const std::system_error& Error)
	{
		throw MakeError(Folder.GetPath(), "cannot be written", Error.code().value());
	}
}

std::string FTemporaryFolder::WriteFile(const std::string& Name, const std::string& Bytes) const
{
	const std::string File = Reserve(Name);
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
