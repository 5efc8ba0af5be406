// The radical inverse of a whole number: evenly spread numbers below 1. Source: engine Math/Halton.h.
#pragma once

#include "CoreTypes.h"

inline float Halton(int32 Index, int32 Base)
{
	float Result = 0.0f;
	float Fraction = 1.0f / static_cast<float>(Base);
	for (; Index > 0; Index /= Base, Fraction /= static_cast<float>(Base))
	{
		Result += static_cast<float>(Index % Base) * Fraction;
	}
	return Result;
}
