// Keeps a bounded row of messages for each listener: one who does not read loses the oldest.
#include "Live/LiveEvents.h"

#include <chrono>

namespace Drydock
{

namespace
{

constexpr size_t MaxListeners = 16;
constexpr size_t MaxWaiting = 256;
constexpr std::chrono::seconds Interval(5); // after which a silent stream says that it lives

} // namespace

void FLiveEvents::Send(const std::string& Name, const std::string& Json)
{
	std::string Line = Json;
	std::erase(Line, '\n');
	const std::string Message = "event: " + Name + "\ndata: " + Line + "\n\n";
	const std::lock_guard Lock(Mutex);
	std::erase_if(Listeners, [](const auto& Listener) { return Listener.expired(); });
	for (const std::weak_ptr<FListener>& Listener : Listeners)
	{
		if (const std::shared_ptr<FListener> Present = Listener.lock())
		{
			Present->Waiting.push_back(Message);
			if (Present->Waiting.size() > MaxWaiting)
			{
				Present->Waiting.pop_front();
			}
		}
	}
	Told.notify_all();
}

std::function<bool(std::string& OutPart)> FLiveEvents::Listen()
{
	const auto Listener = std::make_shared<FListener>();
	const std::lock_guard Lock(Mutex);
	std::erase_if(Listeners, [](const auto& Other) { return Other.expired(); });
	if (bClosed || Listeners.size() >= MaxListeners)
	{
		return nullptr;
	}
	Listener->Waiting.push_back("retry: 300\n\n");
	Listeners.push_back(Listener);
	return [this, Listener](std::string& OutPart)
	{
		std::unique_lock WaitLock(Mutex);
		Told.wait_for(WaitLock, Interval, [&] { return bClosed || !Listener->Waiting.empty(); });
		OutPart = Listener->Waiting.empty() ? ": here\n\n" : "";
		for (const std::string& Message : Listener->Waiting)
		{
			OutPart += Message;
		}
		Listener->Waiting.clear();
		return !bClosed;
	};
}

void FLiveEvents::Close()
{
	Send("bye", "{}");
	const std::lock_guard Lock(Mutex);
	bClosed = true;
	Told.notify_all();
}

} // namespace Drydock
