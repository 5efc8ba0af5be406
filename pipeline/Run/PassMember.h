// Reads a value out of a pass's parameters.
#pragma once

#include "RenderGraphPass.h"
#include "ShaderParameterMetadata.h"

#include <cstring>

namespace Drydock
{

/** Reads a member of a pass's parameters; of an array or a vector, the value at Index. */
template<typename T>
T ReadMember(const FRDGPass& Pass, const FHlslMember& Member, size_t Index = 0)
{
	T Value;
	std::memcpy(&Value, static_cast<const char*>(Pass.GetParameters()) + Member.Offset + Index * sizeof(T), sizeof(T));
	return Value;
}

} // namespace Drydock
