// Keeps the one who chooses what shaders run on.
#include "DispatchBackend.h"

#include <atomic>

namespace Drydock
{

namespace
{

std::atomic<FDispatchBackendChooser> GChooser{nullptr};

} // namespace

IDispatchBackend::~IDispatchBackend() = default;

IDispatchBackend* GetDispatchBackend()
{
	const FDispatchBackendChooser Choose = GChooser.load(std::memory_order_relaxed);
	return Choose ? Choose() : nullptr;
}

void SetDispatchBackendChooser(FDispatchBackendChooser Chooser)
{
	GChooser = Chooser;
}

} // namespace Drydock
