// Whether a shader's text declares something as a type that SPIR-V does not tell from its relatives.
#pragma once

#include <string>

namespace Drydock
{

/** Whether Text, flattened HLSL, declares Name as Type ("RWByteAddressBuffer", "AppendStructuredBuffer"), alone or in a
 * list; what the type takes in <> is anything. */
bool IsDeclaredAs(const std::string& Text, const std::string& Type, const std::string& Name);

} // namespace Drydock
