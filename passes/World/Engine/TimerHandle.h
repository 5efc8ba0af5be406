// Defines the handle of a timer: none is ever set here, because nothing ticks. Source: engine file
// Engine/TimerHandle.h.
#pragma once

#include "CoreMinimal.h"

struct FTimerHandle
{
	bool IsValid() const { return Handle != 0; }
	void Invalidate() { Handle = 0; }
	bool operator==(const FTimerHandle&) const = default;

private:
	uint64 Handle = 0;
};
