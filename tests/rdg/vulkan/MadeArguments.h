// Arguments for any shader, made from its reflection alone: constants that are plausible by their names, pictures that
// are smooth or noisy.
#pragma once

#include "ShaderKernel.h"
#include "ShaderReflection.h"

#include <memory>
#include <random>
#include <string>
#include <vector>

namespace Drydock::Test
{

enum class EMadePictures
{
	Smooth,
	Noisy
};

/** Pixels and threads of a run: every picture has this size. */
constexpr int32_t GMadeSizeX = 24;
constexpr int32_t GMadeSizeY = 16;

class FMadeArguments
{
public:
	/** The same for the same Seed. Samplers do not snap coordinates to 1/256 of a texel, as no driver of a CPU does. */
	FMadeArguments(const FShaderReflection& InReflection, EMadePictures Pictures, uint32_t Seed);
	FMadeArguments(const FMadeArguments&) = delete;
	FMadeArguments& operator=(const FMadeArguments&) = delete;

	const FKernelArgs& GetArgs() const { return Args; }
	FKernelTile GetWhole() const;

	/** All numbers that the shader can have written, and where one lies, for a message. */
	std::vector<double> ReadResults() const;
	std::string DescribeResult(size_t Index) const;

	/** A render target's texel. */
	float* GetTarget(size_t Target, int32_t X, int32_t Y);

	std::vector<FKernelInterpolant> Interpolants; // may be changed before a run
	std::vector<FKernelSampler> Samplers;

private:
	struct FMadeTexture
	{
		std::vector<uint8_t> Memory;
		std::vector<FKernelMip> Mips;
		FKernelTexture View = {};
	};

	void MakeConstants(std::mt19937& Random);
	const FKernelTexture& MakeTexture(const FShaderResource& Resource, bool bWritten, EMadePictures Pictures);
	FKernelBuffer MakeBuffer(const FShaderResource& Resource, bool bWritten);
	float MakeNumber(const std::string& Name, int32_t Component, std::mt19937& Random) const;

	const FShaderReflection& Reflection;
	std::mt19937 Random;
	FKernelArgs Args = {};
	std::vector<std::vector<uint8_t>> Constants;
	std::vector<const uint8_t*> ConstantPointers;
	std::vector<std::unique_ptr<FMadeTexture>> Made;
	std::vector<std::unique_ptr<std::vector<uint32_t>>> BufferWords;
	std::vector<FKernelTexture> Textures;
	std::vector<FKernelTexture> RWTextures;
	std::vector<FKernelBuffer> Buffers;
	std::vector<FKernelBuffer> RWBuffers;
	std::vector<FKernelTarget> Targets;
};

} // namespace Drydock::Test
