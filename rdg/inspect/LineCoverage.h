// Counts the threads of a draw or dispatch that ran each line of a shader.
#pragma once

#include "ThreadRuns.h"

#include <map>

namespace Drydock
{

struct FLineCount
{
	uint64_t Threads = 0; // that ran it at least once
	std::string Source;   // trimmed
};

struct FLineCoverage
{
	uint64_t Threads = 0;                                   // that ran at all
	std::map<std::string, std::map<int, FLineCount>> Files; // virtual path, line: those with instructions
};

/** All lines that the shader was made of instructions for, including its headers'. */
DRYDOCK_API FLineCoverage CollectLineCoverage(
	FInspectedShader& Shader, const FBoundShader& Bound, const FKernelArgs& Args, const FKernelTile& Whole);

/** Sums up passes that share files. */
DRYDOCK_API void AddCoverage(FLineCoverage& Sum, const FLineCoverage& Other);

} // namespace Drydock
