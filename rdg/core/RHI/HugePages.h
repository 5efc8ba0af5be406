// Asks the system for pages of 2 MB under large memory, where passes would otherwise find each row of a picture on
// pages of its own.
#pragma once

#include "CoreMinimal.h"

namespace Drydock
{

/** Asks for huge pages for those of these bytes that fill whole pages of 2 MB and are not touched yet. This is only a
 * wish: nothing changes if the system has no huge pages, or is set never to give any. */
DRYDOCK_API void AskForHugePages(void* Memory, size_t Bytes);

} // namespace Drydock
