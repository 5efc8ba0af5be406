// Elementary functions on packs of lanes, built per instruction set.
#pragma once

namespace Drydock::Bench
{

/** Numbers of one measurement: a multiple of every lane width. */
constexpr int GNumFunctionValues = 1536;

/** Out[i] = f(A[i], B[i]); each has GNumFunctionValues numbers, aligned to 64 bytes. */
using FFunctionLoop = void (*)(const float* A, const float* B, float* Out);

struct FFunctionKernel
{
	const char* Name;
	FFunctionLoop Loop;
};

/** Ends with an entry without a name. The first only copies: what the loop itself costs. */
const FFunctionKernel* GetFunctionsAvx2();
const FFunctionKernel* GetFunctionsAvx512();

} // namespace Drydock::Bench
