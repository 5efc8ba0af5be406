// A kernel's arguments with copies of all that it writes, so that a shader can be run a second time beside the frame.
#pragma once

#include "BoundShader.h"
#include "Templates/UnrealTemplate.h"

#include <memory>

namespace Drydock
{

/** Bytes that kernels may read on either side of a texture. */
inline constexpr size_t TextureMargin = 64;

class DRYDOCK_API FSandbox : private FNoncopyable
{
public:
	/** Copies textures and buffers that the shader stores to; what it reads stays where it is. Render targets are left
	 * out: the interpreter hands them over as values. */
	FSandbox(const FKernelArgs& Args, const FShaderReflection& Reflection);

	const FKernelArgs& GetArgs() const { return Args; }

private:
	void CopyTexture(FKernelTexture& Texture);

	FKernelArgs Args;
	std::vector<FKernelTexture> RWTextures;
	std::vector<FKernelBuffer> RWBuffers;
	std::vector<std::unique_ptr<FKernelMip[]>> Mips;
	std::vector<std::unique_ptr<uint8_t[]>> Memory;
};

} // namespace Drydock
