// Applies the policies for values that are not finite, and for spikes.
#include "SceneFile/NonFinite.h"

#include "HAL/IConsoleManager.h"

#include <limits>

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarNonFinite(TEXT("r.Drydock.NonFinite"), 0,
	TEXT("NaN and infinities: 0 propagate (default), 1 load 0, and for depth what lies beside, 2 fail the run."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarSceneColorClamp(TEXT("r.Drydock.SceneColorClamp"), 0.0f,
	TEXT("Above 0: red, green and blue of the scene are loaded within -value .. value, infinities too.\n")
		TEXT("NaN is left to r.Drydock.NonFinite. 0: off (default)."),
	ECVF_RenderThreadSafe);

} // namespace

ENonFinitePolicy GetNonFinitePolicy()
{
	return static_cast<ENonFinitePolicy>(FMath::Clamp(CVarNonFinite.GetValueOnAnyThread(), 0, 2));
}

float GetSceneColorClamp()
{
	const float Clamp = CVarSceneColorClamp.GetValueOnAnyThread();
	return Clamp > 0.0f ? Clamp : std::numeric_limits<float>::infinity();
}

} // namespace Drydock
