// The memory that transient resources share. One block for the process, kept from graph to graph so that its pages stay
// mapped; only one builder is alive at a time. Internal to this folder.
#pragma once

#include "CoreMinimal.h"

namespace Drydock
{

/** Reserves at least Bytes bytes, aligned to GRDGHeapAlignment. Contents are what the last graph left. Valid until the
 * next call. */
uint8* ReserveTransientHeap(uint64 Bytes);

/** End of a frame: frees the heap when no graph used it since the last call. */
void TickTransientHeap();

} // namespace Drydock
