// Calls the system's C++ compiler on generated kernels, and loads what comes out.
#include "KernelCompiler.h"

#include "ContentHash.h"
#include "Diagnostics.h"
#include "InstallPaths.h"
#include "RegularFile.h"
#include "TextTools.h"
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
	const int32_t FloatLanes = Lanes.bDouble ? Lanes.Lanes * 2 : Lanes.Lanes;
	const char* const Level = FloatLanes >= 16 ? "4" : FloatLanes >= 8 ? "3" : "2";
	// -O1 with the two passes that its loops lack: as fast kernels as by -O2, in four fifths of the compiler's time.
	std::vector<std::string> Flags = {"-std=c++20", "-O1", "-ftree-vrp", ThreadJumps, "-fPIC", "-shared",
		"-fvisibility=hidden", "-ffp-contract=off", "-fno-math-errno", "-fwrapv", "-fno-exceptions", "-fno-rtti", "-w",
		"-fasynchronous-unwind-tables", // what ends an endless loop is thrown through a kernel
		"-nostdlib", // what a kernel calls is in the process; without its libraries the linker takes a third of the
					 // time
		std::string("-DDRYDOCK_REAL=") + (Lanes.bDouble ? "double" : "float"),
		"-DDRYDOCK_LANES=" + std::to_string(Lanes.Lanes)};
#if defined(__x86_64__)
	Flags.push_back(std::string("-march=x86-64-v") + Level);
#else
	(void)Level;
#endif
	return Flags;
}

std::vector<std::string> GetCommand(
	const std::string& Compiler, const std::vector<std::string>& Folders, const std::vector<std::string>& Flags)
{
	std::error_code Error;
	const fs::path Program = fs::canonical(Compiler, Error);
	std::vector<std::string> Arguments = Flags;
	if (Program.filename().string().starts_with("clang"))
	{
		std::erase(Arguments, ThreadJumps);
	}
	Arguments.insert(Arguments.begin(), Compiler);
	for (const std::string& Folder : Folders)
	{
		Arguments.push_back("-I" + Folder);
	}
	return Arguments;
}

/** Puts the precompiled headers where g++ looks first, beside the kernel: a link to the very file that is open here, or
 * nothing where there is none. The link's path. */
std::string OfferHeaders(const FFileDescriptor& Headers, const FTemporaryFolder& Folder)
{
	const std::string Link = Folder.Reserve(std::string(HeaderName) + ".gch");
	const std::string Opened = "/proc/" + std::to_string(getpid()) + "/fd/" + std::to_string(Headers.Get());
	return Headers && symlink(Opened.c_str(), Link.c_str()) == 0 ? Link : std::string();
}

const std::string& GetHeaderHash()
{
	static const std::string Result = []
	{
		FContentHash Hash;
		for (const std::string& Folder : FindKernelIncludes())
		{
			std::vector<std::string> Names;
			std::error_code Error;
			for (fs::directory_iterator It(Folder, Error), End; !Error && It != End; It.increment(Error))
			{
				const std::string Name = It->path().filename().string();
				const bool bLanes = Name.starts_with("Lanes") && It->path().extension() == ".h";
				if (bLanes || Name == HeaderName || Name == "ShaderKernel.h")
				{
					Names.push_back(It->path().string());
				}
			}
			std::sort(Names.begin(), Names.end());
			for (const std::string& Name : Names)
			{
				std::ifstream Stream(Name, std::ios::binary);
				Hash.Add(fs::path(Name).filename().string());
				Hash.Add(std::string((std::istreambuf_iterator<char>(Stream)), {}));
			}
		}
		return Hash.Finish();
	}();
	return Result;
}

FError MakeError(
	int Code, const std::string& Message, const FShaderCompileRequest& Request, EExitCode ExitCode = ExitUsage)
{
	return FError({ESeverity::Error, Code, Message, Request.VirtualPath, 0, 0, {}}, ExitCode);
}

/** Keeps the generated text for the report of a fault that is ours. The result is its path, as a message has it. */
std::string KeepKernel(const std::string& Cpp)
{
	const std::string Suffix = ".cpp";
	std::string Path = GetTemporaryParent() + "/drydock-failed-XXXXXX" + Suffix;
	FFileDescriptor File(mkostemps(Path.data(), int(Suffix.size()), O_CLOEXEC)); // made anew, 0600
	const bool bMade = bool(File);
	const int Error = bMade ? WriteAndClose(std::move(File), Cpp) : errno;
	if (Error == 0)
	{
		return "the code is in " + Path;
	}
	if (bMade)
	{
		unlink(Path.c_str());
	}
	return "the code cannot be kept in " + GetTemporaryParent() + ": " + DescribeSystemError(Error);
}

/** The first line of the compiler that names an error. */
std::string FindErrorLine(const std::string& Output)
{
	for (const std::string& Line : SplitText(Output))
	{
		if (Line.find("error") != std::string::npos)
		{
			return ": " + Line;
		}
	}
	return {};
}

/** Why the compiler gave no kernel: it was kept from its work, takes too long, or the code is wrong. */
FError ExplainFailure(const FChildResult& Child, int TimeLimitSeconds, const std::string& Cpp,
	const FTemporaryFolder& Folder, const FShaderCompileRequest& Request)
{
	const std::string OnWhat = " on the code generated for '" + Request.EntryPoint + "'";
	const std::string Fault = FindToolFault(Child);
	if (!Fault.empty())
	{
		return MakeError(6032, "the C++ compiler " + Fault + OnWhat, Request, ExitFiles);
	}
	Folder.CheckSpace();
	if (Child.bTimedOut)
	{
		return MakeError(6033,
			"the C++ compiler " + Child.Describe(TimeLimitSeconds) + OnWhat +
				" and was ended: is so much of it unrolled or inlined? (DRYDOCK_CXX_SECONDS)",
			Request);
	}
	return MakeError(6030,
		"the C++ compiler " + Child.Describe(TimeLimitSeconds) + OnWhat + ", which is a fault of drydock (" +
			KeepKernel(Cpp) + ")" + FindErrorLine(Child.Output),
		Request, ExitInternal);
}

} // namespace

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
	const std::string Output = Folder.Reserve(std::string(HeaderName) + ".gch");
	std::vector<std::string> Arguments = GetCommand(Compiler, Includes, GetFlags(Lanes));
	Arguments.insert(Arguments.end(), {"-x", "c++-header", "-o", Output, Includes[0] + "/" + HeaderName});
	const int TimeLimitSeconds = GetTimeLimitSeconds("DRYDOCK_CXX_SECONDS", DefaultTimeLimitSeconds);
	if (!RunChild(Arguments, TimeLimitSeconds, MakeToolEnvironment(Folder)).Succeeded())
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
	const std::string Output = Folder.Reserve("kernel.so");
	const std::string Input = Folder.WriteFile("kernel.cpp", Cpp);
	const int TimeLimitSeconds = GetTimeLimitSeconds("DRYDOCK_CXX_SECONDS", DefaultTimeLimitSeconds);
	std::vector<std::string> Arguments = GetCommand(Compiler, Includes, Flags);
	Arguments.insert(Arguments.end(), {"-o", Output, Input});
	const auto Run = [&]
	{
		return RunChild(Arguments, TimeLimitSeconds, MakeToolEnvironment(Folder));
	};
	const std::string Link = OfferHeaders(Headers, Folder);
	FChildResult Child = Run();
	if (!Link.empty() && !Child.Succeeded() && !Child.bTimedOut) // damaged headers must not fail a kernel
	{
		unlink(Link.c_str());
		Child = Run();
	}
	if (!Child.Succeeded())
	{
		throw ExplainFailure(Child, TimeLimitSeconds, Cpp, Folder, Request);
	}
	const FRegularFile Written(Output);
	if (!Written.GetProblem().empty() || Written.GetSize() == 0)
	{
		Folder.CheckSpace();
		throw MakeError(6031,
			"cannot compile '" + Request.EntryPoint + "': " + Compiler +
				" ended well and wrote no kernel; is it a C++ compiler?",
			Request);
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
		OutFault = SharedObject + " is not a kernel of this kind";
		dlclose(Handle);
		return nullptr;
	}
	return Module->Run;
}

} // namespace Drydock
