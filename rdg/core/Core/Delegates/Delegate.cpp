// Hands out the handles by which the bindings of delegates are told apart.
#include "Delegates/Delegate.h"

#include <atomic>

uint64 FDelegateHandle::GenerateId()
{
	static std::atomic<uint64> LastId{0};
	return ++LastId;
}
