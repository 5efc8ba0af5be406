// Lane intrinsics as plain functions over arrays, one set per instruction set, so that tests can compare them with each
// other and with the C library. Source: drydock.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace Drydock::Tests
{

/** Out[i] = f(A[i], B[i]) for 16 * k values; unary functions ignore B. */
template <typename Real>
using TArrayFunction = void (*)(const Real* A, const Real* B, Real* Out, int Count);

/** Bits in, bits out. */
using FBitsFunction = void (*)(const uint32_t* A, const uint32_t* B, uint32_t* Out, int Count);

struct FMathKernels
{
	std::map<std::string, TArrayFunction<float>> Float;
	std::map<std::string, TArrayFunction<double>> Double;
	std::map<std::string, FBitsFunction> Bits;
};

/** Uniform scalars, and lanes of the three instruction sets: float 4, 8, 16, double 2, 4, 8. */
const FMathKernels& GetMathKernelsUniform();
const FMathKernels& GetMathKernelsSse();
const FMathKernels& GetMathKernelsAvx2();
const FMathKernels& GetMathKernelsAvx512();

} // namespace Drydock::Tests
