// Defines the handle of a timer (TimerManager.h). Source: engine file Engine/TimerHandle.h.
#pragma once

#include "CoreMinimal.h"

struct FTimerHandle
{
	bool IsValid() const { return Handle != 0; }
	void Invalidate() { Handle = 0; }
	bool operator==(const FTimerHandle&) const = default;

private:
	friend class FTimerManager;

	uint64 Handle = 0;
};
