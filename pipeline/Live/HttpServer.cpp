// Finds the module beside this library.
#include "Live/HttpServer.h"

#include "Diagnostics.h"
#include "Live/LiveErrors.h"

#include <dlfcn.h>
#include <filesystem>

namespace Drydock
{

namespace
{

FMakeHttpServer LoadHttpModule()
{
	Dl_info Own = {};
	dladdr(reinterpret_cast<const void*>(&LoadHttpModule), &Own);
	const std::filesystem::path File = std::filesystem::path(Own.dli_fname).parent_path() / "libdrydock_http.so";
	void* const Module = dlopen(File.c_str(), RTLD_NOW | RTLD_LOCAL);
	void* const Function = Module != nullptr ? dlsym(Module, MakeHttpServerName) : nullptr;
	if (Function == nullptr)
	{
		throw FError({.Code = ErrorNoServer,
						 .Message = std::string("the module that speaks HTTP cannot be loaded: ") + dlerror()},
			ExitFiles);
	}
	return reinterpret_cast<FMakeHttpServer>(Function);
}

} // namespace

std::unique_ptr<IHttpServer> StartHttpServer(int Port, const FHttpHandler& Handler)
{
	static const FMakeHttpServer Make = LoadHttpModule();
	std::string Fault;
	std::unique_ptr<IHttpServer> Server(Make(Port, Handler, Fault));
	if (Server == nullptr)
	{
		throw FError({.Code = ErrorNoServer, .Message = Fault, .Where = "--port"}, ExitFiles);
	}
	return Server;
}

} // namespace Drydock
