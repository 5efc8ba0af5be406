// Makes uniform buffers from the contents of their structs.
#include "UniformBufferBinding.h"

#include <cstring>

FRHIUniformBuffer::FRHIUniformBuffer(const FShaderParametersMetadata& InMetadata, const void* InContents)
	: Metadata(InMetadata)
{
	check(InContents);
	Contents.resize(InMetadata.GetSize() / sizeof(FBlock));
	std::memcpy(Contents.data(), InContents, InMetadata.GetSize());
}

namespace Drydock
{

FUniformBufferRHIRef CreateUniformBuffer(const FShaderParametersMetadata& Metadata, const void* Contents)
{
	return new FRHIUniformBuffer(Metadata, Contents);
}

} // namespace Drydock
