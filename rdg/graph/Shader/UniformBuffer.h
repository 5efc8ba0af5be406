// Uniform buffers outside the graph, kept by their owner and refilled. Source: engine UniformBuffer.h.
#pragma once

#include "ShaderParameterMacros.h"

/** A uniform buffer with its contents on the side; each SetContents makes a new buffer, so passes keep what they were
 * given. */
template<typename TBufferStruct>
class TUniformBuffer
{
public:
	const TBufferStruct& GetContents() const { return Contents; }

	void SetContents(const TBufferStruct& NewContents)
	{
		Contents = NewContents;
		Buffer = TUniformBufferRef<TBufferStruct>::CreateUniformBufferImmediate(Contents, UniformBuffer_MultiFrame);
	}

	/** Null before the first SetContents. */
	const TUniformBufferRef<TBufferStruct>& GetUniformBufferRef() const { return Buffer; }
	FRHIUniformBuffer* GetUniformBufferRHI() const { return Buffer.GetReference(); }

private:
	TBufferStruct Contents{};
	TUniformBufferRef<TBufferStruct> Buffer;
};
