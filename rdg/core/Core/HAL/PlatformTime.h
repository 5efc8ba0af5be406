// FPlatformTime: a clock that never goes back. Source: engine HAL/PlatformTime.h.
#pragma once

#include "CoreTypes.h"

#include <chrono>

struct FPlatformTime
{
	/** Seconds since some fixed moment. */
	static double Seconds()
	{
		return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
	}
	/** Nanoseconds since that moment. */
	static uint64 Cycles64()
	{
		return static_cast<uint64>(
			std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
				.count());
	}
	static double GetSecondsPerCycle64() { return 1e-9; }
	static double ToSeconds64(uint64 Cycles) { return static_cast<double>(Cycles) * 1e-9; }
	static double ToMilliseconds64(uint64 Cycles) { return static_cast<double>(Cycles) * 1e-6; }
};
