// Computes the offsets of the members of a structured buffer's element by the rules of GLSL's std430, for the
// portability lint. Source: OpenGL 4.6 specification, 7.6.2.2.
#pragma once

#include "SpirvModule.h"

namespace Drydock
{

/** In bytes. */
struct FStd430
{
	uint32_t Size = 0;
	uint32_t Alignment = 4;
};

/** Value, or the next multiple above it. */
inline uint32_t RoundUp(uint32_t Value, uint32_t Multiple)
{
	return (Value + Multiple - 1) / Multiple * Multiple;
}

/** Whether a type lies by std430 as its decorations say it lies in Direct3D. Out: its size and alignment by std430. */
bool LiesAlike(const FSpirvModule& Module, uint32_t TypeId, FStd430& Out);

} // namespace Drydock
