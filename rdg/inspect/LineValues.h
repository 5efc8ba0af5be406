// Collects the value that a line of a shader computes, for every thread of a draw or dispatch, as a picture.
#pragma once

#include "ThreadRuns.h"

#include <optional>

namespace Drydock
{

/** A line as a user types it: "Bloom.usf:41" or "Bloom.usf:41:Weight". */
struct FLinePlace
{
	std::string File; // a virtual path, or the end of one
	int Line = 0;
	std::string Variable; // empty: what the line stores last, or returns
};

/** Throws FError (DD1020) where the text is none. */
DRYDOCK_API FLinePlace ParseLinePlace(const std::string& Text);

/** Rows of the dispatch's threads; slices of a volume one below the other. */
struct FLineValues
{
	std::string File; // virtual
	std::string Variable;
	std::string Source; // the line, trimmed
	int32_t Width = 0;
	int32_t Height = 0;
	int NumChannels = 0;           // 1 to 4: the first ones of what holds more numbers
	uint32_t NumNumbers = 0;       // that the variable has
	std::vector<float> Values;     // channels interleaved; 0 where the line did not run
	std::vector<uint8_t> bReached; // by thread: 1 where the line ran
};

/** The numbers that a line of a shader gives a variable, in all threads that were looked at. */
struct FLineRange
{
	std::string File; // virtual
	int Line = 0;
	std::string Variable;
	std::string Source; // the line, trimmed
	double Least = 0;   // of all its numbers, what is finite
	double Most = 0;
	uint64_t NotFinite = 0;
	uint64_t Times = 0; // that the line gave it
};

/** Every variable that a line of the shader stores, returns or writes to a texture or buffer, by file and line. Files
 * under /Engine/Public and headers of /Engine are left out. Threads: of Whole; empty: all. */
DRYDOCK_API std::vector<FLineRange> CollectLineRanges(FInspectedShader& Shader, const FBoundShader& Bound,
	const FKernelArgs& Args, const FKernelTile& Whole, const std::vector<std::array<int32_t, 3>>& Threads);

/** Whether a virtual path is the file that a user names. */
DRYDOCK_API bool IsFileNamed(const std::string& Path, const std::string& Name);

/** The value that the line gives, or that the variable has there; in a loop, the value of the last round. Nothing if
 * this shader is not made of the file. Nothing if it has no value there: Problem then gives the reason, with the
 * nearest lines that give a value, or the names of variables. */
DRYDOCK_API std::optional<FLineValues> CollectLineValues(FInspectedShader& Shader, const FBoundShader& Bound,
	const FKernelArgs& Args, const FKernelTile& Whole, const FLinePlace& Place, std::string& Problem);

} // namespace Drydock
