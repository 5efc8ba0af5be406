// SPIR-V as the front end makes it, made ready for a Vulkan driver: each resource with a place of its own, nothing that
// only drydock reads. Words in, words out; no driver is asked.
#pragma once

#include "SpirvModule.h"

namespace Drydock
{

struct FVulkanModule
{
	std::vector<uint32_t> Words;
	std::vector<uint32_t> Capabilities; // that it declares
	std::string EntryPoint;
};

/** Words: those that Module was read from. Resource i of Module.Variables is at set 0, binding i; a pixel shader's
 * TEXCOORDn is at location n. */
DRYDOCK_API FVulkanModule MakeVulkanModule(const std::vector<uint32_t>& Words, const FSpirvModule& Module);

/** A vertex shader that passes its inputs on: location 0 is a float4 that becomes the position, location n + 1 becomes
 * TEXCOORDn with Components[n] components, 0 for none. Entry point "main". */
DRYDOCK_API std::vector<uint32_t> MakePassingVertexShader(const std::vector<uint32_t>& Components);

/** Components of each TEXCOORD that a pixel shader reads, by n; an array counts for all its elements. */
DRYDOCK_API std::vector<uint32_t> GetTexCoordComponents(const FSpirvModule& Module);

} // namespace Drydock
