// Small pieces of the texts that verbs print: numbers by a printf pattern, and columns. Source: drydock.
#pragma once

#include "DrydockAPI.h"

#include <cstddef>
#include <string>

namespace Drydock
{

/** Pattern: of printf, for one double; up to 63 characters come out. */
DRYDOCK_API std::string Format(const char* Pattern, double Number);

/** The shortest text that reads back as the number: "0.1", "1e+30". */
DRYDOCK_API std::string NumberText(float Number);
DRYDOCK_API std::string NumberText(double Number);

/** Width: in bytes; a longer text stays as it is. */
DRYDOCK_API std::string PadRight(const std::string& Text, size_t Width);
DRYDOCK_API std::string PadLeft(const std::string& Text, size_t Width);

} // namespace Drydock
