// Finds stores to some components of a texel only, which D3D11 does not have.
#pragma once

#include "HlslProgram.h"

namespace Drydock::Hlsl
{

/** The places of such statements, each once. */
std::vector<FPlace> ListPartialStores(const FProgram& Program);

} // namespace Drydock::Hlsl
