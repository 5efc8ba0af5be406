// Records whose code runs on a thread: drydock's own, or a plugin's, with the hook and the pass that called it. All
// calls into a plugin go through CallCode, so that whatever ends badly there (an exception, a crash, exit, silence) is
// told in one message with these words, and blamed on the right one.
#pragma once

#include "Diagnostics.h"
#include "RunningCode.h"
#include "Templates/UnrealTemplate.h"

#include <memory>
#include <utility>

namespace Drydock
{

class FWatchdog;

/** Says for its scope whose code runs on this thread. Owner must outlive it. A plugin's that neither returns nor calls
 * anything with a scope of its own for r.Drydock.PluginSeconds ends the program (DD2089, exit code 71). */
class DRYDOCK_API FCodeScope : private FNoncopyable
{
public:
	explicit FCodeScope(const FCodeOwner& Owner);
	~FCodeScope();

private:
	const FCodeOwner* OwnerBefore;
	FWatchdog* WatchBefore;
	std::unique_ptr<FWatchdog> Watch; // null: drydock's own code
};

/** A message of the graph with the words of the plugin whose code runs, unless it has them; others as they are. */
DRYDOCK_API FDiagnostic AddRunningWords(const FDiagnostic& Diagnostic);

/** Inside a handler of `...`: throws on what a plugin's code let out. Messages of the graph (FError) get the owner's
 * words; a failed check of drydock is DD2088, exit code 2; anything else DD2087, exit code 71. */
[[noreturn]] DRYDOCK_API void RethrowOf(const FCodeOwner& Owner);

/** The door: calls Function as Owner's code. Exceptions of a plugin come out as FError. */
template<typename TFunction>
decltype(auto) CallCode(const FCodeOwner& Owner, TFunction&& Function)
{
	const FCodeScope Scope(Owner);
	try
	{
		return std::forward<TFunction>(Function)();
	}
	catch (...)
	{
		RethrowOf(Owner);
	}
}

} // namespace Drydock
