// Converts floating numbers to integers, with a result for every number. Every index, count, size or loop bound that
// was computed in floating point goes through it. A plain cast of NaN or of what the integer cannot hold is undefined.
#pragma once

#include "CoreTypes.h"

#include <algorithm>
#include <concepts>
#include <limits>

namespace Drydock
{

/** The number without its fraction (towards 0); beyond the integer's range, infinities too, the nearest end of it; NaN
 * gives 0. As shaders convert (Direct3D's rule). */
template<std::integral IntegerType, std::floating_point RealType>
constexpr IntegerType ToInteger(RealType Value)
{
	using FLimits = std::numeric_limits<IntegerType>;
	// Powers of two, or 0: exact in every floating type, where the largest integer itself is not.
	constexpr RealType Least = static_cast<RealType>(FLimits::min());
	constexpr IntegerType HalfOfEnd = FLimits::max() / 2 + 1;
	constexpr RealType End = static_cast<RealType>(HalfOfEnd) * RealType(2);
	if (!(Value > Least))
	{
		return Value <= Least ? FLimits::min() : IntegerType(0);
	}
	return Value < End ? static_cast<IntegerType>(Value) : FLimits::max();
}

/** Index among Count things, from a position among them: 0 .. Count - 1; NaN gives 0. If Count is 0, the result is 0.
 */
template<std::floating_point RealType>
constexpr int32 ToIndex(RealType Position, int32 Count)
{
	return std::max(0, std::min(ToInteger<int32>(Position), Count - 1));
}

/** Converts a count or a distance: the number without its fraction, within Least .. Most; NaN counts as 0. */
template<std::floating_point RealType>
constexpr int32 ToCount(RealType Number, int32 Least, int32 Most)
{
	return std::max(Least, std::min(ToInteger<int32>(Number), Most));
}

} // namespace Drydock
