// ParallelFor for code from outside: the indices in their order, on the calling thread. Source: engine
// Async/ParallelFor.h.
#pragma once

#include "Templates/Function.h"

enum class EParallelForFlags
{
	None,
	ForceSingleThread,
	Unbalanced,
};

inline void ParallelFor(int32 Num, TFunctionRef<void(int32)> Body, EParallelForFlags = EParallelForFlags::None)
{
	for (int32 Index = 0; Index < Num; ++Index)
	{
		Body(Index);
	}
}
