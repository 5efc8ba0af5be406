// The system compiler as the last stage of the shader tier: generated C++ to a shared object.
#pragma once

#include "DebugKernel.h"
#include "ShaderCompileRequest.h"
#include "TemporaryFolder.h"

namespace Drydock
{

/** DRYDOCK_CXX, else the compiler that built the library, else g++, clang++ or c++; empty when none is there. */
std::string FindKernelCompiler();

/** Name of a compiler as part of a cache entry: changes when the program does. Empty for an empty path. */
std::string GetCompilerId(const std::string& Compiler);

/** Everything besides the source that decides what a kernel does: flags, lane headers, interface and emitter versions.
 */
std::string GetKernelBuildIdentity(const FLaneConfig& Lanes);

/** The lane headers as g++ keeps what it has read: reading them is most of what a small kernel costs. Good for kernels
 * of the same compiler and GetKernelBuildIdentity. Empty where they could not be made. */
std::string PrecompileKernelHeaders(const FLaneConfig& Lanes);

/** Compiles Cpp into Folder/kernel.so and returns that path. Headers: the file of what PrecompileKernelHeaders gave, or
 * none; one that the compiler does not take is as good as none. Throws FError: DD6031 no compiler; DD6030 it found an
 * error (exit code 70: the text is ours); DD6032 it was killed or ran out of memory or disk (exit code 3); DD6033 it
 * took longer than DRYDOCK_CXX_SECONDS, 300 by default; DD5004 the folder cannot be written (exit code 3). */
std::string CompileKernel(const std::string& Cpp, const FTemporaryFolder& Folder, const FLaneConfig& Lanes,
	const FShaderCompileRequest& Request, const FFileDescriptor& Headers);

/** Compiles Cpp for a debugger and loads it, for good. Folder has to stay as long as the kernel may be debugged. Throws
 * FError as CompileKernel does, and DD6034 where it cannot be loaded. */
FDebugKernelFunction CompileDebugKernel(
	const std::string& Cpp, const FTemporaryFolder& Folder, const FShaderCompileRequest& Request);

/** Loads a kernel and checks that it is what was asked for; null when it is not; OutFault is the reason. The kernel
 * stays loaded.
 * */
FKernelFunction LoadKernel(const std::string& SharedObject, const FLaneConfig& Lanes, std::string& OutFault);

} // namespace Drydock
