// Small pieces of the texts that verbs print: numbers, lists, and parts of file names.
#pragma once

#include "DrydockAPI.h"

#include <string>

namespace Drydock
{

/** The shortest text that reads back as the number: "0.1", "1e+30". */
DRYDOCK_API std::string NumberText(float Number);
DRYDOCK_API std::string NumberText(double Number);

/** The text with _ for all characters outside [A-Za-z0-9_-]. */
DRYDOCK_API std::string MakeFileNamePart(const std::string& Text);

/** RFC 4648, with padding. */
DRYDOCK_API std::string EncodeBase64(const std::string& Bytes);

/** "DD1015". */
std::string FormatCode(int Code);

/** A cell of a CSV file: quoted where it has to be. */
DRYDOCK_API std::string CsvText(const std::string& Text);

} // namespace Drydock
