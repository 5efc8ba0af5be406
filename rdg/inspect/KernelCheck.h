// Finds faults inside a shader: their lines, threads and pixels. A fault is a line that makes NaN or infinity from
// numbers, whose value a format cannot hold, that reaches outside, reads what nothing wrote, or races (ECheck).
#pragma once

#include "InspectedShader.h"
#include "Sandbox.h"

#include <array>
#include <string>

namespace Drydock
{

enum class ECheck : uint8_t
{
	NonFinite,     // an operation whose operands are finite gives NaN or infinity
	Overflow,      // a finite value is stored that the format holds as infinity
	Negative,      // a colour below 0 is stored to a format that keeps it
	Denormal,      // a value is stored that a float of the format holds with fewer bits
	Bounds,        // a texture, buffer or array is read or written outside, or sampled at a level that it lacks
	Uninitialized, // a variable is used before it is written
	Overlap,       // threads store different values to one texel or element
	Assertion,     // DrydockAssert of what is not so
	Race,          // threads of a group touch groupshared memory, one writes, and no barrier is between
	Count
};

/** "nan", "overflow", "negative", "denormal", "bounds", "uninit", "overlap", "assert", "race" */
DRYDOCK_API const char* GetCheckName(ECheck Check);

struct FCheckSet
{
	std::array<bool, size_t(ECheck::Count)> bOn{};

	bool operator[](ECheck Check) const { return bOn[size_t(Check)]; }
	/** Whether all threads have to be examined, because stored texels do not show the faults in question. */
	bool NeedsEveryThread() const
	{
		return (*this)[ECheck::Bounds] || (*this)[ECheck::Uninitialized] || (*this)[ECheck::Overlap] ||
			   (*this)[ECheck::Assertion] || (*this)[ECheck::Race];
	}
};

/** One kind of fault at one line of a shader. */
struct FCheckFinding
{
	ECheck Check = ECheck::NonFinite;
	std::string File; // virtual; empty: not known
	int Line = 0;
	std::string Function;
	std::string Source;                         // the line, trimmed
	std::string What;                           // "0 / 0 is NaN"
	int32_t First[3] = {};                      // of the threads, in the order of rows
	uint64_t Threads = 0;                       // that this happens to
	std::vector<std::array<int32_t, 2>> Pixels; // the first MaxCheckPixels of them
};

constexpr size_t MaxCheckPixels = 1u << 20;

/** Runs threads of a dispatch by the interpreter, on all cores, and collects what they do wrong: one finding for each
 * kind and line, those of the earliest thread first. Threads: empty: all of Whole. TargetStorage: formats of the render
 * targets. Same result for any number of cores. */
DRYDOCK_API std::vector<FCheckFinding> CheckThreads(FInspectedShader& Shader, const FBoundShader& Bound,
	const FKernelArgs& Args, const FKernelTile& Whole, const std::vector<std::array<int32_t, 3>>& Threads,
	const FCheckSet& Checks);

} // namespace Drydock
