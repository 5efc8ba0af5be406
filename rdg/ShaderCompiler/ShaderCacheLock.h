// A lock of the shader cache, which processes hold while they compile, so that two do not compile the same.
#pragma once

#include "TrustedFolder.h"

namespace Drydock
{

/** Held for its scope. Who waits is told who holds it after 5 s, and goes on without it after DRYDOCK_LOCK_SECONDS
 * (30): the other may hang, and what both compile is the same. So does who cannot lock in this folder at all. */
class DRYDOCK_API FShaderCacheLock
{
public:
	/** Name: in the folder "locks". */
	FShaderCacheLock(const FTrustedFolder& Folder, const std::string& Name);
	~FShaderCacheLock();
	FShaderCacheLock(const FShaderCacheLock&) = delete;
	FShaderCacheLock& operator=(const FShaderCacheLock&) = delete;

private:
	FFileDescriptor Held;
};

} // namespace Drydock
