// The page that a person opens: data put into the template that report/ makes.
#pragma once

#include "DrydockAPI.h"

#include <cstddef>
#include <ctime>
#include <string>

namespace Drydock
{

/** A page that report/ makes, "page.html", installed or in the source tree. */
std::string FindPageFile(const std::string& Name);

/** JSON that may stand in a script element: no "<" is left in it, so that nothing closes the element or opens a
 * comment. The data are the same. */
DRYDOCK_API std::string EscapeForScript(const std::string& Json);

/** UTC, "2025-01-31T12:00:00Z". */
DRYDOCK_API std::string FormatReportTime(std::time_t Time);

/** The limit of uncompressed data: 4 MB. */
constexpr size_t MaxPlainDataBytes = 4'000'000;

/** The whole of report.html. Data: JSON by report/report.schema.json; larger ones go in as a string, zlib's stream of
 * them in base64, where that halves them. Absolute paths in it are shortened (MakePathsPortable). Throws FError (exit
 * code 3) where drydock's own template is missing or damaged. */
DRYDOCK_API std::string MakeReportPage(const std::string& Data, size_t MaxPlainBytes = MaxPlainDataBytes);

} // namespace Drydock
