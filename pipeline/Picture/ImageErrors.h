// Errors about image files: one line, exit code 3.
#pragma once

#include "DiagnosticList.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <string>

namespace Drydock
{

/** The libraries' messages may run over several lines and end in blanks. */
inline FError MakeImageError(EConfigError Code, const std::string& Path, std::string Message)
{
	std::replace(Message.begin(), Message.end(), '\n', ' ');
	Message.erase(Message.find_last_not_of(" \t\r") + 1);
	return FError({.Code = Code, .Message = Message, .File = Path}, ExitFiles);
}

} // namespace Drydock
