// Makes the text that `drydock list extensions` and `drydock list hooks` print.
#pragma once

#include "Budget/RunOptions.h"
#include "DrydockAPI.h"
#include "Text/ListTable.h"

namespace Drydock
{

/** Passes that "passes" of a config can insert: what they read, their parameters with defaults and ranges. Each writes
 * one texture, the picture from then on, or what later passes name. */
DRYDOCK_API FListTable ListPasses();

/** Passes of a config's frame, which --dump, --pass and the like name. */
DRYDOCK_API FListTable ListPasses(const FRunOptions& Options);

/** Types of extensions and of insertable passes: a row for each, followed by one for each of its parameters. */
DRYDOCK_API FListTable ListExtensions();

/** The insertion points that there are, then the hooks, with the engine versions that call them. */
DRYDOCK_API FListTable ListHooks();

/** The chain of a config, compiled and not run: point, what it sees, format, size, the subscribers, and the reason if
 * none is called. Throws FError, as RunConfig does. */
DRYDOCK_API FListTable ListHooks(const FRunOptions& Options);

} // namespace Drydock
