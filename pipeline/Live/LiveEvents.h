// Server-sent events: every page that listens is told of edits, frames and mistakes.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace Drydock
{

/** Every function from any thread. */
class FLiveEvents
{
public:
	/** Json: on one line, or several. */
	void Send(const std::string& Name, const std::string& Json);

	/** The stream of a new listener (FHttpResponse::Next). Null: there are too many. */
	std::function<bool(std::string& OutPart)> Listen();

	/** Says bye, and ends all streams. */
	void Close();

private:
	struct FListener
	{
		std::deque<std::string> Waiting;
	};

	std::mutex Mutex;
	std::condition_variable Told;
	std::vector<std::weak_ptr<FListener>> Listeners;
	bool bClosed = false;
};

} // namespace Drydock
