// Reads files that strangers name: only regular files, and no more bytes than the caller wants. A pipe would wait for
// ever, a device may act on being read, and an endless file fills the memory.
#pragma once

#include "DrydockAPI.h"
#include "Templates/UnrealTemplate.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace Drydock
{

/** No text that drydock reads is larger: a config of 16 MB holds a million numbers, some thousand times what the
 * largest that ships does. */
constexpr size_t MaxTextBytes = size_t(16) << 20;

/** For the end of a message about a path that does not exist: where the path of Windows is in WSL, "; the drive of
 * Windows is /mnt/c in WSL: /mnt/c/a.exr"; empty for other paths. */
DRYDOCK_API std::string DescribeWindowsPath(const std::string& Path);

/** A file that is open for reading. */
class DRYDOCK_API FRegularFile : private FNoncopyable
{
public:
	/** Opens without waiting for anybody. A file that is not regular is refused once it is open, because it could be
	 * replaced between a check and the opening. */
	explicit FRegularFile(const std::string& Path);
	~FRegularFile();

	/** Why it cannot be read, "Permission denied" or "it is a folder"; empty while all is well. */
	const std::string& GetProblem() const { return Problem; }

	/** Bytes, as the system reports them; files of /proc have more than the reported 0. */
	uint64_t GetSize() const { return Size; }

	/** The number of bytes read: fewer than Count at the end of the file, or where reading fails, which is a problem.
	 */
	size_t Read(void* Bytes, size_t Count);

private:
	int Descriptor = -1;
	uint64_t Size = 0;
	std::string Problem;
};

struct FFileBytes
{
	std::optional<std::string> Bytes; // none: it cannot be read
	std::string Problem;              // why, as FRegularFile says it
	bool bTooLarge = false;           // the file has more than was allowed
};

/** All bytes of a regular file of at most MaxBytes. */
DRYDOCK_API FFileBytes ReadRegularFile(const std::string& Path, size_t MaxBytes = MaxTextBytes);

/** All that stdin gives, whatever it is, up to MaxBytes. */
DRYDOCK_API FFileBytes ReadStandardInput(size_t MaxBytes = MaxTextBytes);

} // namespace Drydock
