// Copies mips and buffers.
#include "Sandbox.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

FSandbox::FSandbox(const FKernelArgs& InArgs, const FShaderReflection& Reflection)
	: Args(InArgs)
	, RWTextures(InArgs.RWTextures, InArgs.RWTextures + Reflection.RWTextures.size())
	, RWBuffers(InArgs.RWBuffers, InArgs.RWBuffers + Reflection.RWBuffers.size())
{
	for (FKernelTexture& Texture : RWTextures)
	{
		CopyTexture(Texture);
	}
	for (FKernelBuffer& Buffer : RWBuffers)
	{
		Memory.push_back(std::make_unique<uint8_t[]>(Buffer.SizeInBytes + 1));
		if (Buffer.SizeInBytes)
		{
			std::memcpy(Memory.back().get(), Buffer.Data, Buffer.SizeInBytes);
		}
		Buffer.Data = Memory.back().get();
	}
	Args.RWTextures = RWTextures.data();
	Args.RWBuffers = RWBuffers.data();
	Args.Counters = nullptr;
}

void FSandbox::CopyTexture(FKernelTexture& Texture)
{
	Mips.push_back(std::make_unique<FKernelMip[]>(size_t(std::max(1, Texture.NumMips))));
	for (int32_t Index = 0; Index < Texture.NumMips; ++Index)
	{
		FKernelMip& Mip = Mips.back()[size_t(Index)];
		Mip = Texture.Mips[Index];
		const size_t Bytes = size_t(Mip.SizeZ - 1) * size_t(Mip.SlicePitch) + size_t(Mip.SizeY) * size_t(Mip.RowPitch);
		Memory.push_back(std::make_unique<uint8_t[]>(Bytes + 2 * TextureMargin));
		std::memcpy(Memory.back().get() + TextureMargin, Mip.Data, Bytes);
		Mip.Data = Memory.back().get() + TextureMargin;
	}
	Texture.Mips = Mips.back().get();
}

} // namespace Drydock
