// Source: drydock.
#include "NonFinite.h"

#include "HAL/IConsoleManager.h"

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarNonFinite(TEXT("r.Drydock.NonFinite"), 0,
	TEXT("NaN and infinities: 0 propagate (default), 1 load scene colour with 0 in their place, 2 fail the run."),
	ECVF_RenderThreadSafe);

} // namespace

ENonFinitePolicy GetNonFinitePolicy()
{
	return static_cast<ENonFinitePolicy>(FMath::Clamp(CVarNonFinite.GetValueOnAnyThread(), 0, 2));
}

} // namespace Drydock
