// Runs a bound shader, and looks up by name what hand-written kernels ask for.
#include "BoundShader.h"

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

} // namespace

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

FKernelArgs FBoundShader::GetArgs() const
{
	FKernelArgs Args{};
	Args.ConstantBuffers = ConstantBuffers.data();
	Args.Textures = Textures.data();
	Args.RWTextures = RWTextures.data();
	Args.Samplers = Samplers.data();
	Args.Buffers = Buffers.data();
	Args.RWBuffers = RWBuffers.data();
	return Args;
}

void FBoundShader::Run(const FKernelArgs& Args, const FKernelTile& Tile) const
{
	if (Native)
	{
		Native(FNativeKernelArgs(Args, *Reflection, Parameters, PermutationId), Tile);
	}
	else
	{
		Kernel(Args, Tile);
	}
}

} // namespace Drydock
