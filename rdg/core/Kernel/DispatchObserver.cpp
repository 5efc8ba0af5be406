// Keeps the one observer.
#include "DispatchObserver.h"

#include <atomic>

namespace Drydock
{

namespace
{

std::atomic<IDispatchObserver*> GObserver{nullptr};

} // namespace

IDispatchObserver::~IDispatchObserver() = default;

IDispatchObserver* GetDispatchObserver()
{
	return GObserver.load(std::memory_order_relaxed);
}

FScopedDispatchObserver::FScopedDispatchObserver(IDispatchObserver& Observer)
{
	GObserver = &Observer;
}

FScopedDispatchObserver::~FScopedDispatchObserver()
{
	GObserver = nullptr;
}

} // namespace Drydock
