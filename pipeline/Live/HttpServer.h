// HTTP on the loopback address, for `drydock live`. The library that speaks it lies in a module of its own, which is
// loaded when the first server starts.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace Drydock
{

struct FHttpRequest
{
	std::string Method;
	std::string Path;                           // decoded, without the query
	std::map<std::string, std::string> Query;   // decoded; of equal names the first
	std::map<std::string, std::string> Headers; // by names in small letters; of equal names the first
	std::string Body;
};

struct FHttpResponse
{
	int Status = 200;
	std::string Type = "application/json";
	std::map<std::string, std::string> Headers = {};
	std::string Body = {};
	/** In place of Body: bytes that others hold, too. */
	std::shared_ptr<const std::string> Shared = {};
	/** A response without an end: gives its next part, and false at its end. Empty: Body is all. */
	std::function<bool(std::string& OutPart)> Next = {};
};

/** Called by many threads at the same time. */
using FHttpHandler = std::function<FHttpResponse(const FHttpRequest& Request)>;

/** Limits by which requests are refused: bytes of a body, bytes of a request with its headers, connections. */
constexpr size_t MaxHttpBody = 1'000'000;
constexpr size_t MaxHttpRequest = 1'100'000;
constexpr size_t MaxHttpConnections = 64;

class IHttpServer
{
public:
	/** Ends it: no handler runs any more. */
	virtual ~IHttpServer() = default;

	virtual int GetPort() const = 0;
};

/** Port: 0 takes a free one. Throws FError (exit code 3) where the module cannot be loaded or the port not be had. */
std::unique_ptr<IHttpServer> StartHttpServer(int Port, const FHttpHandler& Handler);

/** The module's function. Null: OutFault gives the reason. */
using FMakeHttpServer = IHttpServer* (*)(int Port, const FHttpHandler& Handler, std::string& OutFault);
inline constexpr const char* MakeHttpServerName = "DrydockMakeHttpServer";

} // namespace Drydock
