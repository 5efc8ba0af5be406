// What a run does about NaN and infinities: r.Drydock.NonFinite. Source: drydock.
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

} // namespace Drydock
