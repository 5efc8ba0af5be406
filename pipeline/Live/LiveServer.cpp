// Routes of the page's requests.
#include "Live/LiveServer.h"

#include "Live/LiveErrors.h"
#include "Live/LiveInspect.h"
#include "Live/LiveJson.h"
#include "Live/LivePage.h"
#include "Live/LiveSave.h"
#include "Text/JsonWriter.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sys/random.h>
#include <thread>

namespace Drydock
{

namespace
{

constexpr const char* Policy =
	"default-src 'none'; script-src 'self' 'unsafe-inline'; style-src 'self' 'unsafe-inline'; img-src 'self' data: "
	"blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

std::string MakeToken()
{
	std::array<unsigned char, 16> Bytes{};
	if (getrandom(Bytes.data(), Bytes.size(), 0) != static_cast<ssize_t>(Bytes.size()))
	{
		throw FError({.Code = ErrorNoServer, .Message = "the system gives no random numbers"}, ExitFiles);
	}
	std::string Token;
	for (const unsigned char Byte : Bytes)
	{
		constexpr const char* Digits = "0123456789abcdef";
		Token += Digits[Byte >> 4];
		Token += Digits[Byte & 15];
	}
	return Token;
}

/** In the same time wherever they differ. */
bool AreEqual(const std::string& A, const std::string& B)
{
	unsigned Difference = A.size() == B.size() ? 0 : 1;
	for (size_t Index = 0; Index < std::min(A.size(), B.size()); ++Index)
	{
		Difference |= static_cast<unsigned>(A[Index] ^ B[Index]);
	}
	return Difference == 0;
}

std::string Find(const std::map<std::string, std::string>& Values, const std::string& Name)
{
	const auto Found = Values.find(Name);
	return Found == Values.end() ? std::string() : Found->second;
}

FHttpResponse Refuse(int Status, const std::string& Message)
{
	return {.Status = Status, .Body = MakeMessagesJson({{.Code = ErrorBadEdit, .Message = Message}})};
}

FHttpResponse Give(const std::string& Json)
{
	return {.Body = Json};
}

FHttpResponse GiveText(const std::string& Text)
{
	return {.Type = "text/plain; charset=utf-8", .Body = Text};
}

FHttpResponse GivePicture(int Width, int Height, const char* Type, std::string Bytes)
{
	return {.Type = "application/octet-stream",
		.Headers = {{"X-Drydock-Width", std::to_string(Width)}, {"X-Drydock-Height", std::to_string(Height)},
			{"X-Drydock-Channels", "4"}, {"X-Drydock-Type", Type}},
		.Body = std::move(Bytes)};
}

/** The body's object; an empty one where there is none. Throws FError. */
FJsonValue ReadBody(const FHttpRequest& Request)
{
	std::vector<FDiagnostic> Faults;
	bool bSyntaxError = false;
	FJsonValue Body = ParseJson(Request.Body.empty() ? "{}" : Request.Body, "", Faults, bSyntaxError);
	if (bSyntaxError || !Faults.empty() || Body.Type != EJsonType::Object)
	{
		throw FError({.Code = ErrorBadEdit, .Message = "the request's body is not a JSON object"}, ExitUsage);
	}
	return Body;
}

int ReadNumber(const std::map<std::string, std::string>& Query, const std::string& Name)
{
	const std::string Text = Find(Query, Name);
	int Number = 0;
	const auto [End, Fault] = std::from_chars(Text.data(), Text.data() + Text.size(), Number);
	if (Fault != std::errc() || End != Text.data() + Text.size() || Text.empty())
	{
		throw FError(
			{.Code = ErrorBadEdit, .Message = "'" + Text + "' is not a whole number", .Where = Name}, ExitUsage);
	}
	return Number;
}

} // namespace

FLiveServer::FLiveServer(
	FLiveSession& InSession, FLiveEvents& InEvents, FLivePictures& InPictures, int Port, const std::string& InToken)
	: Session(InSession)
	, Events(InEvents)
	, Pictures(InPictures)
	, Token(InToken.empty() ? MakeToken() : InToken)
	, Http(StartHttpServer(Port, [this](const FHttpRequest& Request) { return Answer(Request); }))
{
	BoundPort = Http->GetPort();
}

FLiveServer::~FLiveServer()
{
	Events.Close();
	Queue.Close();
	Http.reset();
}

std::string FLiveServer::GetAddress() const
{
	return "http://127.0.0.1:" + std::to_string(BoundPort) + "/?token=" + Token;
}

void FLiveServer::Serve()
{
	using FClock = std::chrono::steady_clock;
	constexpr std::chrono::milliseconds Interval(200);  // of looks at files
	constexpr std::chrono::milliseconds MostBefore(20); // of requests while a frame is wanted
	FClock::time_point NextLook = FClock::now() + Interval;
	Session.LookAtFiles();
	while (!bEnd)
	{
		const FClock::time_point Begin = FClock::now();
		const bool bFrame = Session.IsFrameWanted();
		const auto Left = bFrame ? std::chrono::milliseconds(0)
								 : std::chrono::duration_cast<std::chrono::milliseconds>(NextLook - Begin);
		if (Queue.RunNext(std::max(Left, std::chrono::milliseconds(0))))
		{
			while (!bEnd && FClock::now() < Begin + MostBefore && Queue.RunNext(std::chrono::milliseconds(0)))
			{
			}
		}
		if (!bEnd && Session.IsFrameWanted())
		{
			Session.RunFrame();
		}
		if (!bEnd && FClock::now() >= NextLook)
		{
			Session.LookAtFiles();
			NextLook = FClock::now() + Interval;
		}
	}
}

bool FLiveServer::IsAllowed(const FHttpRequest& Request) const
{
	const std::string Port = ":" + std::to_string(BoundPort);
	const std::string Host = Find(Request.Headers, "host");
	const std::string Origin = Find(Request.Headers, "origin");
	const bool bHost = Host == "127.0.0.1" + Port || Host == "localhost" + Port;
	const bool bInQuery = Request.Path == "/" || Request.Path == "/api/events";
	const std::string Given = bInQuery ? Find(Request.Query, "token") : Find(Request.Headers, "x-drydock-token");
	return bHost && (Origin.empty() || Origin == "http://127.0.0.1" + Port || Origin == "http://localhost" + Port) &&
		   AreEqual(Given, Token);
}

FHttpResponse FLiveServer::Answer(const FHttpRequest& Request)
{
	FHttpResponse Response;
	if (!IsAllowed(Request))
	{
		Response = Refuse(403, "this address needs the token that drydock live printed");
	}
	else
	{
		try
		{
			Response = Route(Request);
		}
		catch (const std::future_error&)
		{
			Response = Refuse(503, "the server ends");
		}
		catch (...)
		{
			const FError Error = Session.GetOptions().Explain(std::current_exception());
			Response.Status = Error.GetExitCode() >= ExitInternal ? 500 : 422;
			Response.Body = MakeMessagesJson(Error.GetDiagnostics());
		}
	}
	Response.Headers.insert(
		{{"Cache-Control", "no-store"}, {"X-Content-Type-Options", "nosniff"}, {"Referrer-Policy", "no-referrer"},
			{"Content-Security-Policy", Policy}, {"Cross-Origin-Resource-Policy", "same-origin"}});
	return Response;
}

FHttpResponse FLiveServer::AnswerPicture(const FHttpRequest& Request)
{
	const std::string Kind = Find(Request.Query, "kind");
	const std::string Name = Request.Path.substr(std::string("/api/picture/").size());
	if (Kind == "pass")
	{
		const int Pass = ReadNumber(Request.Query, "pass");
		const std::string Resource = Find(Request.Query, "resource");
		const FPicture Picture = Queue.Call([&] { return ReadPassPicture(Session, Pass, Resource); });
		return GivePicture(Picture.Width, Picture.Height, "float32", MakeFloatBytes(Picture, false));
	}
	const FLivePictures::FHandle Picture = Pictures.Find(Name);
	if (Picture == nullptr)
	{
		return Refuse(404, "there is no picture " + Name + ", or no longer");
	}
	if (Kind != "final8" && Kind != "final")
	{
		return Refuse(404, "a picture's kind is final8, final or pass");
	}
	const FPicture& Final = Picture->Final;
	return Kind == "final8" ? GivePicture(Final.Width, Final.Height, "uint8", Picture->Codes)
							: GivePicture(Final.Width, Final.Height, "float32", MakeFloatBytes(Final.Take(3), true));
}

FHttpResponse FLiveServer::Change(const std::function<void()>& Do)
{
	++NumChanges;
	return Give(Queue.Call(
		[this, &Do]
		{
			--NumChanges;
			Do();
			return "{\"revision\": " + std::to_string(Session.GetHistory().GetRevision()) + "}\n";
		}));
}

FHttpResponse FLiveServer::Route(const FHttpRequest& Request)
{
	const std::string& Path = Request.Path;
	const bool bGet = Request.Method == "GET";
	if (bGet && Path == "/")
	{
		return {.Type = "text/html; charset=utf-8", .Body = ReadLivePage()};
	}
	if (bGet && Path == "/api/events")
	{
		FHttpResponse Stream{.Type = "text/event-stream", .Next = Events.Listen()};
		return Stream.Next ? Stream : Refuse(503, "too many pages listen already");
	}
	if (bGet && Path.starts_with("/api/picture/"))
	{
		return AnswerPicture(Request);
	}
	if (bGet && Path == "/api/state")
	{
		return Give(Queue.Call([&] { return MakeStateJson(Session); }));
	}
	if (bGet && Path == "/api/session")
	{
		return GiveText(Queue.Call([&] { return Session.GetHistory().GetRecord(); }));
	}
	if (bGet && Path == "/api/text")
	{
		return GiveText(Queue.Call([&] { return MakeLiveText(Session, Find(Request.Query, "as")); }));
	}
	if (bGet && Path == "/api/report/now")
	{
		return Give(Queue.Call([&] { return MakeLiveReport(Session); }));
	}
	if (bGet && Path == "/api/ledger")
	{
		return Give(Queue.Call([&] { return MakeLedgerJson(Session, Find(Request.Query, "setting")); }));
	}
	if (bGet && (Path == "/api/probe" || Path == "/api/trace"))
	{
		const int X = ReadNumber(Request.Query, "x");
		const int Y = ReadNumber(Request.Query, "y");
		const std::string Pass = Find(Request.Query, "pass");
		return Give(Queue.Call(
			[&] { return Path == "/api/probe" ? ProbeLive(Session, X, Y, Pass) : TraceLive(Session, X, Y, Pass); }));
	}
	if (Request.Method == "POST" && Path == "/api/edit")
	{
		const FJsonValue Body = ReadBody(Request);
		const FJsonValue* const Edits = Body.Find("edits");
		const std::vector<FConfigEdit> Read = ReadEdits(Edits != nullptr ? *Edits : FJsonValue());
		return Change([&] { Session.Edit(Read, Body.GetString("drag")); });
	}
	if (Request.Method == "POST" && Path == "/api/undo")
	{
		return Change([&] { Session.Undo(); });
	}
	if (Request.Method == "POST" && Path == "/api/redo")
	{
		return Change([&] { Session.Redo(); });
	}
	if (Request.Method == "POST" && Path == "/api/reset")
	{
		const FJsonValue Body = ReadBody(Request);
		const FJsonValue* const Pointer = Body.Find("pointer");
		const bool bOne = Pointer != nullptr && Pointer->Type == EJsonType::String;
		return Change([&] { Session.Reset(bOne ? std::optional(Pointer->String) : std::nullopt); });
	}
	if (Request.Method == "POST" && Path == "/api/pin")
	{
		const std::string Name = ReadBody(Request).GetString("name");
		return Give("{\"pin\": " + std::to_string(Queue.Call([&] { return Session.Pin(Name); })) + "}\n");
	}
	if (Request.Method == "DELETE" && Path.starts_with("/api/pin/"))
	{
		const int Number = ReadNumber({{"pin", Path.substr(std::string("/api/pin/").size())}}, "pin");
		return Change([&] { Session.Unpin(Number); });
	}
	if (Request.Method == "POST" && Path == "/api/price")
	{
		return Give(Queue.Call([&] { return MeasurePrice(Session, [this] { return NumChanges > 0; }); }));
	}
	if (Request.Method == "POST" && Path == "/api/save")
	{
		const FJsonValue Body = ReadBody(Request);
		const FJsonValue* const Again = Body.Find("again");
		const ELiveSave Saved =
			Queue.Call([&] { return SaveConfig(Session, Body.GetString("path"), Again != nullptr && Again->Bool); });
		return Saved == ELiveSave::Exists ? Refuse(409, "the file exists: ask again to replace it")
										  : Give("{\"saved\": " + FJsonWriter::Quote(Body.GetString("path")) + "}\n");
	}
	if (Request.Method == "POST" && Path == "/api/end")
	{
		return Give(Queue.Call(
			[&]
			{
				bEnd = true;
				return std::string("{}\n");
			}));
	}
	return Refuse(404, "there is no " + Request.Method + " " + Path);
}

} // namespace Drydock
