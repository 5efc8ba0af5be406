// Writes log lines to where they go.
#include "Logging/LogMacros.h"

#include "PrintText.h"

#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <mutex>
#include <utility>

FLogCategoryBase LogTemp{"LogTemp", ELogVerbosity::All};
FLogCategoryBase LogCore{"LogCore", ELogVerbosity::All};
FLogCategoryBase LogConsoleManager{"LogConsoleManager", ELogVerbosity::All};
FLogCategoryBase LogRenderer{"LogRenderer", ELogVerbosity::All};
FLogCategoryBase LogRDG{"LogRDG", ELogVerbosity::All};
FLogCategoryBase LogRHI{"LogRHI", ELogVerbosity::All};
FLogCategoryBase LogShaders{"LogShaders", ELogVerbosity::All};

namespace Drydock
{

namespace
{

std::atomic<ELogVerbosity::Type> GLogVerbosity{ELogVerbosity::Log};

struct FLogState
{
	std::mutex Mutex;
	FLogHandler Handler;
};

FLogState& GetLogState()
{
	static FLogState State;
	return State;
}

const char* GetPrefix(ELogVerbosity::Type Level)
{
	constexpr const char* Prefixes[] = {
		"", "Fatal: ", "Error: ", "Warning: ", "Display: ", "", "Verbose: ", "VeryVerbose: "};
	return Level <= ELogVerbosity::VeryVerbose ? Prefixes[Level] : "";
}

} // namespace

void LogMessage(const FLogCategoryBase& Category, ELogVerbosity::Type Level, const TCHAR* Format, ...)
{
	const bool bFatal = Level == ELogVerbosity::Fatal;
	if (!bFatal && (Category.IsSuppressed(Level) || Level > GLogVerbosity))
	{
		return;
	}
	va_list Arguments;
	va_start(Arguments, Format);
	va_list Copy;
	va_copy(Copy, Arguments);
	const int Length = std::vsnprintf(nullptr, 0, Format, Copy);
	va_end(Copy);
	std::string Text(Length > 0 ? Length + 1 : 1, '\0');
	std::vsnprintf(Text.data(), Text.size(), Format, Arguments);
	va_end(Arguments);
	Text.pop_back();
	if (bFatal)
	{
		FailCheck(Category.GetCategoryName(), __FILE__, __LINE__, "Fatal error: %s", Text.c_str());
	}
	FLogState& State = GetLogState();
	std::lock_guard Lock(State.Mutex);
	if (State.Handler)
	{
		State.Handler(Category.GetCategoryName(), Level, Text);
	}
	else
	{
		PrintText(stderr, std::string(Category.GetCategoryName()) + ": " + GetPrefix(Level) + Text + "\n");
	}
}

void SetLogVerbosity(ELogVerbosity::Type Level)
{
	GLogVerbosity = Level;
}

ELogVerbosity::Type GetLogVerbosity()
{
	return GLogVerbosity;
}

FLogHandler SetLogHandler(FLogHandler Handler)
{
	FLogState& State = GetLogState();
	std::lock_guard Lock(State.Mutex);
	return std::exchange(State.Handler, std::move(Handler));
}

} // namespace Drydock
