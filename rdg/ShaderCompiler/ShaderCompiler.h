// From a .usf entry point to a function that runs over tiles: flatten includes, glslang (HLSL to SPIR-V), reflection,
// SPIR-V to C++ over lanes, the system compiler, a content-hashed cache. Source: drydock.
#pragma once

#include "DrydockAPI.h"
#include "ShaderKernel.h"
#include "ShaderReflection.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Drydock
{

/** Arithmetic of a compiled shader. Lanes 0: the widest the CPU has for that type (float 16/8/4, double 8/4/2). */
struct FLaneConfig
{
	bool bDouble = false;
	int32_t Lanes = 0;
};

struct FShaderCompileRequest
{
	std::string VirtualPath; // "/Engine/Private/PostProcessBloom.usf"
	std::string EntryPoint;
	EShaderStage Stage = EShaderStage::Compute;
	std::vector<std::pair<std::string, std::string>> Defines;        // in the order of SetDefine
	std::vector<std::pair<std::string, std::string>> GeneratedFiles; // virtual path, text ("/Engine/Generated/...")
	std::vector<std::pair<std::string, std::vector<std::string>>>
		UniformBuffers; // HLSL name, member names: X.Y is rewritten to X_Y
	FLaneConfig Lanes;
};

struct FCompiledShader
{
	FShaderReflection Reflection;
	FKernelFunction Run = nullptr;
	FLaneConfig Lanes; // the resolved lane count
	std::string Key;   // content hash, hexadecimal
	bool bFromCache = false;
	double CompileMs = 0;
	std::vector<std::string> Files; // every file on disk that was read (for --watch)
};

/** Maps a virtual directory ("/Project") to a directory on disk. Later mappings of the same prefix win. */
DRYDOCK_API void AddShaderDirectory(const std::string& VirtualDirectory, const std::string& RealDirectory);

/** Real path of a virtual shader path, empty when no mapping fits or the file does not exist. */
DRYDOCK_API std::string FindShaderFile(const std::string& VirtualPath);

/** Compiles, or takes from memory or the cache. Thread-safe. Throws FError (code DD6xxx, exit code 2) with every
 * message the front end gave, each as "X.usf:LINE: error: ...". */
DRYDOCK_API std::shared_ptr<const FCompiledShader> CompileShader(const FShaderCompileRequest& Request);

/** Front end only: flatten, glslang and reflection, no C++ compiler. For graphs that are compiled but not run. */
DRYDOCK_API FShaderReflection ReflectShader(const FShaderCompileRequest& Request);

/** Forgets what is in memory (files may have changed), keeps the cache on disk. */
DRYDOCK_API void ForgetCompiledShaders();

} // namespace Drydock
