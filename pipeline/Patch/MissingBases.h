// The base classes that a plugin names and drydock does not have, and the errors that follow from them. Pure: messages
// and a reader of files in, messages out.
#pragma once

#include "DrydockAPI.h"
#include "Patch/BuildLog.h"

#include <functional>
#include <string>
#include <vector>

namespace Drydock
{

/** Lines of a file as a message names it; none: it cannot be read. */
using FLineReader = std::function<std::vector<std::string>(const std::string& File)>;

/** Gives each error about an unknown base class the sentence "no base class 'NAME'", which g++ does not write: the name
 * is read where the class is declared. Moves to OutFollowing the errors that such a class causes: a member of the base
 * that its functions use, a function that overrides nothing, the code made from its header. A name of a type of the
 * engine's is not moved, for it may lack by itself. */
DRYDOCK_API void NameMissingBases(
	std::vector<FCompilerMessage>& Errors, const FLineReader& ReadLines, std::vector<FCompilerMessage>& OutFollowing);

} // namespace Drydock
