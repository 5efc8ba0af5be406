// The grid of the sampler's coordinates. A shader that computes positions from the rect's corner and puts them on this
// grid before they become UV gives the same bits wherever the rect lies in its texture.
#pragma once

#include "HAL/IConsoleManager.h"

namespace Drydock
{

/** Steps of the sampler to a texel; 0 where it takes positions as they are (r.Drydock.SampleBits 0). */
inline double GetSampleSteps()
{
	const IConsoleVariable* SampleBits = IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.SampleBits"));
	return SampleBits && SampleBits->GetInt() != 0 ? 256.0 : 0.0;
}

} // namespace Drydock
