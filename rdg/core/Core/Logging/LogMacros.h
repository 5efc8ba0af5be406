// UE_LOG and its categories. Lines go to stderr as "LogTemp: Warning: text", down to the verbosity that is set for all
// (Log at first) and that of the category. Source: engine Logging/LogMacros.h.
#pragma once

#include "Logging/LogVerbosity.h"
#include "Misc/AssertionMacros.h"

#include <functional>
#include <string>

/** A named source of log lines. */
class FLogCategoryBase
{
public:
	constexpr FLogCategoryBase(const TCHAR* InName, ELogVerbosity::Type InVerbosity)
		: Name(InName)
		, Verbosity(InVerbosity)
	{
	}

	const TCHAR* GetCategoryName() const { return Name; }
	ELogVerbosity::Type GetVerbosity() const { return Verbosity; }
	void SetVerbosity(ELogVerbosity::Type InVerbosity) { Verbosity = InVerbosity; }
	bool IsSuppressed(ELogVerbosity::Type Level) const { return Level > Verbosity; }

private:
	const TCHAR* Name;
	ELogVerbosity::Type Verbosity;
};

namespace Drydock
{

/** Writes one line unless its verbosity is suppressed; Fatal is a failed check. Thread-safe. */
DRYDOCK_API void LogMessage(const FLogCategoryBase& Category, ELogVerbosity::Type Level, const TCHAR* Format, ...)
	__attribute__((format(printf, 3, 4)));

/** The most verbose level that is still written, for all categories. */
DRYDOCK_API void SetLogVerbosity(ELogVerbosity::Type Level);
DRYDOCK_API ELogVerbosity::Type GetLogVerbosity();

/** A handler receives what would be written (without category and level) in place of stderr; null restores that.
 *  Returns the handler before. */
using FLogHandler = std::function<void(const TCHAR* Category, ELogVerbosity::Type Level, const std::string& Text)>;
DRYDOCK_API FLogHandler SetLogHandler(FLogHandler Handler);

} // namespace Drydock

#define DECLARE_LOG_CATEGORY_EXTERN(Category, DefaultVerbosity, CompileTimeVerbosity) \
	extern struct FLogCategory##Category : public FLogCategoryBase \
	{ \
		FLogCategory##Category() \
			: FLogCategoryBase(#Category, ELogVerbosity::DefaultVerbosity) \
		{ \
		} \
	} Category;
#define DEFINE_LOG_CATEGORY(Category) FLogCategory##Category Category;
#define DEFINE_LOG_CATEGORY_STATIC(Category, DefaultVerbosity, CompileTimeVerbosity) \
	static struct FLogCategory##Category : public FLogCategoryBase \
	{ \
		FLogCategory##Category() \
			: FLogCategoryBase(#Category, ELogVerbosity::DefaultVerbosity) \
		{ \
		} \
	} Category;
#define DECLARE_LOG_CATEGORY_CLASS(Category, DefaultVerbosity, CompileTimeVerbosity) \
	static inline FLogCategoryBase Category{#Category, ELogVerbosity::DefaultVerbosity};

// A block, as in the engine: published code leaves the semicolon out.
#define UE_LOG(Category, Verbosity, Format, ...) \
	{ \
		::Drydock::LogMessage(Category, ELogVerbosity::Verbosity, Format __VA_OPT__(, ) __VA_ARGS__); \
	}
#define UE_CLOG(Condition, Category, Verbosity, Format, ...) \
	do \
	{ \
		if (Condition) \
		{ \
			UE_LOG(Category, Verbosity, Format __VA_OPT__(, ) __VA_ARGS__); \
		} \
	} while (0)
#define UE_LOG_ACTIVE(Category, Level) \
	(!(Category).IsSuppressed(ELogVerbosity::Level) && ELogVerbosity::Level <= ::Drydock::GetLogVerbosity())

extern DRYDOCK_API FLogCategoryBase LogTemp;
extern DRYDOCK_API FLogCategoryBase LogCore;
extern DRYDOCK_API FLogCategoryBase LogConsoleManager;
extern DRYDOCK_API FLogCategoryBase LogRenderer;
extern DRYDOCK_API FLogCategoryBase LogRDG;
extern DRYDOCK_API FLogCategoryBase LogRHI;
extern DRYDOCK_API FLogCategoryBase LogShaders;
