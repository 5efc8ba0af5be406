// Keeps the actions in the order in which they were made, under one mutex.
#include "EndAction.h"

#include <chrono>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

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

/** Other threads may still be writing into the folder: under another name they do not find it. Who has it open does, so
 * it is tried again for a moment. */
void RemoveWhileWritten(const Files::path& Path)
{
	std::error_code Error;
	Files::path Renamed = Path;
	Renamed += ".going";
	Files::rename(Path, Renamed, Error);
	const Files::path& Removed = Error ? Path : Renamed;
	for (int Try = 0; Try < 100; ++Try)
	{
		Files::remove_all(Removed, Error);
		if (!Files::exists(Files::symlink_status(Removed, Error)))
		{
			return;
		}
		std::this_thread::sleep_for(std::chrono::milliseconds(5));
	}
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

FScratchPath::FScratchPath(Files::path InPath)
	: Path(std::move(InPath))
	, Removal([RemovedPath = Path] { RemoveWhileWritten(RemovedPath); })
{
}

FScratchPath::~FScratchPath()
{
	std::error_code Ignored;
	Files::remove_all(Path, Ignored);
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
