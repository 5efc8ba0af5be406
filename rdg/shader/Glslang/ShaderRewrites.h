// Rewrites what the front end's HLSL lacks, in text without macros and comments: members of uniform buffers, enums,
// positions of loads. Lines stay where they are.
#pragma once

#include "ShaderCompileRequest.h"

#include <set>

namespace Drydock
{

/** X.Y -> X_Y for each uniform buffer X; Used becomes the names of those that the text reads. A member that does not
 * exist becomes an undeclared X_Y, which the front end reports, unless the text declares an X of its own. */
DRYDOCK_API std::string RewriteUniformBuffers(
	const std::string& Text, const std::vector<FShaderUniformBuffer>& Buffers, std::set<std::string>& Used);

/** The same, behind the declarations of the buffers that the text reads. */
DRYDOCK_API std::string DeclareUniformBuffers(
	const std::string& Text, const std::vector<FShaderUniformBuffer>& Buffers);

/** `enum E { A, B = 4 };` and `enum class E : uint { A };` become constants A and B, E_A for E::A, and the type's name
 * becomes int or uint. */
DRYDOCK_API std::string RewriteEnums(const std::string& Text);

/** X.Load(P) -> X.Load((int2)(P)) for each RWTexture2D X, whose position HLSL takes from three components as well. */
DRYDOCK_API std::string RewriteLoads(const std::string& Text);

} // namespace Drydock
