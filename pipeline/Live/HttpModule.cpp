// The module that speaks HTTP by cpp-httplib: a library of its own, which libdrydock_pipeline loads when it has to.
#include "Live/HttpServer.h"

#include <httplib.h>

#include <algorithm>
#include <chrono>
#include <poll.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

namespace Drydock
{

namespace
{

using FClock = std::chrono::steady_clock;

constexpr std::chrono::seconds MostSecondsToRead(10);  // a whole request
constexpr std::chrono::seconds MostSecondsToWrite(10); // without the other side taking a byte
constexpr std::chrono::seconds MostSecondsIdle(20);    // between two requests
constexpr int SliceMilliseconds = 100;                 // after which the end of the server is noticed

/** A socket with a limit of what one request may take: bytes and time. */
class FBoundedStream final : public httplib::Stream
{
public:
	FBoundedStream(socket_t InSocket, const std::function<bool()>& InIsEnding)
		: Socket(InSocket)
		, IsEnding(InIsEnding)
	{
	}

	/** Waits for the first byte of a request; false where none comes. */
	bool BeginRequest()
	{
		BytesLeft = MaxHttpRequest;
		Deadline = FClock::now() + MostSecondsIdle;
		if (From == To && !WaitFor(POLLIN))
		{
			return false;
		}
		Deadline = FClock::now() + MostSecondsToRead;
		return true;
	}

	bool is_readable() const override { return From < To || Poll(POLLIN, 0); }
	bool is_writable() const override { return Poll(POLLOUT, 0); }

	ssize_t read(char* Bytes, size_t Size) override
	{
		if (From == To)
		{
			const ssize_t NumRead = WaitFor(POLLIN) ? recv(Socket, Buffer, sizeof(Buffer), 0) : -1;
			if (NumRead <= 0)
			{
				bFailed = true;
				return NumRead;
			}
			From = 0;
			To = static_cast<size_t>(NumRead);
		}
		const size_t Count = std::min({Size, To - From, BytesLeft});
		std::copy_n(Buffer + From, Count, Bytes);
		From += Count;
		BytesLeft -= Count;
		bFailed = bFailed || Count == 0;
		return Count > 0 ? static_cast<ssize_t>(Count) : -1;
	}

	/** A request did not come whole. */
	bool HasFailed() const { return bFailed; }

	ssize_t write(const char* Bytes, size_t Size) override
	{
		Deadline = FClock::now() + MostSecondsToWrite;
		return WaitFor(POLLOUT) ? send(Socket, Bytes, Size, MSG_NOSIGNAL) : -1;
	}

	void get_remote_ip_and_port(std::string&, int&) const override {}
	void get_local_ip_and_port(std::string&, int&) const override {}
	socket_t socket() const override { return Socket; }

private:
	bool Poll(short Events, int Milliseconds) const
	{
		pollfd Waiting = {Socket, Events, 0};
		return poll(&Waiting, 1, Milliseconds) > 0 && (Waiting.revents & Events) != 0;
	}

	bool WaitFor(short Events) const
	{
		while (!Poll(Events, SliceMilliseconds))
		{
			if (IsEnding() || FClock::now() > Deadline)
			{
				return false;
			}
			pollfd Gone = {Socket, Events, 0};
			if (poll(&Gone, 1, 0) > 0 && (Gone.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0)
			{
				return false;
			}
		}
		return true;
	}

	const socket_t Socket;
	const std::function<bool()>& IsEnding;
	FClock::time_point Deadline;
	size_t BytesLeft = 0;
	char Buffer[16384];
	size_t From = 0; // in Buffer
	size_t To = 0;
	bool bFailed = false;
};

std::string ToSmall(std::string Text)
{
	std::ranges::transform(Text, Text.begin(), [](char C) { return C >= 'A' && C <= 'Z' ? char(C - 'A' + 'a') : C; });
	return Text;
}

class FHttpServer final : public IHttpServer, private httplib::Server
{
public:
	FHttpServer(int AskedPort, FHttpHandler InHandler)
		: Handler(std::move(InHandler))
	{
		new_task_queue = []
		{
			return new httplib::ThreadPool(MaxHttpConnections);
		};
		set_tcp_nodelay(true);
		set_payload_max_length(MaxHttpBody);
		set_socket_options(
			[](socket_t Socket)
			{
				const int Yes = 1;
				setsockopt(Socket, SOL_SOCKET, SO_REUSEADDR, &Yes, sizeof(Yes)); // not SO_REUSEPORT: nobody shares it
			});
		set_pre_routing_handler([this](const httplib::Request& Request, httplib::Response& Response)
			{ return AnswerWithoutBody(Request, Response) ? HandlerResponse::Handled : HandlerResponse::Unhandled; });
		Post(
			"/.*", [this](const httplib::Request& Request, httplib::Response& Response) { Answer(Request, Response); });
		set_error_handler(HandlerWithResponse(
			[](const httplib::Request&, httplib::Response& Response)
			{
				bRefused = bRefused || Response.status == 400; // the rest of the bytes cannot be told from it
				return HandlerResponse::Unhandled;
			}));
		set_exception_handler(
			[](const httplib::Request&, httplib::Response& Response, std::exception_ptr) { Response.status = 500; });
		Port = AskedPort == 0 ? bind_to_any_port("127.0.0.1") : bind_to_port("127.0.0.1", AskedPort) ? AskedPort : -1;
		if (Port > 0)
		{
			::listen(svr_sock_, SOMAXCONN); // the library's own backlog is 5
			Listener = std::thread([this] { listen_after_bind(); });
		}
	}

	~FHttpServer() override
	{
		bEnding = true;
		if (Listener.joinable())
		{
			for (int Try = 0; Try < 1000 && !is_running(); ++Try) // it has just been started
			{
				std::this_thread::sleep_for(std::chrono::milliseconds(1));
			}
			stop();
			Listener.join();
		}
	}

	int GetPort() const override { return Port; }

private:
	/** In place of the library's own loop: requests are bounded as a whole, and none is compressed. */
	bool process_and_close_socket(socket_t Socket) override
	{
		const std::function<bool()> IsEnding = [this]
		{
			return bEnding.load();
		};
		FBoundedStream Stream(Socket, IsEnding);
		while (Stream.BeginRequest())
		{
			bool bClosed = false;
			bRefused = false;
			const bool bDone = process_request(Stream, false, bClosed,
				[](httplib::Request& Request)
				{
					Request.headers.erase("Accept-Encoding");
					Request.ranges.clear();
				});
			if (!bDone || bClosed || bRefused || Stream.HasFailed())
			{
				break;
			}
		}
		shutdown(Socket, SHUT_RDWR);
		close(Socket);
		return true;
	}

	/** Whether the request has its answer before a body is read: there is none, or nobody reads it. */
	bool AnswerWithoutBody(const httplib::Request& Request, httplib::Response& Response)
	{
		constexpr size_t MaxTarget = 2000; // bytes, before regular expressions look at it
		const std::string Length = Request.get_header_value("Content-Length");
		const std::string Type = Request.get_header_value("Content-Type");
		const bool bBody = !Length.empty() && Length != "0";
		const int Refusal = Request.target.size() > MaxTarget                                            ? 414
							: Request.method != "GET" && Request.method != "POST"                        ? 405
							: Request.has_header("Transfer-Encoding")                                    ? 411
							: Length.find_first_not_of("0123456789") != Length.npos || Length.size() > 9 ? 400
							: bBody && Request.method == "GET"                                           ? 400
							: bBody && std::stoul(Length) > MaxHttpBody                                  ? 413
							: bBody && !Type.starts_with("application/json")                             ? 415
																										 : 0;
		if (Refusal != 0)
		{
			bRefused = true;
			Response.status = Refusal;
			Response.set_header("Connection", "close");
			return true;
		}
		if (!bBody)
		{
			Answer(Request, Response);
		}
		return !bBody;
	}

	void Answer(const httplib::Request& Request, httplib::Response& Response) const
	{
		FHttpRequest Asked;
		Asked.Method = Request.method;
		Asked.Path = Request.path;
		Asked.Body = Request.body;
		Asked.Query.insert(Request.params.begin(), Request.params.end());
		for (const auto& [Name, Value] : Request.headers)
		{
			Asked.Headers.emplace(ToSmall(Name), Value);
		}
		FHttpResponse Answered = Handler(Asked);
		Response.status = Answered.Status;
		for (const auto& [Name, Value] : Answered.Headers)
		{
			Response.set_header(Name.c_str(), Value);
		}
		if (Answered.Shared)
		{
			Response.set_content_provider(Answered.Shared->size(), Answered.Type,
				[Shared = Answered.Shared](size_t Offset, size_t Length, httplib::DataSink& Sink)
				{ return Sink.write(Shared->data() + Offset, Length); });
			return;
		}
		if (!Answered.Next)
		{
			Response.body = std::move(Answered.Body);
			Response.set_header("Content-Type", Answered.Type);
			return;
		}
		Response.set_chunked_content_provider(Answered.Type,
			[this, Next = std::move(Answered.Next)](size_t, httplib::DataSink& Sink)
			{
				std::string Part;
				const bool bMore = Next(Part) && !bEnding;
				const bool bWritten = Part.empty() || Sink.write(Part.data(), Part.size());
				if (!bMore)
				{
					Sink.done();
				}
				return bWritten;
			});
	}

	const FHttpHandler Handler;
	int Port = -1;
	std::atomic<bool> bEnding = false;
	std::thread Listener;

	/** The body of this thread's request was not read, so that nothing can follow it. */
	static thread_local bool bRefused;
};

thread_local bool FHttpServer::bRefused = false;

} // namespace

} // namespace Drydock

extern "C" __attribute__((visibility("default"))) Drydock::IHttpServer* DrydockMakeHttpServer(
	int Port, const Drydock::FHttpHandler& Handler, std::string& OutFault)
{
	try
	{
		auto Server = std::make_unique<Drydock::FHttpServer>(Port, Handler);
		if (Server->GetPort() > 0)
		{
			return Server.release();
		}
		OutFault = Port == 0 ? "no port of this machine can be had"
							 : "port " + std::to_string(Port) + " is in use, or not allowed";
	}
	catch (const std::exception& Error)
	{
		OutFault = Error.what();
	}
	return nullptr;
}
