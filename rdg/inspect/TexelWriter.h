// Finds the thread of a dispatch that stored to a texel.
#pragma once

#include "InspectedShader.h"

#include <array>
#include <optional>
#include <string>

namespace Drydock
{

/** A thread and the texel that it stored to. */
struct FTexelWriter
{
	std::string Texture; // as the shader calls it
	std::array<int32_t, 3> Texel = {};
	std::array<int32_t, 3> Thread = {};
};

/** The last thread, by x, then y, then z, that stored to the texel; none: no thread does. The threads of the texel's
 * own number and of its transposed one are asked first, and all only if neither stores there. */
DRYDOCK_API std::optional<FTexelWriter> FindTexelWriter(FInspectedShader& Shader, const FBoundShader& Bound,
	const FKernelArgs& Args, const FKernelTile& Whole, const std::string& Texture, const std::array<int32_t, 3>& Texel);

} // namespace Drydock
