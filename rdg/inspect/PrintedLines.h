// Collects what the threads of a shader print: DrydockPrint, and the engine's ShaderPrint.
#pragma once

#include "ThreadRuns.h"

namespace Drydock
{

struct FPrintedLine
{
	std::array<int32_t, 3> At{}; // pixel or dispatch id
	std::string File;            // virtual
	int Line = 0;
	std::string Text;
};

struct FPrintedLines
{
	std::vector<FPrintedLine> Lines; // by thread (x, then y, then z), of each in its own order
	uint64_t NumMore = 0;            // that were left out
};

constexpr size_t MaxPrintedLines = 1000;

/** Whether the shader prints anything at all. */
DRYDOCK_API bool DoesPrint(const FInspectedShader& Shader);

/** Runs the threads and keeps the first MaxPrintedLines. Texts of ShaderPrint are one line up to its Newline. */
DRYDOCK_API FPrintedLines CollectPrints(FInspectedShader& Shader, const FBoundShader& Bound, const FKernelArgs& Args,
	std::vector<std::array<int32_t, 3>> Threads);

/** A value as a shader hands it over. */
struct FPrintedValue
{
	std::vector<double> Numbers;
	ESpirvType Kind = ESpirvType::Float; // of each
};

/** printf's conversions, each for the next value whatever its size: "%f at %d". Precision and %x are heeded. Values
 * without a conversion follow, separated by blanks. */
DRYDOCK_API std::string FormatPrinted(const std::string& Format, const std::vector<FPrintedValue>& Values);

} // namespace Drydock
