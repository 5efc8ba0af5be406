// Defines the shader tier's requests and results: every stage takes these types, and the facade (ShaderCompiler.h) runs
// the stages.
#pragma once

#include "ShaderKernel.h"
#include "ShaderReflection.h"
#include "VertexProgram.h"

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
	int32_t WaveSize = 32; // threads of a wave, of compute shaders whose threads work together: 4, 8, 16, 32 or 64
};

/** A uniform buffer that the shader may read. */
struct FShaderUniformBuffer
{
	std::string Name;                 // in HLSL
	std::vector<std::string> Members; // X.Member is rewritten to X_Member
	std::string Declaration;          // HLSL; stands in the text of shaders that read the buffer
};

/** A define of a request by which its text is read by the rules of FXC (docs/shaders.md). */
inline constexpr const char* FxcRulesDefine = "DRYDOCK_FXC_RULES";

struct FShaderCompileRequest
{
	std::string VirtualPath; // "/Engine/Private/PostProcessBloom.usf"
	std::string EntryPoint;
	EShaderStage Stage = EShaderStage::Compute;
	std::vector<std::pair<std::string, std::string>> Defines;        // in the order of SetDefine
	std::vector<std::pair<std::string, std::string>> GeneratedFiles; // virtual path, text ("/Engine/Generated/...")
	std::vector<FShaderUniformBuffer> UniformBuffers;
	FLaneConfig Lanes;
	bool bQuads = false; // a pixel shader whose samples choose their mips, though it takes no derivatives itself
	bool bKeepFunctions = false; // SPIR-V with its calls and local variables, for looking inside; not for kernels
};

struct FCompiledShader
{
	FShaderReflection Reflection;
	FKernelFunction Run = nullptr;
	std::shared_ptr<const FVertexProgram> Vertex; // of a vertex shader, which has no kernel
	FLaneConfig Lanes;                            // the resolved lane count
	std::string Key;                              // content hash, hexadecimal
	std::string Fingerprint;                      // of the text alone, see FingerprintShader
	bool bFromCache = false;
	double CompileMs = 0;
	std::vector<std::string> Files; // every file on disk that was read (for --watch)
};

} // namespace Drydock
