// A test's buffers as a shader's arguments.
#pragma once

#include "ConformanceTest.h"
#include "ShaderKernel.h"
#include "ShaderReflection.h"

#include <map>
#include <memory>

namespace Drydock::Conformance
{

class FBinding
{
public:
	/** Text is the flattened HLSL, which has the registers. Throws FNotRead. */
	FBinding(const FPipeline& InPipeline, const FShaderReflection& Reflection, const std::string& Text);

	const FKernelArgs& GetArgs() const { return Args; }

	/** What the shader has written, back into the buffers of Target, which is the pipeline that was bound. */
	void ReadBack(FPipeline& Target) const;

private:
	struct FPlace // of a resource, as the text has it
	{
		std::string Name;
		char Class = 0;
		int32_t Register = -1;
		int32_t Space = 0;
		int32_t Binding = -1;
		int32_t Set = 0;
		bool bPush = false;
		bool bArray = false;
	};
	/** A buffer of the test, or one of those of an array. */
	struct FElement
	{
		const FBuffer* Buffer = nullptr; // null: nothing is bound
		size_t Member = 0;
	};
	struct FMemory
	{
		FElement Of;
		std::vector<uint8_t> Bytes; // with a margin before and behind
		std::vector<FKernelMip> Mips;
	};

	void ReadPlaces(const std::string& Text);
	std::string FindArray(const std::string& Name, int32_t& Index) const;
	void AddMembers(const std::vector<FShaderResource>& List, char Class);
	void PlaceTheRest(const FShaderReflection& Reflection);
	const FPlace* FindPlace(const std::string& Name) const;
	const FResource* FindResource(const std::string& Name) const;
	FElement FindBuffer(const std::string& Name) const;
	FMemory& GetMemory(const FElement& Element);
	FKernelTexture MakeTexture(const FShaderResource& Resource);
	FKernelBuffer MakeBuffer(const FShaderResource& Resource);
	bool IsPushed(const std::string& Constants) const;
	void CheckPushed(const FShaderReflection& Reflection, const std::string& Text) const;
	void AddConstants(const FShaderConstantBuffer& Constants);
	FKernelSampler MakeSampler(const FShaderResource& Resource) const;

	const FPipeline& Pipeline;
	std::vector<FPlace> Places;
	std::map<std::string, size_t> Declared; // names, and the token where each stands first
	std::vector<std::unique_ptr<FMemory>> Memories;
	std::vector<std::vector<uint8_t>> ConstantMemory;
	std::vector<const uint8_t*> ConstantPointers;
	std::vector<FKernelTexture> Textures;
	std::vector<FKernelTexture> RWTextures;
	std::vector<FKernelSampler> Samplers;
	std::vector<FKernelBuffer> Buffers;
	std::vector<FKernelBuffer> RWBuffers;
	FKernelArgs Args = {};
};

} // namespace Drydock::Conformance
