// Numbers the messages about limits of input and of output. docs/errors.md explains each one.
#pragma once

#include "DiagnosticList.h"

namespace Drydock
{

enum ELimitError
{
	ErrorTooManyValues = 1024, // JSON of more values than any config has
	MoreMessages = 1025,       // how many more of a kind there are than are listed
	ErrorTextTooLarge = 5007,  // a text of more than MaxTextBytes
	ErrorOutOfMemory = 5008,   // out of memory
};

static_assert(MoreMessages == MoreDiagnosticsCode);

} // namespace Drydock
