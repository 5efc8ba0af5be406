// Fixed seeds and random elements for the tests of containers against a model.
#pragma once

#include <random>

#include "CoreMinimal.h"

inline constexpr uint32 ModelSeeds = 24;
inline constexpr int32 ModelSteps = 400;

/** Random numbers, and the elements of a type that are made of them. */
template<typename T>
struct TModelRandom
{
	std::mt19937 Engine;

	explicit TModelRandom(uint32 Seed)
		: Engine(Seed)
	{
	}
	/** Below Count. */
	int32 Below(int32 Count) { return static_cast<int32>(Engine() % static_cast<uint32>(Count)); }
	T Element() { return Make(Below(9)); }
	static T Make(int32 Number)
	{
		if constexpr (std::is_same_v<T, FString>)
		{
			return FString::Printf(TEXT("a text too long to lie inside of the string itself: %d"), Number);
		}
		else
		{
			return static_cast<T>(Number);
		}
	}
};
