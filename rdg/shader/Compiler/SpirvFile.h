// SPIR-V files as shaders: "X.spv" in place of "X.usf", made by whatever compiler.
#pragma once

#include "ShaderCompileRequest.h"
#include "ShaderText.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace Drydock
{

/** Whether a shader of this path is SPIR-V: its name ends with .spv. */
DRYDOCK_API bool IsSpirvFile(const std::string& VirtualPath);

/** The module in Bytes with the entry that is asked for and without its other ones, as the Text of a source: the
 * module, which GetSpirvWords gives back, and declarations of the buffers of bytes, as reflection looks for them in
 * HLSL. Throws FError: DD6004 if Bytes are not a module, DD6011 if the module has no such entry, with a list of its
 * entries. */
DRYDOCK_API FShaderSource ReadSpirvFile(const std::string& Bytes, const FShaderCompileRequest& Request);

/** The entries of the module in Bytes for a stage that drydock has. Request: its path, for messages. Throws FError
 * (DD6004) where the bytes are not a module. */
std::vector<std::pair<std::string, EShaderStage>> ListSpirvEntries(
	const std::string& Bytes, const FShaderCompileRequest& Request);

/** The words in such a text. */
std::vector<uint32_t> GetSpirvWords(const std::string& Text);

/** The module with its calls inlined by SPIRV-Tools, which computes nothing in it, those of functions that ask not to
 * be inlined too. A module that its validator refuses stays as it is. */
std::vector<uint32_t> InlineSpirvCalls(std::vector<uint32_t> Words);

} // namespace Drydock
