// Checks the name of a patch, which its files, its module, its C++ classes and its CMake target all bear.
#pragma once

#include "DrydockAPI.h"

#include <set>
#include <string>

namespace Drydock
{

/** Names that code of a patch cannot take: types, macros and file names of the headers that drydock has under the
 * engine's names, shader classes, C++ keywords. */
DRYDOCK_API std::set<std::string> FindTakenNames();

/** Names that a C++ text declares at the start of a line: classes, enums, aliases, parameter structs, macros. */
DRYDOCK_API std::set<std::string> FindDeclaredNames(const std::string& Text);

/** Why Name cannot be a patch's, as the end of the sentence "NAME cannot be a patch's name: "; empty when it can be. */
DRYDOCK_API std::string ExplainBadPatchName(const std::string& Name, const std::set<std::string>& Taken);

/** A name near it that could be one: "My-Patch" gives "MyPatch", "FTonemap" gives "MyTonemap"; empty when there is
 * none. */
DRYDOCK_API std::string SuggestPatchName(const std::string& Name, const std::set<std::string>& Taken);

} // namespace Drydock
