// Numbers as properties take them, and words for messages.
#include "UObject/PropertyValue.h"

#include <cmath>

namespace Drydock
{

FPropertyValue FPropertyValue::MakeNumber(double Value)
{
	// 2^63: what is below it and whole is an int64.
	constexpr double End = 9223372036854775808.0;
	if (Value == std::floor(Value) && Value >= -End && Value < End)
	{
		return MakeWhole(static_cast<int64>(Value));
	}
	return {.Kind = EKind::Real, .Real = Value};
}

const char* FPropertyValue::Describe() const
{
	constexpr const char* Names[] = {
		"nothing", "true", "a number", "a number", "a text", "a list", "named values", "an object"};
	return Kind == EKind::Bool && !bBool ? "false" : Names[size_t(Kind)];
}

} // namespace Drydock
