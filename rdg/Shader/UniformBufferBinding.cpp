// The contents of uniform buffers. Source: drydock.
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
