// A lock of the shader cache, which processes hold while they compile, so that two do not compile the same.
#pragma once

#include "Templates/UnrealTemplate.h"
#include "TrustedFolder.h"

namespace Drydock
{

/** Held for its scope. A waiting process reports the lock's holder after 5 s, and goes on without the lock after
 * DRYDOCK_LOCK_SECONDS (30): the holder may hang, and both compile the same. A process that cannot lock in this folder
 * at all goes on without it too. */
class DRYDOCK_API FShaderCacheLock : private FNoncopyable
{
public:
	/** Name: in the folder "locks". */
	FShaderCacheLock(const FTrustedFolder& Folder, const std::string& Name);
	~FShaderCacheLock();

private:
	FFileDescriptor Held;
};

} // namespace Drydock
