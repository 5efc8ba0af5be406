// Lists the levels of importance of a log line. Source: engine Logging/LogVerbosity.h.
#pragma once

#include "CoreTypes.h"

namespace ELogVerbosity
{
enum Type : uint8
{
	NoLogging,
	Fatal, // a failed check
	Error,
	Warning,
	Display,
	Log,
	Verbose,
	VeryVerbose,
	All = VeryVerbose,
};
} // namespace ELogVerbosity
