// Reads and writes through file descriptors, as often as it takes, and keeps the first error.
#include "FileDescriptor.h"

#include <cerrno>
#include <system_error>
#include <unistd.h>

namespace Drydock
{

int FFileDescriptor::Close()
{
	const int Closing = std::exchange(Value, -1);
	return Closing >= 0 && close(Closing) != 0 && errno != EINTR ? errno : 0;
}

int WriteAll(const FFileDescriptor& File, const std::string& Bytes)
{
	size_t Written = 0;
	while (Written < Bytes.size())
	{
		const ssize_t Count = write(File.Get(), Bytes.data() + Written, Bytes.size() - Written);
		if (Count < 0 && errno != EINTR)
		{
			return errno;
		}
		Written += Count > 0 ? size_t(Count) : 0;
	}
	return 0;
}

int WriteAndClose(FFileDescriptor File, const std::string& Bytes)
{
	const int Error = WriteAll(File, Bytes);
	return Error != 0 ? Error : File.Close();
}

std::string ReadToEnd(const FFileDescriptor& File, int& OutError)
{
	std::string Bytes;
	char Buffer[65536];
	OutError = 0;
	for (;;)
	{
		const ssize_t Count = read(File.Get(), Buffer, sizeof(Buffer));
		if (Count > 0)
		{
			Bytes.append(Buffer, size_t(Count));
		}
		else if (Count == 0 || errno != EINTR)
		{
			OutError = Count == 0 ? 0 : errno;
			return Bytes;
		}
	}
}

std::string DescribeSystemError(int Error)
{
	return std::generic_category().message(Error);
}

} // namespace Drydock
