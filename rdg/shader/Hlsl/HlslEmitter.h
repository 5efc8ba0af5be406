// The program of one entry to SPIR-V.
#pragma once

#include "HlslProgram.h"

namespace Drydock::Hlsl
{

struct FEmission
{
	std::vector<uint32_t> Words;
	std::string Error; // not empty: something that cannot be written in SPIR-V, at Place
	FPlace Place;
};

/** SPIR-V of the version that glslang made (1.0; 1.3 with waves) with the names, decorations, lines and functions of
 * the text. Each function is a function of SPIR-V, one for each set of resources that it is called with. OptimiseHlsl
 * inlines them. */
FEmission Emit(const FProgram& Program);

/** The module with all calls inlined and local variables as values, by SPIRV-Tools; arithmetic of floats is left as it
 * is. */
std::vector<uint32_t> Optimise(const std::vector<uint32_t>& Words, std::string& Error);

} // namespace Drydock::Hlsl
