// Runs the kernel of a draw or dispatch once more beside the frame: on copies of what it writes, and of those inputs
// that the caller changes.
#pragma once

#include "Sandbox.h"

#include <vector>

namespace Drydock
{

/** A texture of one mip with memory of its own. */
class DRYDOCK_API FOwnTexture : private FNoncopyable
{
public:
	/** With the first mip's contents. Storage: of the copy; contents are taken over where it is the texture's own. */
	FOwnTexture(const FKernelTexture& Like, ETexelStorage Storage);

	/** Points into this object. */
	FKernelTexture Get() const;
	FKernelMip& GetMip() { return Mip; }

private:
	FKernelMip Mip;
	FKernelTexture Texture;
	std::vector<uint8_t> Memory;
};

/** Address of a texel of the first slice. */
inline uint8_t* GetTexelAddress(const FKernelMip& Mip, int32_t X, int32_t Y, int32_t BytesPerTexel)
{
	return Mip.Data + int64_t(Y) * Mip.RowPitch + int64_t(X) * BytesPerTexel;
}

class DRYDOCK_API FKernelRerun : private FNoncopyable
{
public:
	/** All outlive it. */
	FKernelRerun(const FBoundShader& InShader, const FKernelArgs& InArgs, const FKernelTile& InWhole);

	/** From now on the shader reads this copy of a texture. */
	FOwnTexture& OwnInput(size_t Slot, ETexelStorage Storage);
	FOwnTexture& OwnInput(size_t Slot) { return OwnInput(Slot, Textures[Slot].Storage); }
	/** All columns of a constant of the shader become Value. */
	void SetConstant(const FShaderConstant& Constant, float Value);

	void Run() const;

	/** Copies of the render targets; of a compute shader, of the textures that it stores to. */
	const std::vector<FKernelTexture>& GetWritten() const { return Written; }

private:
	const FBoundShader& Shader;
	const FKernelTile& Whole;
	const FSandbox Sandbox;
	FKernelArgs Args;
	std::vector<FKernelTexture> Textures;
	std::vector<FKernelTarget> Targets;
	std::vector<FKernelTexture> Written;
	std::vector<std::vector<uint8_t>> Constants;
	std::vector<const uint8_t*> ConstantBuffers;
	std::vector<std::unique_ptr<FOwnTexture>> Owned;
};

} // namespace Drydock
