// Handles of delegate bindings. Source: drydock.
#include "Delegates/Delegate.h"

#include <atomic>

uint64 FDelegateHandle::GenerateId()
{
	static std::atomic<uint64> LastId{0};
	return ++LastId;
}
