// Serves drydock's command line, configs and tests beyond the engine's interface of console variables: lists them, sets
// them from text with a check of the type, restores them all. Source of the wording of DescribeRefusedSet and
// DescribeConsoleVariable: the engine.
#pragma once

#include "HAL/IConsoleManager.h"

namespace Drydock
{

struct FConsoleVariableInfo
{
	FString Name; // as registered
	FString Type; // "bool", "int32", "float" or "FString"
	FString Value;
	FString Default;
	FString SetBy; // "Constructor", "Commandline", ...
	FString Help;
	bool bNotSimulated; // ECVF_NotSimulated
};

/** All variables whose name starts with Prefix, ignoring case, in alphabetical order. */
DRYDOCK_API TArray<FConsoleVariableInfo> ListConsoleVariables(const TCHAR* Prefix = TEXT(""));

/** Sets a variable if Text reads as its type: bool takes true/false/on/off/yes/no/1/0, int32 a whole number, float any
 *  number, FString anything. False, with one sentence that names what was expected, if there is no such variable or
 * Text does not fit. A set that loses to a higher priority is not an error: it warns. */
DRYDOCK_API bool TrySetConsoleVariable(
	const TCHAR* Name, const TCHAR* Text, EConsoleVariableFlags SetBy, FString& OutError);

/** Whether Text reads as the variable's type, as TrySetConsoleVariable has it. */
DRYDOCK_API bool DoesConsoleVariableTake(const IConsoleVariable& Variable, const TCHAR* Text);

/** The warning that a set by that setter would give, or nothing: the last setter has a higher priority. */
DRYDOCK_API FString DescribeRefusedSet(
	const TCHAR* Name, const IConsoleVariable& Variable, EConsoleVariableFlags SetBy);

/** `r.BloomQuality = "5"      LastSetBy: Constructor`: what a console prints for a bare name. */
DRYDOCK_API FString DescribeConsoleVariable(const TCHAR* Name, const IConsoleVariable& Variable);

/** "Name Value", "Name=Value" or "Name" to its parts, without the blanks around them and the quotes around the value.
 */
DRYDOCK_API void SplitConsoleInput(const TCHAR* Input, FString& OutName, FString& OutValue);

/** Resets every variable to its default, as if none had ever been set. */
DRYDOCK_API void ResetConsoleVariables();

/** "Constructor", "Scalability", ... "Console" for the priority in Flags. */
DRYDOCK_API const TCHAR* GetConsoleVariableSetByName(EConsoleVariableFlags Flags);

/** "bool", "int32", "float" or "FString". */
DRYDOCK_API const TCHAR* GetConsoleVariableTypeName(const IConsoleVariable& Variable);

/** Puts back, when it ends, the values and setters that all variables had when it began. */
class DRYDOCK_API FConsoleVariableSnapshot : private FNoncopyable
{
public:
	FConsoleVariableSnapshot();
	~FConsoleVariableSnapshot();

private:
	struct FValue
	{
		FString Name;
		FString Value;
		EConsoleVariableFlags SetBy;
	};
	TArray<FValue> Values;
};

/** Sets a variable for the length of a scope and puts back the value and the priority it had. For tests. */
class DRYDOCK_API FScopedConsoleVariable : private FNoncopyable
{
public:
	/** The variable must exist. */
	FScopedConsoleVariable(const TCHAR* Name, const FString& Value);
	FScopedConsoleVariable(const TCHAR* Name, int32 Value)
		: FScopedConsoleVariable(Name, FString::FromInt(Value))
	{
	}
	FScopedConsoleVariable(const TCHAR* Name, float Value)
		: FScopedConsoleVariable(Name, FString::SanitizeFloat(static_cast<double>(Value)))
	{
	}
	~FScopedConsoleVariable();

private:
	IConsoleVariable* Variable;
	FString OldValue;
	EConsoleVariableFlags OldSetBy;
};

} // namespace Drydock
