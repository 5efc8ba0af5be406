// Shaders of dispatches in the form that can be looked into, made once for each permutation.
#pragma once

#include "InspectedShader.h"

#include <map>
#include <memory>
#include <string>

namespace Drydock
{

/** The pass that runs, as its event names it; else the shader's class. */
DRYDOCK_API std::string GetPassName(const FBoundShader& Shader);

/** Whether a pattern is of the pass that runs, as IsPassNamed of a name has it, or of its shader's class. */
DRYDOCK_API bool IsPassNamed(const std::string& Pattern, const FBoundShader& Shader);

class DRYDOCK_API FDispatchShaders
{
public:
	/** As FInspectedShader's constructor. */
	explicit FDispatchShaders(bool bInAsKernel = false)
		: bAsKernel(bInAsKernel)
	{
	}

	/** Throws FError as FInspectedShader. */
	std::shared_ptr<FInspectedShader> Get(const FBoundShader& Shader);

private:
	const bool bAsKernel;
	std::map<std::pair<FShader*, bool>, std::shared_ptr<FInspectedShader>>
		Shaders; // by permutation, and whether by quads
};

} // namespace Drydock
