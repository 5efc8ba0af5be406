// Reads just enough of C++ to find definitions, blocks and values in a file of the engine: comments, brackets, names.
#pragma once

#include "DrydockAPI.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace Drydock
{

/** The text with spaces in place of comments and of what stands between quotes; line breaks stay, and so does every
 * place. */
DRYDOCK_API std::string BlankComments(std::string_view Text);

/** The places of Name as a whole word, in a text of BlankComments. */
DRYDOCK_API std::vector<size_t> FindWord(std::string_view Text, std::string_view Name);

/** The place after the bracket that closes the one at Open, "(", "{" or "[". Nothing where none does. */
DRYDOCK_API std::optional<size_t> FindClosing(std::string_view Text, size_t Open);

/** The place of the name where the text defines such a function, with or without a scope before it; nothing: it does
 * not. */
DRYDOCK_API std::optional<size_t> FindDefinition(std::string_view Text, std::string_view Name);

/** The number of the line that a place is in, from 1 on. */
DRYDOCK_API int GetLineOf(std::string_view Text, size_t Place);

/** The first place from At on that holds no blank. */
DRYDOCK_API size_t SkipBlanks(std::string_view Text, size_t At);

} // namespace Drydock
