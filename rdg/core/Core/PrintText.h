// Prints all text to stdout and stderr, so that text from strangers cannot control a terminal.
#pragma once

#include "DrydockAPI.h"

#include <cstdio>
#include <string>

namespace Drydock
{

/** The text in whole characters of UTF-8. A control character (C0 but tab and line break, DEL, C1, those that turn the
 * direction of writing) becomes its number as JSON writes it, "\u001b"; a byte that belongs to no character becomes
 * U+FFFD. Without bLines a tab and a line break are control characters too. */
DRYDOCK_API std::string MakePrintable(const std::string& Text, bool bLines = true);

/** Writes the printable text. Bold, dim and plain, which tables have, stay as they are; cells are made printable
 * before. */
DRYDOCK_API void PrintText(FILE* Stream, const std::string& Text);

} // namespace Drydock
