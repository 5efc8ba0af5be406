// Console variables as text for people and for machines: pure, from what ListConsoleVariables returns. The wording of
// the help is the engine's console.
#pragma once

#include "HAL/ConsoleVariableTools.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** The widest line of a list. */
constexpr size_t ConsoleListColumns = 100;

/** Those that Filter names, ignoring case: the one of exactly that name; else, with * or ?, those whose whole name
 *  matches; else those whose name contains it. */
DRYDOCK_API std::vector<FConsoleVariableInfo> FilterConsoleVariables(
	const std::vector<FConsoleVariableInfo>& Infos, const std::string& Filter);

/** A line each (name, type, value, default, set by) under a header, the help below it, wrapped. */
DRYDOCK_API std::string FormatConsoleVariables(const std::vector<FConsoleVariableInfo>& Infos, int Width = 0);

/** One variable as the engine's console answers "NAME ?", with its type and default. */
DRYDOCK_API std::string FormatConsoleVariableHelp(const FConsoleVariableInfo& Info, int Width = 0);

/** [{name, type, value, default, setBy, simulated, help}] */
DRYDOCK_API std::string FormatConsoleVariablesAsJson(const std::vector<FConsoleVariableInfo>& Infos);

/** Text in lines of at most Columns characters, each after Indent, the first after FirstIndent where there is one;
 * breaks at blanks, keeps line breaks. A word that is longer stays whole. */
DRYDOCK_API std::string WrapText(const std::string& Text, size_t Columns, const std::string& Indent,
	const std::optional<std::string>& FirstIndent = std::nullopt);

} // namespace Drydock
