// What a run does about NaN and infinities (r.Drydock.NonFinite) and about spikes (r.Drydock.SceneColorClamp) of the
// scene.
#pragma once

#include "CoreMinimal.h"

namespace Drydock
{

enum class ENonFinitePolicy : int32
{
	Propagate = 0, // as the engine does; counted and warned of
	Zero = 1,      // scene colour that is not finite is loaded as 0
	Error = 2,     // the run fails (exit code 1)
};

ENonFinitePolicy GetNonFinitePolicy();

/** Non-finite values found in an image. */
struct FNonFiniteCount
{
	size_t Count = 0;
	int FirstX = 0;
	int FirstY = 0;

	void Add(int X, int Y)
	{
		if (Count++ == 0)
		{
			FirstX = X;
			FirstY = Y;
		}
	}
};

/** Largest magnitude of a channel of scene colour, from r.Drydock.SceneColorClamp; infinity where it is off (0 and
 * below, NaN). It comes before the policy: an infinity that it cuts off is not counted any more. */
float GetSceneColorClamp();

} // namespace Drydock
