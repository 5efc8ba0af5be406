// The page that a person opens: data put into the template that report/ makes.
#pragma once

#include "DrydockAPI.h"

#include <ctime>
#include <string>

namespace Drydock
{

/** JSON that may stand in a script element: no "<" is left in it, so that nothing closes the element or opens a
 * comment. It says the same. */
DRYDOCK_API std::string EscapeForScript(const std::string& Json);

/** UTC, "2025-01-31T12:00:00Z". */
DRYDOCK_API std::string FormatReportTime(std::time_t Time);

/** The whole of report.html. Data: JSON by report/report.schema.json. Throws FError (exit code 3) where drydock's own
 * template is missing or damaged. */
DRYDOCK_API std::string MakeReportPage(const std::string& Data);

} // namespace Drydock
