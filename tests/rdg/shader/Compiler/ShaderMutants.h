// Shaders as they look after a hasty edit, a merge gone wrong or a damaged disk: a text changed in a few places, by a
// seed alone.
#pragma once

#include <cstdint>
#include <string>

namespace Drydock::Test
{

struct FShaderMutant
{
	std::string Text;
	std::string What; // the changes, for messages: "delete token, change number"
};

/** Text, the shader of the virtual path Path, changed in one to three places. Equal seeds give equal mutants. */
FShaderMutant MutateShader(const std::string& Text, const std::string& Path, uint32_t Seed);

} // namespace Drydock::Test
