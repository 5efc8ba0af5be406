// Keeps the actions in the order in which they were made, under one mutex.
#include "EndAction.h"

#include <map>
#include <mutex>
#include <utility>

namespace Drydock
{

namespace
{

struct FEndActions
{
	std::recursive_mutex Mutex; // recursive: actions are made while they are held
	std::map<int, std::function<void()>> ByNumber;
	int Next = 0;
};

/** Never destroyed: other threads may end the process while this one leaves main. */
FEndActions& GetEndActions()
{
	static FEndActions& Actions = *new FEndActions;
	return Actions;
}

int AddEndAction(std::function<void()> Action)
{
	FEndActions& Actions = GetEndActions();
	const std::lock_guard Lock(Actions.Mutex);
	Actions.ByNumber.emplace(Actions.Next, std::move(Action));
	return Actions.Next++;
}

} // namespace

FEndAction::FEndAction(std::function<void()> Action)
	: Number(AddEndAction(std::move(Action)))
{
}

FEndAction::~FEndAction()
{
	FEndActions& Actions = GetEndActions();
	const std::lock_guard Lock(Actions.Mutex);
	Actions.ByNumber.erase(Number);
}

FEndActionsHeld::FEndActionsHeld()
{
	GetEndActions().Mutex.lock();
}

FEndActionsHeld::~FEndActionsHeld()
{
	GetEndActions().Mutex.unlock();
}

void DoEndActions()
{
	FEndActions& Actions = GetEndActions();
	Actions.Mutex.lock(); // and never unlocked
	for (auto Action = Actions.ByNumber.rbegin(); Action != Actions.ByNumber.rend(); ++Action)
	{
		Action->second();
	}
}

} // namespace Drydock
