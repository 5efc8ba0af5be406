// Runs the shader in place of its hand-written kernel, where the kernel cannot give the same result.
#pragma once

#include "DrydockAPI.h"

#include <cstdint>

namespace Drydock
{

class FNativeKernelArgs;
struct FKernelTile;

/** Runs the compiled .usf on a tile or a part of one. Args: those that the kernel was called with. */
DRYDOCK_API void RunShader(const FNativeKernelArgs& Args, const FKernelTile& Tile);

/** Number of calls of RunShader in this process; for tests. */
DRYDOCK_API uint64_t GetNativeFallbacks();

} // namespace Drydock
