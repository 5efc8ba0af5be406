// The door of `drydock live`: nobody comes in without the token, and no request keeps it from answering the next.
#include <gtest/gtest.h>

#include "LiveTestUtils.h"

#include <memory>
#include <random>

using namespace LiveTest;

namespace
{

class LiveDoor : public testing::Test
{
protected:
	LiveDoor()
	{
		Folder.WriteFrame("a.json", "");
		Program = std::make_unique<FLiveProgram>(Folder.Path, std::vector<std::string>{"a.json"});
	}

	void ExpectAlive() const
	{
		const auto Begin = std::chrono::steady_clock::now();
		EXPECT_EQ(200, Program->Get("/api/state").Status);
		EXPECT_LT(std::chrono::steady_clock::now() - Begin, std::chrono::seconds(30));
	}

	FHeaders With(const std::string& Name, const std::string& Value) const
	{
		FHeaders Headers = Program->MakeHeaders();
		Headers[Name] = Value;
		return Headers;
	}

	const FProgramFolder Folder{"live_door"};
	std::unique_ptr<FLiveProgram> Program;
};

} // namespace

TEST_F(LiveDoor, OpensToItsOwnPageAlone)
{
	const std::string Port = std::to_string(Program->Port);
	const std::string Paths[] = {
		"/", "/api/state", "/api/events", "/api/picture/now?kind=final8", "/api/text?as=config"};
	FHeaders NoToken = Program->MakeHeaders();
	NoToken.erase("X-Drydock-Token");
	for (const std::string& Path : Paths)
	{
		EXPECT_EQ(403, Program->Ask("GET", Path, NoToken).Status) << Path;
		EXPECT_EQ(403, Program->Ask("GET", Path, With("X-Drydock-Token", "0" + Program->Token)).Status) << Path;
		EXPECT_EQ(403, Program->Ask("GET", Path, With("X-Drydock-Token", "")).Status) << Path;
	}
	const FAnswer Page = Program->Ask("GET", "/?token=" + Program->Token, NoToken);
	EXPECT_EQ(200, Page.Status);
	EXPECT_NE(std::string::npos, Page.Headers.at("content-security-policy").find("default-src 'none'"));
	EXPECT_EQ("nosniff", Page.Headers.at("x-content-type-options"));
	EXPECT_EQ(0u, Page.Headers.count("access-control-allow-origin"));
	// The token in a query is for the page and its events alone.
	EXPECT_EQ(403, Program->Ask("GET", "/api/state?token=" + Program->Token, NoToken).Status);
	EXPECT_EQ(200, Program->Ask("GET", "/api/state", With("Host", "localhost:" + Port)).Status);
	for (const std::string& Host : {std::string("evil.example:" + Port), std::string("127.0.0.1"),
			 std::string("127.0.0.1:1"), std::string("127.0.0.1:" + Port + ".evil.example"), std::string("")})
	{
		EXPECT_EQ(403, Program->Ask("GET", "/api/state", With("Host", Host)).Status) << Host;
	}
	for (const std::string& Origin : {std::string("http://evil.example"), std::string("null"),
			 std::string("https://127.0.0.1:" + Port), std::string("http://127.0.0.1")})
	{
		EXPECT_EQ(403, Program->Ask("POST", "/api/edit", With("Origin", Origin)).Status) << Origin;
	}
	EXPECT_EQ(422, Program->Ask("POST", "/api/edit", With("Origin", "http://127.0.0.1:" + Port)).Status);
}

TEST_F(LiveDoor, ListensOnTheLoopbackAddressAlone)
{
	std::ifstream Table("/proc/net/tcp");
	char Port[8];
	std::snprintf(Port, sizeof(Port), ":%04X", static_cast<unsigned>(Program->Port));
	bool bFound = false;
	for (std::string Line; std::getline(Table, Line);)
	{
		if (Line.find(std::string(Port) + " 00000000:0000 0A") != std::string::npos)
		{
			bFound = true;
			EXPECT_NE(std::string::npos, Line.find("0100007F" + std::string(Port))) << Line;
		}
	}
	EXPECT_TRUE(bFound);
}

TEST_F(LiveDoor, RefusesWhatIsTooLargeOrOfAnotherKind)
{
	FHeaders Typed = Program->MakeHeaders();
	Typed["Content-Type"] = "application/json";
	const auto Ask = [&](const std::string& Method, const std::string& Path, const FHeaders& Headers)
	{
		FConnection Connection(Program->Port);
		Connection.Send(FLiveProgram::MakeRequest(Method, Path, Headers));
		return Connection.ReadAnswer().Status;
	};
	Typed["Content-Length"] = "1000001";
	EXPECT_EQ(413, Ask("POST", "/api/edit", Typed));
	for (const char* const Length : {"-1", "x", "99999999999999999999", "1 0"})
	{
		Typed["Content-Length"] = Length;
		EXPECT_EQ(400, Ask("POST", "/api/edit", Typed)) << Length;
	}
	Typed["Content-Length"] = "2";
	Typed["Content-Type"] = "text/plain";
	EXPECT_EQ(415, Ask("POST", "/api/edit", Typed));
	EXPECT_EQ(411, Ask("POST", "/api/edit", With("Transfer-Encoding", "chunked")));
	EXPECT_EQ(405, Ask("PUT", "/api/state", Program->MakeHeaders()));
	EXPECT_EQ(405, Ask("OPTIONS", "/api/state", Program->MakeHeaders()));
	EXPECT_EQ(405, Ask("DELETE", "/api/pin", Program->MakeHeaders()));
	EXPECT_EQ(414, Ask("GET", "/" + std::string(3000, 'a'), Program->MakeHeaders()));
	EXPECT_EQ(404, Ask("GET", "/api/nothing", Program->MakeHeaders()));
	EXPECT_EQ(404, Ask("GET", "/../../etc/passwd", Program->MakeHeaders()));
	EXPECT_EQ(404, Ask("GET", "/api/picture/..%2f..%2fetc%2fpasswd?kind=final8", Program->MakeHeaders()));
	EXPECT_EQ(422, Program->Ask("POST", "/api/edit", Program->MakeHeaders(), std::string(500000, '[')).Status);
	EXPECT_EQ(422, Program->Ask("POST", "/api/edit", Program->MakeHeaders(), "\"\xff\xfe\"").Status);
	// The library reads ranges by regular expressions: long ones, and what is none.
	std::string Ranges = "bytes=0-1";
	while (Ranges.size() < 8000)
	{
		Ranges += ",0-1";
	}
	for (const std::string& Range :
		{Ranges, std::string(8000, '1'), "bytes=" + std::string(8000, ' '), std::string("bytes=9-1")})
	{
		Ask("GET", "/api/state", With("Range", Range));
	}
	EXPECT_EQ(200, Ask("GET", "/api/state", With("Range", "bytes=0-1")));
	EXPECT_EQ(200, Ask("GET", "/api/state", With("Accept-Encoding", "gzip, br")));
	// Headers without an end are cut off.
	FConnection Endless(Program->Port);
	Endless.Send("GET / HTTP/1.1\r\n");
	const std::string Header = "X-A: " + std::string(1000, 'a') + "\r\n";
	int NumSent = 0;
	while (NumSent < 20000 && Endless.Send(Header))
	{
		++NumSent;
	}
	EXPECT_LT(NumSent, 20000);
	ExpectAlive();
}

TEST_F(LiveDoor, AThousandMalformedRequestsChangeNothing)
{
	std::mt19937 Random(11);
	const FJson Before = Program->WaitForFrame();
	const std::string Good = FLiveProgram::MakeRequest("POST", "/api/edit", Program->MakeHeaders(),
		R"({"edits": [{"set": "/camera/Settings/BloomIntensity", "value": "no number"}]})");
	for (int Number = 0; Number < 1000; ++Number)
	{
		std::string Bytes = Good;
		for (unsigned Edit = 0; Edit <= Random() % 8 && !Bytes.empty(); ++Edit)
		{
			const size_t At = Random() % Bytes.size();
			switch (Random() % 4)
			{
			case 0:
				Bytes[At] = static_cast<char>(Random());
				break;
			case 1:
				Bytes.erase(At, Random() % 20);
				break;
			case 2:
				Bytes.insert(At, Bytes.substr(Random() % Bytes.size(), Random() % 200));
				break;
			default:
				Bytes.resize(At + 1);
				break;
			}
		}
		FConnection Connection(Program->Port);
		ASSERT_TRUE(Connection.IsOpen()) << Number;
		Connection.Send(Bytes); // and goes away, at whatever place
	}
	ExpectAlive();
	EXPECT_EQ(Before["revision"], Program->State()["revision"]);
}

TEST_F(LiveDoor, HalfOpenConnectionsAreDropped)
{
	std::vector<std::unique_ptr<FConnection>> Silent;
	for (int Number = 0; Number < 40; ++Number)
	{
		Silent.push_back(std::make_unique<FConnection>(Program->Port));
		Silent.back()->Send(Number % 2 == 0 ? "GET /api/state HTTP/1.1\r\nHost: 127" : "");
	}
	ExpectAlive(); // beside them
	EXPECT_TRUE(Silent[0]->IsClosed());
	EXPECT_TRUE(Silent[1]->IsClosed());
}

TEST_F(LiveDoor, StreamsAreBoundedAndComeBack)
{
	std::vector<std::unique_ptr<FEventStream>> Streams;
	for (int Number = 0; Number < 16; ++Number)
	{
		Streams.push_back(std::make_unique<FEventStream>(*Program));
		EXPECT_EQ(200, Streams.back()->Status);
	}
	EXPECT_EQ(503, FEventStream(*Program).Status);
	ExpectAlive();
	Streams.clear();
	int Status = 503;
	for (int Try = 0; Try < 60 && Status == 503; ++Try)
	{
		std::this_thread::sleep_for(
			std::chrono::milliseconds(500)); // gone streams are noticed when they are written to
		Status = FEventStream(*Program).Status;
	}
	EXPECT_EQ(200, Status);
}
