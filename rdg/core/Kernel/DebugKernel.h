// The binary interface between a shader that was compiled for a debugger, one thread at a time, and the library: the
// generated code owns the author's variables and the control flow, and the interpreter owns all else.
#pragma once

#include <cstdint>

namespace Drydock
{

/** One run of a thread. Words are those of FSpirvProgram. */
struct FDebugKernelArgs
{
	uint64_t* Words;
	void* Self; // of the two calls
	/** Carries out an instruction that neither calls nor branches; does not return where the thread ends with it. */
	void (*Execute)(void* Self, uint32_t Step);
	/** Control goes from block to block of the program, to the header of a loop that may not end. */
	void (*Turn)(void* Self, uint32_t To, uint32_t From);
	/** The word of a number in a constant buffer, which is a variable of the module. Kind: an ESpirvType. */
	uint64_t (*ReadConstant)(void* Self, uint32_t Variable, uint32_t Offset, uint8_t Kind);
	/** Words to a variable of numbers of 32 bits, and back. */
	void (*Take)(const uint64_t* Words, void* To, uint32_t Count);
	void (*Put)(uint64_t* Words, const void* From, uint32_t Count);
	int32_t Position[3]; // pixel or dispatch id
	int32_t Min[3];      // of what the pass draws or dispatches
	int32_t Max[3];      // past the last
	int32_t Next[3];     // if bAgain: the thread that somebody asked for from the debugger
	bool bAgain;
};

using FDebugKernelFunction = void (*)(FDebugKernelArgs& Args);

/** Under this C name a shader that was compiled for a debugger exports its FDebugKernelFunction. */
constexpr const char* GDebugKernelName = "DrydockDebugKernel";

} // namespace Drydock
