// Base of everything the RHI makes: an intrusive, thread-safe reference count. Source: engine RHIResources.h.
#pragma once

#include "CoreMinimal.h"

class DRYDOCK_API FRHIResource : public FRefCountBase
{
public:
	bool IsValid() const { return GetRefCount() > 0; }

protected:
	~FRHIResource() override; // only Release deletes
};

namespace Drydock
{

/** Zeroed memory, aligned to 64 bytes, or someone else's. */
class DRYDOCK_API FResourceMemory : private FNoncopyable
{
public:
	~FResourceMemory();

	/** Uses Memory, which must be 64-byte aligned and outlive its use; frees what was owned. */
	void PlaceAt(void* Memory);

	/** Allocates Size zeroed bytes when there is no memory yet. The pages of large blocks come with their first touch.
	 */
	void Ensure(size_t Size);

	uint8* Get() const { return Data; }

private:
	uint8* Data = nullptr;
	void* Owned = nullptr;
};

} // namespace Drydock
