// Finds the width of the terminal that a text goes to, and fits lines of prose to it.
#pragma once

#include "DrydockAPI.h"

#include <cstddef>
#include <string>

namespace Drydock
{

/** Columns of the terminal that FileDescriptor is: COLUMNS where that is a whole number from 1 on, else the terminal's
 * own number, else 80; never less than 40. 0 if it is not a terminal: a file or a pipe has lines of any length. */
DRYDOCK_API int GetTerminalWidth(int FileDescriptor);

/** Columns that the text takes: characters of UTF-8, without the escape sequences of colours. */
DRYDOCK_API size_t CountColumns(const std::string& Text);

/** Breaks lines that are longer than Width at blanks; what follows stands under the text of the line, behind its label
 * ("memory   2 MB ..."). Words that are longer than a line are cut. Width 0: the text as it is. */
DRYDOCK_API std::string FitLines(const std::string& Text, int Width);

} // namespace Drydock
