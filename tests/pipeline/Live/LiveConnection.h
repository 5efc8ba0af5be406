// HTTP over a plain socket, as a page asks `drydock live`.
#pragma once

#include <algorithm>
#include <arpa/inet.h>
#include <cctype>
#include <chrono>
#include <map>
#include <netinet/in.h>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <unistd.h>

namespace LiveTest
{

using FJson = nlohmann::json;
using FHeaders = std::map<std::string, std::string>;

/** An answer; Status 0: there was none. */
struct FAnswer
{
	int Status = 0;
	FHeaders Headers; // by small letters
	std::string Body;

	FJson Json() const { return FJson::parse(Body, nullptr, false); }
	std::string Code() const { return Json()["messages"][0]["code"]; }
};

/** A connection to a port of this machine. */
class FConnection
{
public:
	explicit FConnection(int Port)
		: Socket(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
	{
		sockaddr_in Address = {};
		Address.sin_family = AF_INET;
		Address.sin_port = htons(static_cast<uint16_t>(Port));
		Address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
		bOpen = connect(Socket, reinterpret_cast<sockaddr*>(&Address), sizeof(Address)) == 0;
	}
	~FConnection() { close(Socket); }
	FConnection(const FConnection&) = delete;
	FConnection& operator=(const FConnection&) = delete;

	bool IsOpen() const { return bOpen; }

	bool Send(const std::string& Bytes) const
	{
		for (size_t Sent = 0; Sent < Bytes.size();)
		{
			const ssize_t Count = send(Socket, Bytes.data() + Sent, Bytes.size() - Sent, MSG_NOSIGNAL);
			if (Count <= 0)
			{
				return false;
			}
			Sent += static_cast<size_t>(Count);
		}
		return true;
	}

	/** Reads on until End is in what was read, or nothing comes. Returns all up to its end. */
	std::string ReadUntil(const std::string& End)
	{
		for (size_t At; (At = Buffer.find(End)) == std::string::npos;)
		{
			if (!ReadMore())
			{
				return "";
			}
		}
		return Take(Buffer.find(End) + End.size());
	}

	std::string ReadBytes(size_t Count)
	{
		while (Buffer.size() < Count && ReadMore())
		{
		}
		return Take(std::min(Count, Buffer.size()));
	}

	FAnswer ReadAnswer()
	{
		FAnswer Answer;
		const std::string Head = ReadUntil("\r\n\r\n");
		if (!Head.starts_with("HTTP/1.1 "))
		{
			return Answer;
		}
		Answer.Status = std::stoi(Head.substr(9, 3));
		for (size_t At = Head.find("\r\n") + 2; At + 2 < Head.size(); At = Head.find("\r\n", At) + 2)
		{
			const size_t Colon = Head.find(": ", At);
			std::string Name = Head.substr(At, Colon - At);
			std::ranges::transform(Name, Name.begin(), [](unsigned char C) { return std::tolower(C); });
			Answer.Headers[Name] = Head.substr(Colon + 2, Head.find("\r\n", At) - Colon - 2);
		}
		if (Answer.Headers.count("content-length") > 0)
		{
			Answer.Body = ReadBytes(std::stoul(Answer.Headers["content-length"]));
		}
		return Answer;
	}

	/** Whether the other side has closed it; waits for that. */
	bool IsClosed()
	{
		while (ReadMore())
		{
		}
		return bClosed;
	}

	std::chrono::milliseconds Patience{60000}; // with which something is waited for

private:
	bool ReadMore()
	{
		pollfd Waiting = {Socket, POLLIN, 0};
		char Bytes[65536];
		if (poll(&Waiting, 1, static_cast<int>(Patience.count())) <= 0)
		{
			return false;
		}
		const ssize_t Count = recv(Socket, Bytes, sizeof(Bytes), 0);
		bClosed = Count <= 0;
		Buffer.append(Bytes, Count > 0 ? static_cast<size_t>(Count) : 0);
		return Count > 0;
	}

	std::string Take(size_t Count)
	{
		const std::string Taken = Buffer.substr(0, Count);
		Buffer.erase(0, Count);
		return Taken;
	}

	const int Socket;
	bool bOpen = false;
	bool bClosed = false;
	std::string Buffer;
};

} // namespace LiveTest
