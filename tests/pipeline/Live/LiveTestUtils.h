// The program `drydock live` under test, and a page that asks it: HTTP over a plain socket.
#pragma once

#include <gtest/gtest.h>

#include "../ProgramTestUtils.h"
#include "LiveConnection.h"

#include <csignal>
#include <fcntl.h>
#include <sys/prctl.h>
#include <thread>
#include <vector>

namespace LiveTest
{

using namespace ProgramTest;
/** `drydock live` in a folder of its own, until it is ended. */
class FLiveProgram
{
public:
	FLiveProgram(const Files::path& InFolder, const std::vector<std::string>& Arguments, bool bOpen = false)
		: Folder(InFolder)
	{
		int Pipe[2] = {-1, -1};
		EXPECT_EQ(0, pipe2(Pipe, O_CLOEXEC));
		std::vector<std::string> All = {DRYDOCK_TEST_BINARY_DIR "/bin/drydock", "live"};
		All.insert(All.end(), bOpen ? 0 : 1, "--no-open");
		All.insert(All.end(), Arguments.begin(), Arguments.end());
		std::vector<char*> Pointers;
		for (std::string& Argument : All)
		{
			Pointers.push_back(Argument.data());
		}
		Pointers.push_back(nullptr);
		Child = fork();
		if (Child == 0)
		{
			prctl(PR_SET_PDEATHSIG, SIGTERM); // nothing stays where the test is killed
			dup2(Pipe[1], STDOUT_FILENO);
			const int Log = open((Folder / "log.txt").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
			dup2(Log, STDERR_FILENO);
			if (chdir(Folder.c_str()) == 0)
			{
				execv(Pointers[0], Pointers.data());
			}
			_exit(127);
		}
		close(Pipe[1]);
		std::string Line;
		for (char C = 0; read(Pipe[0], &C, 1) == 1 && C != '\n';)
		{
			Line += C;
		}
		close(Pipe[0]);
		const size_t Colon = Line.find("127.0.0.1:");
		const size_t Equals = Line.find("/?token=");
		EXPECT_TRUE(Colon != std::string::npos && Equals != std::string::npos) << Line << ReadLog();
		if (Equals != std::string::npos)
		{
			Port = std::stoi(Line.substr(Colon + 10));
			Token = Line.substr(Equals + 8);
		}
	}

	~FLiveProgram()
	{
		if (Child > 0)
		{
			kill(Child, SIGTERM); // it waits for the process that it keeps
			WaitForEnd();
		}
	}

	std::string ReadLog() const
	{
		std::ifstream Stream(Folder / "log.txt", std::ios::binary);
		return std::string(std::istreambuf_iterator<char>(Stream), {});
	}

	/** Its exit code; -1 where a signal ended it. */
	int WaitForEnd()
	{
		int Status = 0;
		waitpid(Child, &Status, 0);
		Child = -1;
		return WIFEXITED(Status) ? WEXITSTATUS(Status) : -1;
	}

	void Signal(int Number) const { kill(Child, Number); }

	FHeaders MakeHeaders() const { return {{"Host", "127.0.0.1:" + std::to_string(Port)}, {"X-Drydock-Token", Token}}; }

	static std::string MakeRequest(
		const std::string& Method, const std::string& Path, FHeaders Headers, const std::string& Body = "")
	{
		if (!Body.empty())
		{
			Headers.insert({{"Content-Type", "application/json"}, {"Content-Length", std::to_string(Body.size())}});
		}
		std::string Request = Method + " " + Path + " HTTP/1.1\r\n";
		for (const auto& [Name, Value] : Headers)
		{
			Request += Name + ": " + Value + "\r\n";
		}
		return Request + "\r\n" + Body;
	}

	FAnswer Ask(
		const std::string& Method, const std::string& Path, const FHeaders& Headers, const std::string& Body = "") const
	{
		FConnection Connection(Port);
		Connection.Send(MakeRequest(Method, Path, Headers, Body));
		return Connection.ReadAnswer();
	}

	FAnswer Get(const std::string& Path) const { return Ask("GET", Path, MakeHeaders()); }
	FAnswer Post(const std::string& Path, const FJson& Body = FJson()) const
	{
		return Ask("POST", Path, MakeHeaders(), Body.is_null() ? "" : Body.dump());
	}

	FJson State() const { return Get("/api/state").Json(); }

	FAnswer Edit(const std::string& Place, const FJson& Value, const std::string& Drag = "") const
	{
		FJson Body = {{"edits", {{{"set", Place}, {"value", Value}}}}};
		if (!Drag.empty())
		{
			Body["drag"] = Drag;
		}
		return Post("/api/edit", Body);
	}

	/** undo, redo or reset. */
	FAnswer Change(const char* Name, const FJson& Value = true) const { return Post("/api/edit", {{Name, Value}}); }

	/** The state's frame, once it is there; a fault of the state ends the wait. A fault stays until the next frame is
	 * there, so that only its revision says which state it is of. */
	FJson WaitForFrame() const
	{
		for (int Try = 0; Try < 6000; ++Try)
		{
			const FJson Now = State();
			const auto IsOfNow = [&](const char* Member)
			{
				return !Now[Member].is_null() && Now[Member]["revision"] == Now["revision"];
			};
			if (IsOfNow("fault") || IsOfNow("frame"))
			{
				return Now;
			}
			std::this_thread::sleep_for(std::chrono::milliseconds(10));
		}
		ADD_FAILURE() << "no frame";
		return FJson();
	}

	int Port = 0;
	std::string Token;

private:
	const Files::path Folder;
	pid_t Child = -1;
};

/** Events of the program, as they come. */
class FEventStream
{
public:
	explicit FEventStream(const FLiveProgram& Program)
		: Connection(Program.Port)
	{
		FHeaders Headers = Program.MakeHeaders();
		Headers.erase("X-Drydock-Token");
		Connection.Send(FLiveProgram::MakeRequest("GET", "/api/events?token=" + Program.Token, Headers));
		Status = Connection.ReadAnswer().Status;
	}

	/** The next event of this name, and its data; null where the stream ends. */
	FJson WaitFor(const std::string& Name)
	{
		const std::string Begin = "event: " + Name + "\n";
		while (true)
		{
			const std::string Message = ReadMessage();
			if (Message.empty())
			{
				return FJson();
			}
			if (!Message.starts_with(Begin))
			{
				continue;
			}
			std::string Data;
			for (size_t At = Begin.size(); Message.compare(At, 6, "data: ") == 0;)
			{
				const size_t End = Message.find('\n', At);
				Data += Message.substr(At + 6, End - At - 5);
				At = End + 1;
			}
			return FJson::parse(Data);
		}
	}

	FConnection Connection;
	int Status = 0;

private:
	/** Up to an empty line. The stream comes in chunks, a length before each. */
	std::string ReadMessage()
	{
		while (Text.find("\n\n") == std::string::npos)
		{
			const std::string Length = Connection.ReadUntil("\r\n");
			const size_t Count = Length.empty() ? 0 : std::stoul(Length, nullptr, 16);
			if (Count == 0)
			{
				return "";
			}
			Text += Connection.ReadBytes(Count);
			Connection.ReadBytes(2);
		}
		const size_t End = Text.find("\n\n") + 2;
		const std::string Message = Text.substr(0, End);
		Text.erase(0, End);
		return Message;
	}

	std::string Text;
};

} // namespace LiveTest
