// Describes where a pointer of a shader points: a variable, a constant offset, and the part known only at run time.
// Constant buffers and structured buffers count in bytes, everything else in flattened scalars.
#pragma once

#include "SpirvModule.h"

namespace Drydock
{

/** Adds clamp(Value, 0, Count - 1) * Stride. */
struct FSpirvIndex
{
	uint32_t Value = 0; // id
	uint32_t Stride = 0;
	uint32_t Count = 0;
};

struct FSpirvPlace
{
	const FSpirvVariable* Variable = nullptr;
	uint32_t Type = 0; // of what is pointed to
	uint32_t Offset = 0;
	std::vector<FSpirvIndex> Indices;
	std::vector<uint32_t> Scalars; // offset of each scalar of Type, to be added
	bool bBytes = false;
	uint32_t Element = 0;       // structured buffers: id of the element's index
	uint32_t ElementStride = 0; // structured buffers: bytes of an element; 0: not a structured buffer
};

/** Pointer is a variable or the result of an access chain. Throws FSpirvError. */
FSpirvPlace ResolvePlace(const FSpirvModule& Module, uint32_t Pointer, const FSpirvInstruction* Chain);

/** Follows a chain from a value of BaseType; an empty instruction stays there. Variable is left null. */
FSpirvPlace FollowChain(const FSpirvModule& Module, uint32_t BaseType, bool bBytes, const FSpirvInstruction& Chain);

/** Byte offsets of the scalars of a type that lies in a buffer. */
std::vector<uint32_t> GetScalarOffsets(
	const FSpirvModule& Module, uint32_t Type, uint32_t MatrixStride, bool bRowMajor);

} // namespace Drydock
