// UE_LOGFMT: a log line whose {fields} are filled by values, in order or by name. Source: engine
// Logging/StructuredLog.h.
#pragma once

#include "Containers/UnrealString.h"
#include "Internationalization/Text.h"
#include "Logging/LogMacros.h"

#include <initializer_list>

namespace Drydock
{

/** A value of a log line, as text; Name is null for one that is known by its place. */
struct FLogField
{
	const TCHAR* Name = nullptr;
	FString Value;

	template<typename T>
	explicit FLogField(const T& InValue)
	{
		if constexpr (std::is_same_v<T, bool>)
		{
			Value = InValue ? "true" : "false";
		}
		else if constexpr (std::is_arithmetic_v<T>)
		{
			Value = FText::AsNumber(static_cast<double>(InValue)).ToString();
		}
		else if constexpr (std::is_convertible_v<T, FString>)
		{
			Value = InValue;
		}
		else
		{
			Value = InValue.ToString();
		}
	}
	template<typename T>
	FLogField(const TCHAR* InName, const T& InValue)
		: FLogField(InValue)
	{
		Name = InName;
	}
};

/** Writes Format with its {Name} replaced: by the field of that name, else by the next one without a name. "{{" and
 * "}}" are braces; a field that nothing fills stays as it is. */
DRYDOCK_API void LogFormatted(const FLogCategoryBase& Category, ELogVerbosity::Type Level, const TCHAR* Format,
	std::initializer_list<FLogField> Fields);

} // namespace Drydock

// Each argument is a value, or ("Name", Value): DRYDOCK_LOG_FIELD takes away the parentheses of the second form.
#define DRYDOCK_LOG_EXPAND(...) \
	DRYDOCK_LOG_EXPAND_2(DRYDOCK_LOG_EXPAND_2(DRYDOCK_LOG_EXPAND_2(DRYDOCK_LOG_EXPAND_2(__VA_ARGS__))))
#define DRYDOCK_LOG_EXPAND_2(...) \
	DRYDOCK_LOG_EXPAND_1(DRYDOCK_LOG_EXPAND_1(DRYDOCK_LOG_EXPAND_1(DRYDOCK_LOG_EXPAND_1(__VA_ARGS__))))
#define DRYDOCK_LOG_EXPAND_1(...) __VA_ARGS__
#define DRYDOCK_LOG_IS_PAIR(...) ~, DRYDOCK_LOG_STRIP
#define DRYDOCK_LOG_BARE(...) __VA_ARGS__
#define DRYDOCK_LOG_AS_IT_IS(...) __VA_ARGS__
#define DRYDOCK_LOG_SECOND(First, Second, ...) Second
#define DRYDOCK_LOG_CHOOSE(...) DRYDOCK_LOG_SECOND(__VA_ARGS__, DRYDOCK_LOG_AS_IT_IS, )
#define DRYDOCK_LOG_STRIP(Pair) DRYDOCK_LOG_BARE Pair
#define DRYDOCK_LOG_FIELD(Argument) ::Drydock::FLogField(DRYDOCK_LOG_CHOOSE(DRYDOCK_LOG_IS_PAIR Argument)(Argument))
#define DRYDOCK_LOG_FIELDS(First, ...) \
	DRYDOCK_LOG_FIELD(First), __VA_OPT__(DRYDOCK_LOG_FIELDS_AGAIN DRYDOCK_LOG_PARENTHESES(__VA_ARGS__))
#define DRYDOCK_LOG_PARENTHESES ()
#define DRYDOCK_LOG_FIELDS_AGAIN() DRYDOCK_LOG_FIELDS

#define UE_LOGFMT(Category, Verbosity, Format, ...) \
	::Drydock::LogFormatted(Category, ELogVerbosity::Verbosity, TEXT(Format), \
		{__VA_OPT__(DRYDOCK_LOG_EXPAND(DRYDOCK_LOG_FIELDS(__VA_ARGS__)))})
