// Finds in the program of a shader's entry what its module no longer shows.
#pragma once

#include "HlslProgram.h"

#include <vector>

namespace Drydock
{

struct FProgramFinding
{
	const char* Rule = nullptr; // the id
	Hlsl::FPlace Place;         // File: index into FProgram::Files
	std::string_view What;      // as FLintFinding
};

/** Stores to a part of a texel (partial-uav-store), and derivatives and samples with implicit levels in a compute
 * shader (derivative-compute), in the order of the functions. */
std::vector<FProgramFinding> LookAtProgram(const Hlsl::FProgram& Program);

} // namespace Drydock
