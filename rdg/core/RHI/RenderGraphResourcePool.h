// Buffers that outlive graphs: their description, what a graph registers and extracts, and the pool.
// Source: engine RenderGraphResources.h, RenderGraphResourcePool.h.
#pragma once

#include "RHIResources.h"

/** A buffer's size and use. */
struct FRDGBufferDesc
{
	static FRDGBufferDesc CreateIndirectDesc(uint32 InBytesPerElement, uint32 InNumElements)
	{
		return FRDGBufferDesc(InBytesPerElement, InNumElements,
			EBufferUsageFlags::Static | EBufferUsageFlags::DrawIndirect | EBufferUsageFlags::UnorderedAccess |
				EBufferUsageFlags::ShaderResource | EBufferUsageFlags::VertexBuffer);
	}
	static FRDGBufferDesc CreateIndirectDesc(uint32 InNumElements = 1) { return CreateIndirectDesc(4, InNumElements); }

	static FRDGBufferDesc CreateStructuredDesc(uint32 InBytesPerElement, uint32 InNumElements)
	{
		return FRDGBufferDesc(InBytesPerElement, InNumElements,
			EBufferUsageFlags::Static | EBufferUsageFlags::UnorderedAccess | EBufferUsageFlags::ShaderResource |
				EBufferUsageFlags::StructuredBuffer);
	}
	template<typename T>
	static FRDGBufferDesc CreateStructuredDesc(uint32 InNumElements)
	{
		return CreateStructuredDesc(sizeof(T), InNumElements);
	}

	/** Typed: read and written through a format. */
	static FRDGBufferDesc CreateBufferDesc(uint32 InBytesPerElement, uint32 InNumElements)
	{
		return FRDGBufferDesc(InBytesPerElement, InNumElements,
			EBufferUsageFlags::Static | EBufferUsageFlags::UnorderedAccess | EBufferUsageFlags::ShaderResource |
				EBufferUsageFlags::VertexBuffer);
	}
	template<typename T>
	static FRDGBufferDesc CreateBufferDesc(uint32 InNumElements)
	{
		return CreateBufferDesc(sizeof(T), InNumElements);
	}

	static FRDGBufferDesc CreateByteAddressDesc(uint32 InNumBytes)
	{
		check(InNumBytes % 4 == 0);
		return FRDGBufferDesc(4, InNumBytes / 4,
			EBufferUsageFlags::Static | EBufferUsageFlags::UnorderedAccess | EBufferUsageFlags::ShaderResource |
				EBufferUsageFlags::ByteAddressBuffer | EBufferUsageFlags::StructuredBuffer);
	}

	static FRDGBufferDesc CreateUploadDesc(uint32 InBytesPerElement, uint32 InNumElements)
	{
		return FRDGBufferDesc(
			InBytesPerElement, InNumElements, EBufferUsageFlags::Static | EBufferUsageFlags::ShaderResource);
	}
	static FRDGBufferDesc CreateStructuredUploadDesc(uint32 InBytesPerElement, uint32 InNumElements)
	{
		return FRDGBufferDesc(InBytesPerElement, InNumElements,
			EBufferUsageFlags::Static | EBufferUsageFlags::ShaderResource | EBufferUsageFlags::StructuredBuffer);
	}

	FRDGBufferDesc() = default;
	FRDGBufferDesc(uint32 InBytesPerElement, uint32 InNumElements, EBufferUsageFlags InUsage = EBufferUsageFlags::None)
		: Usage(InUsage)
		, BytesPerElement(InBytesPerElement)
		, NumElements(InNumElements)
	{
	}

	/** Bytes. */
	uint32 GetSize() const { return BytesPerElement * NumElements; }

	bool operator==(const FRDGBufferDesc& Other) const = default;

	EBufferUsageFlags Usage = EBufferUsageFlags::None;
	uint32 BytesPerElement = 1;
	uint32 NumElements = 1;
};

/** The RHI description of a graph buffer: structured and raw buffers have a stride, typed ones do not. */
inline FRHIBufferDesc Translate(const FRDGBufferDesc& Desc)
{
	const bool bHasStride =
		EnumHasAnyFlags(Desc.Usage, EBufferUsageFlags::StructuredBuffer | EBufferUsageFlags::ByteAddressBuffer);
	return FRHIBufferDesc(Desc.GetSize(), bHasStride ? Desc.BytesPerElement : 0, Desc.Usage);
}

/** A buffer that a graph can register and extract. Held by the pool alone, it is free. */
class DRYDOCK_API FRDGPooledBuffer final : public FRefCountBase
{
public:
	FRDGPooledBuffer(TRefCountPtr<FRHIBuffer> InBuffer, const FRDGBufferDesc& InDesc, const TCHAR* InName)
		: Desc(InDesc)
		, Buffer(MoveTemp(InBuffer))
		, Name(InName)
	{
	}

	FRHIBuffer* GetRHI() const { return Buffer; }
	const FRDGBufferDesc& GetDesc() const { return Desc; }
	uint32 GetSize() const { return Desc.GetSize(); }
	uint32 GetAlignedSize() const { return Desc.GetSize(); }
	const TCHAR* GetName() const { return Name; }

	FRDGBufferDesc Desc;

private:
	friend class FRDGBufferPool;

	TRefCountPtr<FRHIBuffer> Buffer;
	const TCHAR* Name;
	uint32 NumUnusedFrames = 0;
};

class DRYDOCK_API FRDGBufferPool
{
public:
	/** A free buffer of exactly that description, or a new one. Contents are whatever the last user left; counters
	 * of its views are 0. */
	TRefCountPtr<FRDGPooledBuffer> FindFreeBuffer(const FRDGBufferDesc& Desc, const TCHAR* Name);

	/** End of a frame: forgets buffers unused for some frames. */
	void TickPoolElements();

	/** Forgets every free buffer. */
	void FreeUnusedResources();

	int32 GetNumBuffers() const { return Buffers.Num(); }

private:
	TArray<TRefCountPtr<FRDGPooledBuffer>> Buffers;
};

extern DRYDOCK_API FRDGBufferPool GRenderGraphResourcePool;
