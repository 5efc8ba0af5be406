// Integers of constants as HLSL computes them: what the front end's optimiser would fold by rules of its own.
#pragma once

#include <glslang/SPIRV/spirv.hpp>

#include <cstddef>
#include <vector>

namespace Drydock
{

/** Words of a module of SPIR-V before its first instruction. */
inline constexpr std::ptrdiff_t GModuleHeaderWords = 5;

/** Calls f(Op, First, Count) for each instruction: First its first word. */
template<typename F>
void ForEachInstruction(const std::vector<unsigned int>& Words, F f)
{
	for (size_t At = GModuleHeaderWords; At < Words.size() && Words[At] >> spv::WordCountShift != 0;
		 At += Words[At] >> spv::WordCountShift)
	{
		f(Words[At] & spv::OpCodeMask, At, Words[At] >> spv::WordCountShift);
	}
}

/** Changes SPIR-V, a whole module with its header, before it is optimised: remainders have the sign of their left side,
 * shifts take the low bits of their count. Divisions that might be by 0 or -1 are hidden from the optimiser.
 * Source: Direct3D 11.3 functional specification, 22.11 and 22.13 (udiv, ishl, ushr, ishr). */
void CorrectIntegers(std::vector<unsigned int>& Words);

/** After it: divisions are divisions again. */
void RestoreDivisions(std::vector<unsigned int>& Words);

} // namespace Drydock
