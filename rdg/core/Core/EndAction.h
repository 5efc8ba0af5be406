// Registers what a process does when a signal tells it to end: it removes its temporary files and stops its children.
#pragma once

#include "DrydockAPI.h"
#include "Templates/UnrealTemplate.h"

#include <functional>

namespace Drydock
{

/** While it lives, the action is among those of DoEndActions. From any thread. */
class DRYDOCK_API FEndAction : private FNoncopyable
{
public:
	/** Action: called from another thread than the one that made it; throws nothing. */
	explicit FEndAction(std::function<void()> Action);
	~FEndAction();

private:
	const int Number;
};

/** While it lives, DoEndActions waits: for a few steps that belong together. */
class DRYDOCK_API FEndActionsHeld : private FNoncopyable
{
public:
	FEndActionsHeld();
	~FEndActionsHeld();
};

/** Calls the actions, the latest first. Whoever makes or ends one from now on waits for ever: the caller ends the
 * process. */
DRYDOCK_API void DoEndActions();

} // namespace Drydock
