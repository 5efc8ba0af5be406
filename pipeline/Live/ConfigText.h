// Edits single places of a config's text, and leaves all else as a person wrote it: comments, order, line breaks.
#pragma once

#include "Text/Json.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** One edit: a place by its JSON pointer (RFC 6901), and its new value. */
struct FConfigEdit
{
	std::string Pointer;
	std::optional<std::string> Value; // JSON; nothing: the place is removed
};

/** Reads [{"set": POINTER, "value": ...}, {"remove": POINTER}, ...]. Throws FError (DD1120) for all else. */
DRYDOCK_API std::vector<FConfigEdit> ReadEdits(const FJsonValue& Edits);

/** The same as JSON, an object on one line. */
DRYDOCK_API std::string WriteEdit(const FConfigEdit& Edit);

/** JSON on one line: numbers in the shortest form. */
DRYDOCK_API std::string WriteJson(const FJsonValue& Value);

/** The text with these edits, in their order. Objects that are missing on the way are made, and elements are added at
 * the end of arrays ("-", or their size). Text: JSON with comments that was parsed without a fault. Throws FError
 * (DD1120): a place that cannot be, or one to remove that is not there. */
DRYDOCK_API std::string ApplyEdits(const std::string& Text, const std::vector<FConfigEdit>& Edits);

/** The edits that make the values of After from those of Before, member by member; an array whose size differs
 * changes as a whole. Both: JSON as above. */
DRYDOCK_API std::vector<FConfigEdit> FindChanges(const std::string& Before, const std::string& After);

/** The value at a place of the text, as it stands there; nothing where there is none. */
DRYDOCK_API std::optional<std::string> FindPlace(const std::string& Text, const std::string& Pointer);

/** The pointer's steps, without their escapes. */
DRYDOCK_API std::vector<std::string> SplitPointer(const std::string& Pointer);

} // namespace Drydock
