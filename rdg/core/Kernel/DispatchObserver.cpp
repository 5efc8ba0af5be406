// Keeps the observers.
#include "DispatchObserver.h"

namespace Drydock
{

namespace
{

std::vector<IDispatchObserver*> GObservers;

} // namespace

IDispatchObserver::~IDispatchObserver() = default;

const std::vector<IDispatchObserver*>& GetDispatchObservers()
{
	return GObservers;
}

FScopedDispatchObserver::FScopedDispatchObserver(IDispatchObserver& Observer)
{
	GObservers.push_back(&Observer);
}

FScopedDispatchObserver::~FScopedDispatchObserver()
{
	GObservers.pop_back();
}

} // namespace Drydock
