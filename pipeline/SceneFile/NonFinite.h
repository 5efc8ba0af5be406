// Handles NaN and infinities (r.Drydock.NonFinite) and spikes (r.Drydock.SceneColorClamp) of a run's scene.
#pragma once

#include "CoreMinimal.h"

#include <string>
#include <utility>

namespace Drydock
{

enum class ENonFinitePolicy : int32
{
	Propagate = 0, // as the engine does; counted and warned of
	Zero = 1,      // what is not finite is loaded as 0, depth as the nearest one in its row
	Error = 2,     // the run fails (exit code 1)
};

ENonFinitePolicy GetNonFinitePolicy();

/** Non-finite values found in an image, or in a channel. */
struct FNonFiniteCount
{
	size_t Count = 0;
	int FirstX = 0;
	int FirstY = 0;

	void Add(int X, int Y) { Add(FNonFiniteCount{1, X, Y}); }

	void Add(const FNonFiniteCount& Other)
	{
		const bool bEarlier = std::pair(Other.FirstY, Other.FirstX) < std::pair(FirstY, FirstX);
		const FNonFiniteCount& First = Count == 0 || (Other.Count > 0 && bEarlier) ? Other : *this;
		*this = {Count + Other.Count, First.FirstX, First.FirstY};
	}
};

inline constexpr char SceneColorWhere[] = "scene colour";

/** Those of one channel of a scene's file, or of its colour's channels together. */
struct FNonFiniteChannel
{
	std::string Where; // SceneColorWhere, or "channel depth.Z", by the name in the file
	FNonFiniteCount Found;
};

/** Largest magnitude of a channel of scene colour, from r.Drydock.SceneColorClamp; infinity where it is off (0 and
 * below, NaN). It comes before the policy: an infinity that it cuts off is not counted any more. */
float GetSceneColorClamp();

} // namespace Drydock
