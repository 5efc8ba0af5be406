// Checks any ini file: it gives sections with values that properties take or refuse, and warnings with their lines. The
// fuzzer uses this, and a test that runs its corpus.
#pragma once

#include "FuzzChecks.h"
#include "Objects/IniText.h"
#include "Objects/PropertyText.h"
#include "UObject/ReflectionMake.h"

#include <algorithm>
#include <string>
#include <vector>

namespace Drydock
{

/** A property refuses the values with a reason, or takes them and has a value that it would take again. */
template<typename T>
std::string CheckProperty(const std::vector<FIniValue>& Values)
{
	const FPropertyType& Type = GetPropertyType<T>();
	const std::optional<FPropertyValue> Value = ReadPropertyText(Type, Values);
	T Property{};
	FPropertyProblem Problem;
	if (!Value)
	{
		return "";
	}
	if (!WriteProperty(Type, &Property, *Value, Problem))
	{
		return Problem.Message.empty() ? "a property refuses a value without a reason" : "";
	}
	T Again{};
	return WriteProperty(Type, &Again, ReadProperty(Type, &Property), Problem)
			   ? ""
			   : "a property refuses the value that it has: " + Problem.Message;
}

inline std::string CheckProperties(const std::vector<FIniValue>& Values)
{
	for (const auto Check : {CheckProperty<bool>, CheckProperty<uint8>, CheckProperty<int32>, CheckProperty<int64>,
			 CheckProperty<float>, CheckProperty<double>, CheckProperty<FString>, CheckProperty<FName>,
			 CheckProperty<FVector>, CheckProperty<FLinearColor>, CheckProperty<FColor>, CheckProperty<FIntPoint>,
			 CheckProperty<FRotator>, CheckProperty<TArray<int32>>, CheckProperty<TArray<float>>,
			 CheckProperty<TArray<FString>>, CheckProperty<TArray<FVector>>})
	{
		if (const std::string Problem = Check(Values); !Problem.empty())
		{
			return Problem;
		}
	}
	return "";
}

inline std::string CheckIniText(const std::string& Text)
{
	std::vector<FDiagnostic> Diagnostics;
	const std::vector<FIniSection> Sections = ReadIniText(Text, "DefaultGame.ini", Diagnostics);
	if (const std::string Problem = CheckMessages(Text, Diagnostics); !Problem.empty())
	{
		return Problem;
	}
	const auto NumLines = 1 + std::count(Text.begin(), Text.end(), '\n');
	for (const FIniSection& Section : Sections)
	{
		for (const FIniKey& Key : Section.Keys)
		{
			if (Section.Name.empty() || Key.Name.empty())
			{
				return "a section or a key has no name";
			}
			for (const FIniValue& Value : Key.Values)
			{
				if (Value.Line < 1 || Value.Line > NumLines)
				{
					return "a value of " + Key.Name + " stands on no line";
				}
			}
			if (const std::string Problem = CheckProperties(Key.Values); !Problem.empty())
			{
				return Key.Name + ": " + Problem;
			}
		}
	}
	return "";
}

} // namespace Drydock
