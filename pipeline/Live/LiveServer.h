// Answers the page: guards the door, and calls the session on its own thread.
#pragma once

#include "Live/HttpServer.h"
#include "Live/LiveQueue.h"
#include "Live/LiveSession.h"

#include <atomic>
#include <string>

namespace Drydock
{

class DRYDOCK_API FLiveServer
{
public:
	/** Port: 0 takes a free one. Token: empty makes one. Session: called by the thread of Serve alone. Throws FError as
	 * StartHttpServer. */
	FLiveServer(FLiveSession& InSession, FLiveEvents& InEvents, FLivePictures& InPictures, int Port,
		const std::string& InToken);
	~FLiveServer();

	/** "http://127.0.0.1:8123/?token=..." */
	std::string GetAddress() const;

	int GetPort() const { return BoundPort; }
	const std::string& GetToken() const { return Token; }

	/** Runs frames, answers and looks at files, until a page ends it. */
	void Serve();

private:
	FHttpResponse Answer(const FHttpRequest& Request);

	/** Whether the request comes from our page: Host, Origin and token. */
	bool IsAllowed(const FHttpRequest& Request) const;
	FHttpResponse Route(const FHttpRequest& Request);
	/** Name: of the picture, as FLivePictures knows it. */
	FHttpResponse AnswerPicture(const FHttpRequest& Request, const std::string& Name);

	FLiveSession& Session;
	FLiveEvents& Events;
	FLivePictures& Pictures;
	FLiveQueue Queue;
	const std::string Token;
	std::atomic<int> BoundPort = 0;
	std::atomic<bool> bEnd = false;
	std::atomic<int> NumChanges = 0;   // that wait for their turn
	std::unique_ptr<IHttpServer> Http; // ends first
};

} // namespace Drydock
