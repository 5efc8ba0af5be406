// Three shaders, each as lane code (what the emitter writes) and as plain scalar C++ with GLM, built per instruction
// set.
#pragma once

#include "ShaderKernel.h"

namespace Drydock::Bench
{

struct FPass
{
	FKernelTexture Input;
	FKernelTexture Output;
};

using FPassFunction = void (*)(const FPass& Pass);

struct FKernelPair
{
	const char* Name;
	int32_t OutputDivisor; // output extent = input extent / this
	FPassFunction Lanes;
	FPassFunction Scalar;
};

/** KawaseDown, BloomSetup, Blur13. */
const FKernelPair* GetKernelsAvx2();
const FKernelPair* GetKernelsAvx512();
constexpr int GNumKernels = 3;

} // namespace Drydock::Bench
