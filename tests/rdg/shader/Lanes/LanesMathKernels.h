// Lane intrinsics as plain functions over arrays, one set per instruction set, so that tests can compare them with each
// other and with the C library.
#pragma once

#include <cstdint>

namespace Drydock::Tests
{

/** Out[i] = f(A[i], B[i]) for 16 * k values; unary functions ignore B. */
template<typename Real>
using TArrayFunction = void (*)(const Real* A, const Real* B, Real* Out, int Count);

/** Bits in, bits out. */
using FBitsFunction = void (*)(const uint32_t* A, const uint32_t* B, uint32_t* Out, int Count);

template<typename F>
struct TKernelTable
{
	struct FEntry
	{
		const char* Name;
		F Function;
	};
	const FEntry* Entries;
	int Count;

	/** Null when there is none. */
	F Find(const char* Name) const
	{
		for (const FEntry& Entry : *this)
		{
			if (__builtin_strcmp(Entry.Name, Name) == 0)
			{
				return Entry.Function;
			}
		}
		return nullptr;
	}
	const FEntry* begin() const { return Entries; }
	const FEntry* end() const { return Entries + Count; }
};

/** Plain arrays: code of the standard library must not be made in the files for newer instruction sets. */
struct FMathKernels
{
	TKernelTable<TArrayFunction<float>> Float;
	TKernelTable<TArrayFunction<double>> Double;
	TKernelTable<FBitsFunction> Bits;
};

/** Uniform scalars, and lanes of the three instruction sets: float 4, 8, 16, double 2, 4, 8. */
const FMathKernels& GetMathKernelsUniform();
const FMathKernels& GetMathKernelsSse();
const FMathKernels& GetMathKernelsAvx2();
const FMathKernels& GetMathKernelsAvx512();

} // namespace Drydock::Tests
