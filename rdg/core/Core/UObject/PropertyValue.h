// A property's value without its C++ type, as a config or an ini file gives it.
#pragma once

#include "CoreTypes.h"

#include <string>
#include <utility>
#include <vector>

class UObject;

namespace Drydock
{

struct FPropertyValue
{
	enum class EKind : uint8
	{
		None, // null
		Bool,
		Whole,
		Real,
		Text,
		List,   // Items
		Fields, // Items, each with a name
		Object,
	};

	EKind Kind = EKind::None;
	bool bBool = false;
	int64 Whole = 0;
	double Real = 0.0; // of Whole too
	std::string Text = {};
	std::vector<std::pair<std::string, FPropertyValue>> Items = {};
	UObject* Object = nullptr;

	static FPropertyValue MakeBool(bool bValue) { return {.Kind = EKind::Bool, .bBool = bValue}; }
	static FPropertyValue MakeWhole(int64 Value)
	{
		return {.Kind = EKind::Whole, .Whole = Value, .Real = static_cast<double>(Value)};
	}
	/** Whole where it is, and fits. */
	DRYDOCK_API static FPropertyValue MakeNumber(double Value);
	static FPropertyValue MakeText(std::string Value) { return {.Kind = EKind::Text, .Text = std::move(Value)}; }
	static FPropertyValue MakeList() { return {.Kind = EKind::List}; }
	static FPropertyValue MakeObject(UObject* Value) { return {.Kind = EKind::Object, .Object = Value}; }
	static FPropertyValue MakeFields() { return {.Kind = EKind::Fields}; }

	bool IsNumber() const { return Kind == EKind::Whole || Kind == EKind::Real; }
	/** "a number", "a list", ... for messages. */
	DRYDOCK_API const char* Describe() const;

	bool operator==(const FPropertyValue&) const = default;
};

} // namespace Drydock
