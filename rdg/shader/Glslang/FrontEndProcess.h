// glslang in a process of its own, kept for all shaders of a run: a crash or an endless loop of its parser ends that
// process alone, and the next shader gets a new one.
#pragma once

#include "ChildProcess.h"
#include "ShaderCompileRequest.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

/** The program, libexec/drydock/drydock_front_end of the installation or the build; empty where it is not there. */
std::string FindFrontEndProgram();

struct FFrontEndReply
{
	FChildResult Child; // as of a child that compiled this text alone
	std::vector<uint32_t> Words;
};

/** Compiles Text in the process of Program. Threads take turns. */
FFrontEndReply AskFrontEnd(
	const std::string& Program, const std::string& Text, const FShaderCompileRequest& Request, int TimeLimitSeconds);

struct FFrontEndCounts
{
	int64_t Shaders = 0;   // asked of it
	int64_t Processes = 0; // started
};

/** The counts of this process so far. */
DRYDOCK_API FFrontEndCounts GetFrontEndCounts();

} // namespace Drydock
