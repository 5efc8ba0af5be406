// Runs a bound shader, and looks up by name what hand-written kernels ask for.
#include "BoundShader.h"

#include "KernelLimits.h"
#include "NativeFallback.h"

#include <atomic>

namespace Drydock
{

namespace
{

template<typename T>
const T* FindByName(const std::vector<FShaderResource>& Resources, const T* Views, const char* HlslName)
{
	for (size_t Slot = 0; Slot < Resources.size(); ++Slot)
	{
		if (Resources[Slot].Name == HlslName)
		{
			return Views + Slot;
		}
	}
	return nullptr;
}

/** The only arguments of hand-written kernels that there are: with what RunShader runs. */
struct FNativeKernelCall : FNativeKernelArgs
{
	FNativeKernelCall(const FBoundShader& Bound, const FKernelArgs& Args, uint64_t Number)
		: FNativeKernelArgs(Args, *Bound.Reflection, Bound.Parameters, Bound.PermutationId, Number)
		, Shader(Bound.Kernel)
	{
	}

	FKernelFunction Shader;
};

std::atomic<uint64_t> NumFallbacks{0};

} // namespace

uint64_t GetNativeFallbacks()
{
	return NumFallbacks.load();
}

void RunShader(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	NumFallbacks.fetch_add(1, std::memory_order_relaxed);
	static_cast<const FNativeKernelCall&>(Args).Shader(Args.GetArgs(), Tile);
}

const FKernelTexture* FNativeKernelArgs::FindTexture(const char* HlslName) const
{
	return FindByName(Reflection.Textures, Args.Textures, HlslName);
}

const FKernelTexture* FNativeKernelArgs::FindRWTexture(const char* HlslName) const
{
	return FindByName(Reflection.RWTextures, Args.RWTextures, HlslName);
}

const FKernelSampler* FNativeKernelArgs::FindSampler(const char* HlslName) const
{
	return FindByName(Reflection.Samplers, Args.Samplers, HlslName);
}

const FKernelBuffer* FNativeKernelArgs::FindBuffer(const char* HlslName) const
{
	return FindByName(Reflection.Buffers, Args.Buffers, HlslName);
}

const FKernelBuffer* FNativeKernelArgs::FindRWBuffer(const char* HlslName) const
{
	return FindByName(Reflection.RWBuffers, Args.RWBuffers, HlslName);
}

FVertexProgram::~FVertexProgram() = default;

uint64_t FBoundShader::GetNewNumber()
{
	static std::atomic<uint64_t> Last{0};
	return Last.fetch_add(1, std::memory_order_relaxed) + 1;
}

FKernelArgs FBoundShader::GetArgs() const
{
	FKernelArgs Args{};
	Args.ConstantBuffers = ConstantBuffers.data();
	Args.Textures = Textures.data();
	Args.RWTextures = RWTextures.data();
	Args.Samplers = Samplers.data();
	Args.Buffers = Buffers.data();
	Args.RWBuffers = RWBuffers.data();
	Args.Limits = GetKernelLimits();
	return Args;
}

void FBoundShader::Run(const FKernelArgs& Args, const FKernelTile& Tile, uint64_t Other) const
{
	if (Native)
	{
		Native(FNativeKernelCall(*this, Args, Other ? Other : Number), Tile);
	}
	else
	{
		Kernel(Args, Tile);
	}
}

} // namespace Drydock
