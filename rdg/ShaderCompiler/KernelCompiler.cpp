// Calls the system's C++ compiler on generated kernels, and loads what comes out.
#include "KernelCompiler.h"

#include "ContentHash.h"
#include "Diagnostics.h"
#include "InstallPaths.h"
#include "CpuLanes.h"
#include "LanesDispatch.h"
#include "TimeLimit.h"
#include "ToolFault.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <sstream>
#include <sys/stat.h>
#include <unistd.h>

namespace Drydock
{

namespace
{

namespace fs = std::filesystem;

constexpr int DefaultTimeLimitSeconds = 300;
constexpr const char* HeaderName = "KernelSupport.h"; // the one that a kernel includes
constexpr const char* ThreadJumps = "-fthread-jumps"; // which clang does not know

std::vector<std::string> GetFlags(const FLaneConfig& Lanes)
{
	if (!AreLanesSupported(Lanes.bDouble, Lanes.Lanes))
	{
		throw FError(
			{ESeverity::Error, 6003,
				"shaders cannot run with " + std::to_string(Lanes.Lanes) + (Lanes.bDouble ? " double" : " float") +
					" lanes here; this CPU has up to " + std::to_string(GetCpuLanes() / (Lanes.bDouble ? 2 : 1)) +
					", and this build has code for " + GetBuiltLanes() + " float lanes (DRYDOCK_INSTRUCTION_SETS)",
				{}, 0, 0, {}},
			ExitUsage);
	}
	if (Lanes.WaveSize < 4 || Lanes.WaveSize > 64 || (Lanes.WaveSize & (Lanes.WaveSize - 1)))
	{
		throw FError({ESeverity::Error, 6003,
						 "waves cannot have " + std::to_string(Lanes.WaveSize) +
							 " threads (r.Drydock.WaveSize); they have 4, 8, 16, 32 or 64",
						 {}, 0, 0, {}},
			ExitUsage);
	}
	return Lanes;
}

std::string FindKernelCompiler()
{
	if (const char* Chosen = std::getenv("DRYDOCK_CXX"); Chosen && *Chosen)
	{
		return FindProgram(Chosen);
	}
	for (const char* Candidate : {DRYDOCK_CXX_COMPILER, "g++", "clang++", "c++"})
	{
		const std::string Found = FindProgram(Candidate);
		if (!Found.empty())
		{
			return Found;
		}
	}
	return {};
}

std::string GetCompilerId(const std::string& Compiler)
{
	struct stat Status;
	std::error_code Error;
	const fs::path Real = fs::canonical(Compiler, Error);
	if (Compiler.empty() || Error || stat(Real.c_str(), &Status) != 0)
	{
		return {};
	}
	FContentHash Hash;
	Hash.Add(Real.string());
	Hash.Add(std::to_string(Status.st_size));
	Hash.Add(std::to_string(Status.st_mtime));
	return Hash.Finish().substr(0, 12);
}

std::string GetKernelBuildIdentity(const FLaneConfig& Lanes)
{
	FContentHash Hash;
	Hash.Add(std::to_string(GShaderKernelVersion));
	Hash.Add(GetHeaderHash());
	for (const std::string& Flag : GetFlags(Lanes))
	{
		Hash.Add(Flag);
	}
	return Hash.Finish();
}

std::string PrecompileKernelHeaders(const FLaneConfig& Lanes)
{
	const std::vector<std::string> Includes = FindKernelIncludes();
	const std::string Compiler = FindKernelCompiler();
	if (Includes.empty() || Compiler.empty())
	{
		return {};
	}
	const FTemporaryFolder Folder;
	const std::string Output = Folder.Path + "/" + HeaderName + ".gch";
	std::vector<std::string> Arguments = GetCommand(Compiler, Includes, GetFlags(Lanes));
	Arguments.insert(Arguments.end(), {"-x", "c++-header", "-o", Output, Includes[0] + "/" + HeaderName});
	const int TimeLimitSeconds = GetTimeLimitSeconds("DRYDOCK_CXX_SECONDS", DefaultTimeLimitSeconds);
	if (!RunChild(Arguments, TimeLimitSeconds, MakeToolEnvironment(Folder.Path)).Succeeded())
	{
		return {};
	}
	const FFileDescriptor File(open(Output.c_str(), O_RDONLY | O_CLOEXEC));
	int Error = 0;
	std::string Bytes = ReadToEnd(File, Error);
	return Error == 0 ? Bytes : std::string();
}

namespace
{

std::string Compile(const std::string& Cpp, const FTemporaryFolder& Folder, const std::vector<std::string>& Flags,
	const FShaderCompileRequest& Request, const FFileDescriptor& Headers)
{
	const std::string Compiler = FindKernelCompiler();
	if (Compiler.empty())
	{
		throw MakeError(6031,
			"cannot compile '" + Request.EntryPoint + "': no C++ compiler was found; install g++ or set DRYDOCK_CXX",
			Request);
	}
	const std::vector<std::string> Includes = FindKernelIncludes();
	if (Includes.empty())
	{
		throw MakeError(6031,
			"cannot compile '" + Request.EntryPoint + "': the lane headers (Lanes.h) were not found beside the library",
			Request);
	}
	const std::string Output = Folder.Path + "/kernel.so";
	const std::string Input = Folder.WriteFile("kernel.cpp", Cpp);
	const int TimeLimitSeconds = GetTimeLimitSeconds("DRYDOCK_CXX_SECONDS", DefaultTimeLimitSeconds);
	std::vector<std::string> Arguments = GetCommand(Compiler, Includes, Flags);
	Arguments.insert(Arguments.end(), {"-o", Output, Input});
	const auto Run = [&]
	{
		return RunChild(Arguments, TimeLimitSeconds, MakeToolEnvironment(Folder.Path));
	};
	const std::string Link = OfferHeaders(Headers, Folder);
	FChildResult Child = Run();
	if (!Link.empty() && !Child.Succeeded() && !Child.bTimedOut) // damaged headers are no reason to fail
	{
		unlink(Link.c_str());
		Child = Run();
	}
	if (!Child.Succeeded())
	{
		throw ExplainFailure(Child, TimeLimitSeconds, Cpp, Folder, Request);
	}
	return Output;
}

} // namespace

std::string CompileKernel(const std::string& Cpp, const FTemporaryFolder& Folder, const FLaneConfig& Lanes,
	const FShaderCompileRequest& Request, const FFileDescriptor& Headers)
{
	return Compile(Cpp, Folder, GetFlags(Lanes), Request, Headers);
}

FDebugKernelFunction CompileDebugKernel(
	const std::string& Cpp, const FTemporaryFolder& Folder, const FShaderCompileRequest& Request)
{
	const std::string SharedObject = Compile(Cpp, Folder,
		{"-std=c++20", "-g", "-O0", "-fPIC", "-shared", "-fvisibility=hidden", "-fno-strict-aliasing", "-w"}, Request,
		{});
	void* const Handle = dlopen(SharedObject.c_str(), RTLD_NOW | RTLD_LOCAL);
	void* const Function = Handle ? dlsym(Handle, GDebugKernelName) : nullptr;
	if (!Function)
	{
		const char* const Reason = dlerror();
		throw MakeError(6034,
			"the kernel compiled for '" + Request.EntryPoint +
				"' cannot be loaded: " + (Reason ? Reason : SharedObject.c_str()),
			Request, ExitFiles);
	}
	return reinterpret_cast<FDebugKernelFunction>(Function);
}

FKernelFunction LoadKernel(const std::string& SharedObject, const FLaneConfig& Lanes, std::string& OutFault)
{
	// Kernels call into this library; it may have been opened without making its symbols visible to others.
	static std::once_flag Once;
	std::call_once(Once, [] { dlopen(GetLibraryPath().c_str(), RTLD_NOW | RTLD_NOLOAD | RTLD_GLOBAL); });
	void* const Handle = dlopen(SharedObject.c_str(), RTLD_NOW | RTLD_LOCAL);
	if (!Handle)
	{
		const char* const Reason = dlerror();
		OutFault = Reason ? Reason : SharedObject;
		return nullptr;
	}
	const auto* const Module = static_cast<const FKernelModule*>(dlsym(Handle, "DrydockShaderKernel"));
	const bool bFits = Module && Module->Version == GShaderKernelVersion && Module->Lanes == uint32_t(Lanes.Lanes) &&
					   Module->RealSize == (Lanes.bDouble ? sizeof(double) : sizeof(float));
	if (!bFits)
	{
		OutFault = SharedObject + " is no kernel of this kind";
		dlclose(Handle);
		return nullptr;
	}
	return Module->Run;
}

} // namespace Drydock
