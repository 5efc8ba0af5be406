// Everyday calls of plugins, each with its name as docs/calls.md lists it: that it compiles, and that it gives what the
// engine's rule says.
#pragma once

#include <gtest/gtest.h>

#include "Logging/LogMacros.h"

#include <set>
#include <string>

namespace Calls
{

/** The areas of docs/calls.md, each a file of its own. */
enum class EArea
{
	View,
	Family,
	RDG,
	RHI,
	Core,
	Objects,
	Shaders,
};

/** There: right for the world that drydock has. Neutral: does nothing or gives a placeholder, and says so. */
enum class EState
{
	There,
	Neutral,
};

/** For docs/calls.md; a name may come twice. */
void Record(EArea Area, EState State, const char* Name);

inline void Check(EArea Area, EState State, const char* Name, bool bRight, int Line)
{
	Record(Area, State, Name);
	if (!bRight)
	{
		ADD_FAILURE() << Name << " gives another value, line " << Line;
	}
}

/** What the log says while it lives. */
class FLogLines
{
public:
	FLogLines()
	{
		Before = Drydock::SetLogHandler(
			[this](const TCHAR*, ELogVerbosity::Type, const std::string& Text) { Lines += Text + "\n"; });
	}
	~FLogLines() { Drydock::SetLogHandler(Before); }

	bool Has(const char* Text) const { return Lines.find(Text) != std::string::npos; }

private:
	std::string Lines;
	Drydock::FLogHandler Before;
};

} // namespace Calls

/** The name, then a condition that holds. Area is the file's own constant. */
#define CALL(Name, ...) ::Calls::Check(Area, ::Calls::EState::There, Name, bool(__VA_ARGS__), __LINE__)
/** The name, then statements that must compile; they do not run. */
#define COMPILES(Name, ...) \
	do \
	{ \
		::Calls::Record(Area, ::Calls::EState::There, Name); \
		[[maybe_unused]] const auto Statements = [&] \
		{ \
			__VA_ARGS__; \
		}; \
	} while (false)
#define NEUTRAL(Name, ...) ::Calls::Check(Area, ::Calls::EState::Neutral, Name, bool(__VA_ARGS__), __LINE__)
