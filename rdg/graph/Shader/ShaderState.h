// Holds the shader tier's state per permutation between passes. Internal to this folder.
#pragma once

#include "ShaderBindingPlan.h"
#include "ShaderCompileRequest.h"

#include <map>
#include <memory>
#include <mutex>
#include <tuple>

namespace Drydock
{

struct FShaderState
{
	std::mutex Mutex;
	std::map<std::tuple<bool, int32_t, int32_t, bool>, std::shared_ptr<const FCompiledShader>>
		Compiled; // by precision, asked-for lanes, wave size, and whether by quads
	std::shared_ptr<const FShaderReflection> Reflection;
	std::map<const FShaderParametersMetadata*, std::shared_ptr<const FShaderBindingPlan>> Plans;
};

} // namespace Drydock
