// TNumericLimits over std::numeric_limits. Lowest is the most negative value; Min of a floating type is the smallest
// positive one. Source: engine Math/NumericLimits.h.
#pragma once

#include "CoreTypes.h"

#include <limits>

template<typename T>
struct TNumericLimits
{
	static constexpr T Min() { return std::numeric_limits<T>::min(); }
	static constexpr T Max() { return std::numeric_limits<T>::max(); }
	static constexpr T Lowest() { return std::numeric_limits<T>::lowest(); }
};
