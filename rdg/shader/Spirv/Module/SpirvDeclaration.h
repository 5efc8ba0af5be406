// Reads from a shader's text what SPIR-V does not hold of its declarations: types that have the form of others, lines.
#pragma once

#include <string>

namespace Drydock
{

/** Whether Text, flattened HLSL, declares Name as Type ("RWByteAddressBuffer", "AppendStructuredBuffer"), alone or in a
 * list; what the type takes in <> is anything. */
bool IsDeclaredAs(const std::string& Text, const std::string& Type, const std::string& Name);

struct FTextLine
{
	std::string File;
	int Line = 0; // 0: not found
};

/** Finds the line of "Name : Semantic" in Text, by its #line directives; semantics in upper or lower case. */
FTextLine FindSemantic(const std::string& Text, const std::string& Name, const std::string& Semantic);

} // namespace Drydock
