// Counts the cost of each thread of a draw or dispatch: taps and operations, loops included.
#pragma once

#include "ThreadRuns.h"

namespace Drydock
{

/** Rows of the dispatch's threads; slices of a volume one below the other. */
struct FCostMap
{
	int32_t Width = 0;
	int32_t Height = 0;
	std::vector<uint64_t> Taps;       // samples, gathers and loads of textures
	std::vector<uint64_t> Operations; // instructions of the kernel's SPIR-V, each for as many numbers as it makes
};

/** Shader: in its kernel's form (bAsKernel), else the front end's unoptimised operations are counted. */
DRYDOCK_API FCostMap MakeCostMap(
	FInspectedShader& Shader, const FBoundShader& Bound, const FKernelArgs& Args, const FKernelTile& Whole);

} // namespace Drydock
