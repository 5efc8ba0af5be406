// Finds the source of a bound shader.
#include "Inspect/DispatchShaders.h"

#include "Run/RunDump.h"
#include "RunningCode.h"
#include "Shader.h"
#include "ShaderCompilation.h"
#include "Text/GlobPattern.h"

namespace Drydock
{

std::string GetPassName(const FBoundShader& Shader)
{
	const FCodeOwner* const Owner = GetRunningCode();
	return Owner && !Owner->Pass.empty() ? Owner->Pass : Shader.Name;
}

bool IsPassNamed(const std::string& Pattern, const FBoundShader& Shader)
{
	return IsPassNamed(Pattern, GetPassName(Shader)) || MatchesPattern(Pattern, Shader.Name);
}

std::shared_ptr<FInspectedShader> FDispatchShaders::Get(const FBoundShader& Shader)
{
	std::shared_ptr<FInspectedShader>& Inspected = Shaders[{Shader.Permutation, Shader.GetReflection().bQuads}];
	if (!Inspected)
	{
		const FShaderRef Permutation(Shader.Permutation);
		Inspected = std::make_shared<FInspectedShader>(
			MakeShaderCompileRequest(Permutation, Permutation.GetRootParametersMetadata()), Shader.GetReflection(),
			bAsKernel);
	}
	return Inspected;
}

} // namespace Drydock
