// The names that a plugin uses and drydock does not have, gathered from the messages of g++, clang and the linker.
// Pure: messages in, data and text out.
#pragma once

#include "DrydockAPI.h"
#include "Patch/BuildLog.h"

#include <string>
#include <vector>

namespace Drydock
{

/** A name that lacks, once for all sources. */
struct FMissingName
{
	std::string Name;    // "FApp", "FSceneView::FieldOfView", "Misc/App.h"
	std::string Kind;    // "name", "type", "member", "header", "base class", "override", "arguments", "definition"
	int Count = 0;       // places that use it
	std::string Place;   // the first one: "Source/Tint/Tint.cpp:12"
	std::string Instead; // the nearest name by the compiler, or the header that is taken as empty; empty: unknown
};

/** The missing names in the order of their first places, base classes (NameMissingBases) before others. OutOthers
 * receives the errors about other things. Notes: lines of drydock_add_plugin, some of which name headers that are taken
 * as empty. */
DRYDOCK_API std::vector<FMissingName> FindMissingNames(const std::vector<FCompilerMessage>& Errors,
	const std::vector<std::string>& Notes, std::vector<FCompilerMessage>& OutOthers);

/** The names as a table, a line each below a header. The middle of a name of more than 48 characters is left out.
 * Indent: before each line. */
DRYDOCK_API std::string FormatMissingNames(const std::vector<FMissingName>& Names, const std::string& Indent);

} // namespace Drydock
