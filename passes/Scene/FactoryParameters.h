// Holds the parameters that a config gives to an extension or a pass: those that exist (specs), and those given
// (values). Plain data; pipeline/ reads them from JSON and checks them against the specs.
#pragma once

#include "CoreMinimal.h"

#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace Drydock
{

/** A number (integers too), a truth, a text or a colour. */
using FParameterValue = std::variant<double, bool, std::string, FLinearColor>;

enum class EParameterKind
{
	Number,
	Integer,
	Bool,
	Text,
	Color, // [r, g, b], [r, g, b, a] or {R, G, B, A}; linear
};

/** One parameter: its name in the config, type, default, range and what it does. */
struct FParameterSpec
{
	std::string Name;
	EParameterKind Kind = EParameterKind::Number;
	FParameterValue Default;
	double Min = -std::numeric_limits<double>::infinity(); // of numbers and integers; outside is an error
	double Max = std::numeric_limits<double>::infinity();
	std::vector<std::string> Choices; // of a text; empty: any
	std::string Doc;

	static DRYDOCK_API FParameterSpec Number(std::string Name, double Default, double Min, double Max, std::string Doc);
	static DRYDOCK_API FParameterSpec Integer(std::string Name, int32 Default, int32 Min, int32 Max, std::string Doc);
	static DRYDOCK_API FParameterSpec Bool(std::string Name, bool bDefault, std::string Doc);
	static DRYDOCK_API FParameterSpec Text(
		std::string Name, std::string Default, std::vector<std::string> Choices, std::string Doc);
	static DRYDOCK_API FParameterSpec Color(std::string Name, const FLinearColor& Default, std::string Doc);
};

/** Values by name. Asking for a name or type that the specs do not have is a failed check. */
class DRYDOCK_API FParameterValues
{
public:
	FParameterValues() = default;
	/** Every parameter at its default. */
	explicit FParameterValues(const std::vector<FParameterSpec>& Specs);

	void Set(const std::string& Name, FParameterValue Value) { Values[Name] = std::move(Value); }

	double GetNumber(const std::string& Name) const;
	float GetFloat(const std::string& Name) const; // a number
	int32 GetInteger(const std::string& Name) const;
	bool GetBool(const std::string& Name) const;
	const std::string& GetText(const std::string& Name) const;
	FLinearColor GetColor(const std::string& Name) const;

	bool operator==(const FParameterValues&) const = default;

private:
	template<typename T>
	const T& Get(const std::string& Name) const;

	std::map<std::string, FParameterValue> Values;
};

/** "number", "integer", "bool", "text", "color". */
DRYDOCK_API const char* ToString(EParameterKind Kind);

/** A value as a config would write it. */
DRYDOCK_API std::string ToText(const FParameterValue& Value);

/** "0 .. 8", ">= 0", "A|B", or nothing. */
DRYDOCK_API std::string GetRangeText(const FParameterSpec& Spec);

} // namespace Drydock
