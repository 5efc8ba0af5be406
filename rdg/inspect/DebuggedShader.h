// A shader that a debugger like gdb can stop in: compiled with its lines and its variables, and run for one thread.
#pragma once

#include "DebugKernel.h"
#include "InspectedShader.h"
#include "TemporaryFolder.h"

#include <array>
#include <optional>

namespace Drydock
{

/** The results of a thread under the debugger. */
struct FDebuggedThread
{
	bool bDiscarded = false;
	std::vector<std::vector<double>> Targets; // by SV_Target: what was written, before the format rounds it
	/** The thread that the user asked for in the debugger, by DrydockDebugPixel. */
	std::optional<std::array<int32_t, 3>> Next;
};

class DRYDOCK_API FDebuggedShader
{
public:
	/** Runs the front end and the C++ compiler. Kernel: as of FInspectedShader. Throws FError: as FInspectedShader
	 * does, DD6020 too where the shader does something that a debugger cannot be given, DD603x of the compiler. */
	FDebuggedShader(const FShaderCompileRequest& Request, const FShaderReflection& Kernel);

	/** Runs one thread of Whole. Args are read and, where the shader writes to textures and buffers, written: give it a
	 * sandbox (Sandbox.h). Throws FSpirvError after MaxSteps instructions, and at a loop without end by the limit of
	 * Args; with bDebugged, the thread's own loops may go on. */
	FDebuggedThread Run(const FKernelArgs& Args, const FKernelTile& Whole, const std::array<int32_t, 3>& Position,
		uint64_t MaxSteps, bool bDebugged = false) const;

private:
	FInspectedShader Inspected;
	FTemporaryFolder Folder;
	FDebugKernelFunction Kernel = nullptr;
};

} // namespace Drydock
