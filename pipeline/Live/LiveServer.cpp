// Routes of the page's requests.
#include "Live/LiveServer.h"

#include "Live/LiveErrors.h"
#include "Live/LiveInspect.h"
#include "Live/LiveJson.h"
#include "Live/LiveSave.h"
#include "Report/ReportPage.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <array>
#include <sys/random.h>
#include <thread>

namespace Drydock
{

namespace
{

constexpr const char* Policy =
	"default-src 'none'; script-src 'self' 'unsafe-inline'; style-src 'self' 'unsafe-inline'; img-src 'self' data: "
	"blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

constexpr int MaxStep = 16; // of a smaller picture

const std::string PicturePath = "GET /api/picture/";

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

FHttpResponse GivePicture(int Width, int Height, const char* Type, std::string Bytes)
{
	return {.Type = "application/octet-stream",
		.Headers = {{"X-Drydock-Width", std::to_string(Width)}, {"X-Drydock-Height", std::to_string(Height)},
			{"X-Drydock-Channels", "4"}, {"X-Drydock-Type", Type}},
		.Body = std::move(Bytes)};
}

/** The body's object, with the texts of the query. Throws FError. */
FJsonValue ReadAsked(const FHttpRequest& Request)
{
	std::vector<FDiagnostic> Faults;
	bool bSyntaxError = false;
	FJsonValue Asked = ParseJson(Request.Body.empty() ? "{}" : Request.Body, "", Faults, bSyntaxError);
	if (bSyntaxError || !Faults.empty() || Asked.Type != EJsonType::Object)
	{
		throw FError({.Code = ErrorBadEdit, .Message = "the request's body is not a JSON object"}, ExitUsage);
	}
	for (const auto& [Name, Text] : Request.Query)
	{
		FJsonValue& Value = Asked.Members.emplace_back(FJsonMember{Name, {}}).Value;
		Value.Type = EJsonType::String;
		Value.String = Text;
	}
	return Asked;
}

std::string ChangeState(FLiveSession& Session, const FJsonValue& Asked)
{
	Session.Change(Asked);
	return "{\"revision\": " + std::to_string(Session.GetHistory().GetRevision()) + "}\n";
}

std::string AddPin(FLiveSession& Session, const FJsonValue& Asked)
{
	return "{\"pin\": " + std::to_string(Session.Pin(Asked.GetString("name"))) + "}\n";
}

std::string RemovePin(FLiveSession& Session, const FJsonValue& Asked)
{
	Session.Unpin(static_cast<int>(Asked.GetNumber("pin", 0.0)));
	return "{}\n";
}

std::string GetRecord(FLiveSession& Session, const FJsonValue&)
{
	return Session.GetHistory().GetRecord();
}

/** The requests that the session's thread answers with JSON, or with text. */
const std::map<std::string, std::string (*)(FLiveSession& Session, const FJsonValue& Asked)> Routes = {
	{"GET /api/state", MakeStateJson},
	{"GET /api/pictures", ListPictures},
	{"GET /api/session", GetRecord},
	{"GET /api/text", MakeLiveText},
	{"GET /api/report/now", MakeLiveReport},
	{"GET /api/ledger", MakeLedgerJson},
	{"GET /api/probe", ProbeLive},
	{"GET /api/trace", TraceLive},
	{"POST /api/edit", ChangeState},
	{"POST /api/pin", AddPin},
	{"POST /api/unpin", RemovePin},
	{"POST /api/save", SaveConfig},
	{"POST /api/price", MeasurePrice},
};

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
	constexpr std::chrono::milliseconds Interval(200);    // between looks at files, and before one after a frame
	constexpr std::chrono::milliseconds MostUnseen(2000); // while frame follows frame
	constexpr std::chrono::milliseconds MostBefore(20);   // of requests while a frame is wanted
	constexpr FClock::duration None(0);
	Session.LookAtFiles();
	FClock::time_point LastLook = FClock::now();
	FClock::time_point NextLook = LastLook + Interval;
	while (!bEnd)
	{
		const FClock::time_point Begin = FClock::now();
		const FClock::duration Left = Session.IsFrameWanted() ? None : std::max(NextLook - Begin, None);
		for (bool bNext = Queue.RunNext(Left); bNext && !bEnd && FClock::now() < Begin + Left + MostBefore;)
		{
			bNext = Queue.RunNext(None);
		}
		if (!bEnd && Session.IsFrameWanted())
		{
			Session.RunFrame();
			NextLook = std::min(FClock::now() + Interval, LastLook + MostUnseen);
		}
		if (!bEnd && FClock::now() >= NextLook)
		{
			Session.LookAtFiles();
			LastLook = FClock::now();
			NextLook = LastLook + Interval;
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
			Response.Status = Error.GetExitCode() >= ExitInternal                      ? 500
							  : Error.GetDiagnostics().front().Code == ErrorFileExists ? 409
																					   : 422;
			Response.Body = MakeMessagesJson(Error.GetDiagnostics());
		}
	}
	Response.Headers.insert(
		{{"Cache-Control", "no-store"}, {"X-Content-Type-Options", "nosniff"}, {"Referrer-Policy", "no-referrer"},
			{"Content-Security-Policy", Policy}, {"Cross-Origin-Resource-Policy", "same-origin"}});
	return Response;
}

FHttpResponse FLiveServer::AnswerPicture(const FHttpRequest& Request, const std::string& Name)
{
	const std::string Kind = Find(Request.Query, "kind");
	if (Kind == "pass")
	{
		const FPicture Picture = Queue.Call([&] { return ReadPassPicture(Session, ReadAsked(Request)); });
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
	if (Kind == "final")
	{
		return GivePicture(Final.Width, Final.Height, "float32", MakeFloatBytes(Final.Take(3), true));
	}
	const int Step = std::clamp(ParseAll<int>(Find(Request.Query, "step")).value_or(1), 1, MaxStep);
	const bool bSmall = Step > 1 && Picture->Step == Step;
	Pictures.SetStep(Step);
	FHttpResponse Response = GivePicture(
		Final.Width, Final.Height, "uint8", Step > 1 && !bSmall ? ShrinkCodes(*Picture, Step) : std::string());
	if (Step == 1 || bSmall)
	{
		Response.Shared = std::shared_ptr<const std::string>(Picture, bSmall ? &Picture->Small : &Picture->Codes);
	}
	return Response;
}

FHttpResponse FLiveServer::Route(const FHttpRequest& Request)
{
	const std::string What = Request.Method + " " + Request.Path;
	if (What == "GET /")
	{
		return {.Type = "text/html; charset=utf-8",
			.Body = ReadTextFile(
				FindPageFile("live.html"), "drydock's own file cannot be opened: is drydock installed completely?")};
	}
	if (What == "GET /api/events")
	{
		FHttpResponse Stream{.Type = "text/event-stream", .Next = Events.Listen()};
		return Stream.Next ? Stream : Refuse(503, "too many pages listen already");
	}
	if (What.starts_with(PicturePath))
	{
		return AnswerPicture(Request, What.substr(PicturePath.size()));
	}
	const auto Found = Routes.find(What);
	if (What != "POST /api/end" && Found == Routes.end())
	{
		return Refuse(404, "there is no " + What);
	}
	const FJsonValue Asked = ReadAsked(Request);
	const int Change = What == "POST /api/edit" ? 1 : 0;
	Session.NumChanges += Change;
	FHttpResponse Response;
	Response.Body = Queue.Call(
		[&]
		{
			Session.NumChanges -= Change;
			bEnd = Found == Routes.end();
			return bEnd ? "{}\n" : Found->second(Session, Asked);
		});
	Response.Type = What == "GET /api/session" || What == "GET /api/text" ? "text/plain; charset=utf-8" : Response.Type;
	return Response;
}

} // namespace Drydock
