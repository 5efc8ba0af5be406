// Arguments for any shader, from its reflection alone: constants all of one value, textures, buffers and targets of a
// few texels. For shaders that must run, whatever they are.
#pragma once

#include "ShaderKernel.h"
#include "ShaderReflection.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace Drydock::Test
{

class FBlankArguments
{
public:
	static constexpr int32_t Size = 8; // texels along each side

	/** Constant: the value of every float and, cut, of every integer of the constant buffers, textures and buffers. */
	FBlankArguments(const FShaderReflection& Reflection, float Constant)
	{
		const auto Fill = [](std::vector<uint8_t>& Memory, const auto& Value)
		{
			for (size_t At = 0; At + sizeof(Value) <= Memory.size(); At += sizeof(Value))
			{
				std::memcpy(Memory.data() + At, &Value, sizeof(Value));
			}
		};
		for (const FShaderConstantBuffer& Buffer : Reflection.ConstantBuffers)
		{
			ConstantMemory.emplace_back(Buffer.Size, uint8_t(0));
			Fill(ConstantMemory.back(), Constant);
		}
		for (const FShaderConstant& One : Reflection.Constants)
		{
			const uint32_t Whole = uint32_t(Constant);
			const bool bInteger = One.Scalar != EShaderScalar::Float && One.Rows == 1;
			for (int32_t i = 0; bInteger && i < std::max(1, One.NumElements) * One.Columns; ++i)
			{
				const size_t At = size_t(i / One.Columns) * One.ArrayStride + size_t(i % One.Columns) * 4;
				std::memcpy(ConstantMemory[One.Buffer].data() + One.Offset + At, &Whole, 4);
			}
		}
		for (const std::vector<uint8_t>& Memory : ConstantMemory)
		{
			ConstantBuffers.push_back(Memory.data());
		}
		const size_t NumTextures = Reflection.Textures.size() + Reflection.RWTextures.size() + 8;
		const size_t NumBuffers = Reflection.Buffers.size() + Reflection.RWBuffers.size();
		Mips.reserve(NumTextures);
		Texels.reserve(NumTextures + NumBuffers);
		const auto AddMemory = [this, &Fill, Constant](size_t Bytes, bool bFloat)
		{
			Texels.emplace_back(Bytes + 2 * Margin, uint8_t(0));
			bFloat ? Fill(Texels.back(), Constant) : Fill(Texels.back(), uint32_t(Constant));
			return Texels.back().data() + Margin;
		};
		const auto AddTexture = [this, &AddMemory](bool bFloat, EShaderDimension Dimension)
		{
			const int32_t Pitch = Size * (bFloat ? 16 : 4);
			const bool bLayers =
				Dimension == EShaderDimension::Texture3D || Dimension == EShaderDimension::Texture2DArray;
			const int32_t SizeZ = bLayers ? 2 : 1;
			Mips.push_back({AddMemory(size_t(Pitch) * Size * size_t(SizeZ), bFloat), Size, Size, SizeZ, Pitch,
				int64_t(Pitch) * Size});
			return FKernelTexture{&Mips.back(), 1, bFloat ? ETexelStorage::RGBA32_FLOAT : ETexelStorage::R32_UINT,
				uint8_t(Dimension == EShaderDimension::Texture3D), 0};
		};
		const auto AddTextures = [&AddTexture](
									 const std::vector<FShaderResource>& List, std::vector<FKernelTexture>& Views)
		{
			for (const FShaderResource& Resource : List)
			{
				Views.push_back(AddTexture(Resource.Scalar == EShaderScalar::Float, Resource.Dimension));
			}
		};
		const auto AddBuffers = [&AddMemory](
									const std::vector<FShaderResource>& List, std::vector<FKernelBuffer>& Views)
		{
			for (const FShaderResource& Resource : List)
			{
				const bool bFloat = Resource.Scalar == EShaderScalar::Float;
				const bool bTyped = Resource.Dimension == EShaderDimension::TypedBuffer;
				const uint32_t Stride = bTyped ? (bFloat ? 16 : 4) : Resource.Stride < 4 ? 4 : Resource.Stride;
				constexpr uint32_t Bytes = 1024;
				Views.push_back({AddMemory(Bytes, bFloat), Bytes, Stride,
					bFloat ? ETexelStorage::RGBA32_FLOAT : ETexelStorage::R32_UINT});
			}
		};
		AddTextures(Reflection.Textures, Textures);
		AddTextures(Reflection.RWTextures, RWTextures);
		AddBuffers(Reflection.Buffers, Buffers);
		AddBuffers(Reflection.RWBuffers, RWBuffers);
		Samplers.assign(Reflection.Samplers.size(),
			{EKernelFilter::Bilinear, EKernelAddress::Clamp, EKernelAddress::Clamp, EKernelAddress::Clamp, 8, 0, {}});
		for (int32_t i = 0; i < Reflection.NumTargets; ++i)
		{
			FKernelTarget Target{};
			Target.Texture = AddTexture(true, EShaderDimension::Texture2D);
			Target.WriteMask = 15;
			Targets.push_back(Target);
		}
		for (FKernelInterpolant& Interpolant : Interpolants)
		{
			Interpolant = {{0, 0, 0, 0}, {1.0 / Size, 0, 0, 0}, {0, 1.0 / Size, 0, 0}};
		}
		Args = {ConstantBuffers.data(), Textures.data(), RWTextures.data(), Samplers.data(), Buffers.data(),
			RWBuffers.data(), Targets.data(), Interpolants, int32_t(Targets.size()), nullptr, nullptr};
	}
	FBlankArguments(const FBlankArguments&) = delete;
	FBlankArguments& operator=(const FBlankArguments&) = delete;

	const FKernelArgs& Get() const { return Args; }

private:
	static constexpr size_t Margin = 64; // readable around texels

	std::vector<std::vector<uint8_t>> ConstantMemory;
	std::vector<const uint8_t*> ConstantBuffers;
	std::vector<std::vector<uint8_t>> Texels;
	std::vector<FKernelMip> Mips;
	std::vector<FKernelTexture> Textures;
	std::vector<FKernelTexture> RWTextures;
	std::vector<FKernelSampler> Samplers;
	std::vector<FKernelBuffer> Buffers;
	std::vector<FKernelBuffer> RWBuffers;
	std::vector<FKernelTarget> Targets;
	FKernelInterpolant Interpolants[16] = {};
	FKernelArgs Args = {};
};

} // namespace Drydock::Test
