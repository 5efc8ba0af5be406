// A .usf entry point compiled by the shader tier, with its parameters given by HLSL name: what a pass runs, without
// the pass.
#pragma once

#include "ShaderCompiler.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace Drydock::Bench
{

class FUsfKernel
{
public:
	/** Constants: up to four floats per name; what is not named is zero. */
	FUsfKernel(const FShaderCompileRequest& Request, const std::map<std::string, std::vector<float>>& Constants)
		: Shader(CompileShader(Request))
	{
		const FShaderReflection& Reflection = Shader->Reflection;
		for (const FShaderConstantBuffer& Buffer : Reflection.ConstantBuffers)
		{
			Blocks.emplace_back(Buffer.Size + 16, uint8_t(0));
		}
		for (const FShaderConstant& Constant : Reflection.Constants)
		{
			const auto Found = Constants.find(Constant.Name);
			if (Found != Constants.end() && Constant.Scalar == EShaderScalar::Float)
			{
				std::memcpy(Blocks[Constant.Buffer].data() + Constant.Offset, Found->second.data(),
					Found->second.size() * sizeof(float));
			}
		}
		for (const std::vector<uint8_t>& Block : Blocks)
		{
			BlockPointers.push_back(Block.data());
		}
	}

	/** Every texture read is Input, every one written Output; structured buffers hold ones. One thread; the whole
	 * output at once, or in tiles. */
	void Run(const FKernelTexture& Input, const FKernelTexture& Output, int32_t TileX = 1 << 30,
		int32_t TileY = 1 << 30) const
	{
		const FKernelSampler Sampler = {EKernelFilter::Bilinear, EKernelAddress::Clamp, EKernelAddress::Clamp,
			EKernelAddress::Clamp, 8, 0, {0, 0, 0, 0}};
		std::vector<float> Ones(64, 1.0f);
		const FShaderReflection& Reflection = Shader->Reflection;
		const std::vector<FKernelTexture> Textures(Reflection.Textures.size() + 1, Input);
		const std::vector<FKernelTexture> RWTextures(Reflection.RWTextures.size() + 1, Output);
		const std::vector<FKernelSampler> Samplers(Reflection.Samplers.size() + 1, Sampler);
		const std::vector<FKernelBuffer> Buffers(Reflection.Buffers.size() + 1,
			FKernelBuffer{reinterpret_cast<uint8_t*>(Ones.data()), 256, 16, ETexelStorage::RGBA32_FLOAT});
		const FKernelTarget Target = {Output, 15, 0, EKernelBlendOp::Add, EKernelBlendFactor::One,
			EKernelBlendFactor::Zero, EKernelBlendOp::Add, EKernelBlendFactor::One, EKernelBlendFactor::Zero};
		const FKernelInterpolant Interpolant = {};
		FKernelArgs Args = {};
		Args.ConstantBuffers = BlockPointers.data();
		Args.Textures = Textures.data();
		Args.RWTextures = RWTextures.data();
		Args.Samplers = Samplers.data();
		Args.Buffers = Buffers.data();
		Args.Targets = &Target;
		Args.NumTargets = 1;
		Args.Interpolants = &Interpolant;
		const FKernelMip& Mip = Output.Mips[0];
		for (int32_t Y = 0; Y < Mip.SizeY; Y += std::min(TileY, Mip.SizeY))
		{
			for (int32_t X = 0; X < Mip.SizeX; X += std::min(TileX, Mip.SizeX))
			{
				Shader->Run(Args, {X, Y, 0, X + std::min(TileX, Mip.SizeX - X), Y + std::min(TileY, Mip.SizeY - Y), 1});
			}
		}
	}

private:
	std::shared_ptr<const FCompiledShader> Shader;
	std::vector<std::vector<uint8_t>> Blocks;
	std::vector<const uint8_t*> BlockPointers;
};

} // namespace Drydock::Bench
