// Asks the system for pages of 2 MB under large memory, where passes would otherwise find each row of a picture on
// pages of its own.
#pragma once

#include "CoreMinimal.h"

namespace Drydock
{

/** Of these bytes what lies on whole pages of 2 MB and is not touched yet. A wish: where the system has none, or is
 * told never to give any, nothing changes. */
DRYDOCK_API void AskForHugePages(void* Memory, size_t Bytes);

} // namespace Drydock
