// A compiled shader together with everything it reads for one pass: constant buffers packed as the shader lays them
// out, and views of its textures, samplers and buffers. Made by the binder (ShaderBinding.h), run by the command list,
// which adds what belongs to the draw: render targets, interpolants and counters.
#pragma once

#include "DrydockAPI.h"
#include "ShaderKernel.h"
#include "ShaderReflection.h"
#include "VertexProgram.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class FShader;
class FRHITexture;

namespace Drydock
{

/** The arguments of a hand-written kernel: the arguments in the slots of the shader's reflection, which it looks up by
 * HLSL name, and the pass's own C++ parameter struct. Lookups are linear: make them per tile, not per pixel. */
class DRYDOCK_API FNativeKernelArgs
{
public:
	FNativeKernelArgs(const FKernelArgs& InArgs, const FShaderReflection& InReflection, const void* InParameters,
		int32_t InPermutationId, uint64_t InPass)
		: Args(InArgs)
		, Reflection(InReflection)
		, Parameters(InParameters)
		, PermutationId(InPermutationId)
		, Pass(InPass)
	{
	}

	/** Null when the shader's permutation does not use a resource of that name. */
	const FKernelTexture* FindTexture(const char* HlslName) const;
	const FKernelTexture* FindRWTexture(const char* HlslName) const;
	const FKernelSampler* FindSampler(const char* HlslName) const;
	const FKernelBuffer* FindBuffer(const char* HlslName) const;
	const FKernelBuffer* FindRWBuffer(const char* HlslName) const;

	const FKernelArgs& GetArgs() const { return Args; }
	const void* GetParameters() const { return Parameters; }
	int32_t GetPermutationId() const { return PermutationId; }

	/** The number of the pass's binding, above 0: no two of a process have the same. The pass's inputs do not change,
	 * so a thread may keep values computed from them from tile to tile. */
	uint64_t GetPass() const { return Pass; }

private:
	const FKernelArgs& Args;
	const FShaderReflection& Reflection;
	const void* Parameters;
	int32_t PermutationId;
	uint64_t Pass;
};

using FNativeKernelFunction = void (*)(const FNativeKernelArgs& Args, const FKernelTile& Tile);

/** Move-only: the arguments point into it. The parameter struct it was made from must outlive it. */
struct DRYDOCK_API FBoundShader
{
	FBoundShader() = default;
	FBoundShader(FBoundShader&&) = default;
	FBoundShader& operator=(FBoundShader&&) = default;
	FBoundShader(const FBoundShader&) = delete;
	FBoundShader& operator=(const FBoundShader&) = delete;

	bool IsValid() const { return Reflection != nullptr; }
	const FShaderReflection& GetReflection() const { return *Reflection; }

	/** The kernel's arguments without Targets, Interpolants and Counters: those are the caller's to add. Valid on the
	 * calling thread and those that work for it while this object lives and is not moved from. */
	FKernelArgs GetArgs() const;

	/** Runs one tile; not of a vertex shader. Thread-safe: any number of tiles at once. Other, if not 0: a number of
	 * GetNewNumber, for a run whose inputs are others than the pass's. */
	void Run(const FKernelArgs& Args, const FKernelTile& Tile, uint64_t Other = 0) const;
	static uint64_t GetNewNumber();

	std::string Name;       // shader class, "FBloomSetupPS"
	std::string EntryPoint; // "BloomSetupPS"
	std::string Key;        // of its text and all that decides what becomes of it; empty: not known
	std::shared_ptr<const FShaderReflection> Reflection; // shares ownership with the compiled shader
	FKernelFunction Kernel = nullptr;                    // the compiled .usf, or
	FNativeKernelFunction Native = nullptr;              // a hand-written kernel that stands in for it
	std::string Edited; // the file of a shader whose text is another than the one that its hand-written kernel knows
	std::shared_ptr<const FVertexProgram> Vertex; // of a vertex shader, which has no kernel
	bool bDouble = false;                         // arithmetic of Kernel
	const void* Parameters = nullptr;
	int32_t PermutationId = 0;
	FShader* Permutation = nullptr;   // what was bound
	uint64_t Number = GetNewNumber(); // of this binding
	std::vector<std::string> Unset;   // what it reads and nobody has set yet, if parameters are set one by one

	std::vector<std::vector<uint8_t>> ConstantData; // one block per constant buffer
	std::vector<const uint8_t*> ConstantBuffers;
	std::vector<FKernelTexture> Textures;
	std::vector<FKernelTexture> RWTextures;
	std::vector<FKernelSampler> Samplers;
	std::vector<FKernelBuffer> Buffers;
	std::vector<FKernelBuffer> RWBuffers;
	std::vector<FRHITexture*> TextureOwners; // the textures that the views are of; null, or a shorter list: not known
	std::vector<FRHITexture*> RWTextureOwners;
};

} // namespace Drydock
