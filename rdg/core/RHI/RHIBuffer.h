// A buffer of bytes: vertex, index, structured, raw or typed. Memory as FRHITexture's. Source: engine RHIResources.h;
// memory is drydock's.
#pragma once

#include "PixelFormat.h"
#include "RHITexture.h"

/** Bytes that a new buffer starts with. */
class FResourceArrayInterface
{
public:
	virtual ~FResourceArrayInterface() = default;
	virtual const void* GetResourceData() const = 0;
	virtual uint32 GetResourceDataSize() const = 0;
	virtual void Discard() {}
};

struct FRHIResourceCreateInfo
{
	FRHIResourceCreateInfo(const TCHAR* InDebugName)
		: DebugName(InDebugName)
	{
	}
	FRHIResourceCreateInfo(const TCHAR* InDebugName, FResourceArrayInterface* InResourceArray)
		: ResourceArray(InResourceArray)
		, DebugName(InDebugName)
	{
	}

	FResourceArrayInterface* ResourceArray = nullptr;
	FClearValueBinding ClearValueBinding;
	const TCHAR* DebugName;
};

class DRYDOCK_API FRHIBuffer : public FRHIViewableResource
{
public:
	FRHIBuffer(const FRHIBufferDesc& InDesc, const TCHAR* InName);

	const FRHIBufferDesc& GetDesc() const { return Desc; }
	uint32 GetSize() const { return Desc.Size; }
	uint32 GetStride() const { return Desc.Stride; }
	EBufferUsageFlags GetUsage() const { return Desc.Usage; }

	/** Bytes of memory the buffer needs, margins included. */
	static size_t ComputeSize(const FRHIBufferDesc& Desc);

	/** As FRHITexture's: memory of GetSizeInBytes() bytes, 64-byte aligned. */
	size_t GetSizeInBytes() const { return ComputeSize(Desc); }
	void PlaceAt(void* Memory) { this->Memory.PlaceAt(Memory); }
	bool HasMemory() const { return Memory.Get() != nullptr; }
	void EnsureMemory() { Memory.Ensure(GetSizeInBytes()); }

	/** First byte of the contents. */
	uint8* GetData();

	/** The buffer as a shader sees it: from FirstByte, NumBytes (0: to the end). Format: that of a typed view;
	 * PF_Unknown: structured (or raw) with the buffer's stride. */
	Drydock::FKernelBuffer GetKernelView(EPixelFormat Format = PF_Unknown, uint32 FirstByte = 0, uint32 NumBytes = 0);

	/** The counter that UAVs with these flags have; of FRHIUnorderedAccessView::GetKernelCounter. */
	Drydock::FKernelBuffer GetKernelCounter(bool bSupportsAtomicCounter, bool bSupportsAppendBuffer);

	/** All to 0: for a pool that gives the buffer to another. */
	void ClearCounters();

private:
	FRHIBufferDesc Desc;
	uint32 Counters[4] = {}; // by the two flags of views
	Drydock::FResourceMemory Memory;
};

using FRHIVertexBuffer = FRHIBuffer;
using FRHIIndexBuffer = FRHIBuffer;
using FRHIStructuredBuffer = FRHIBuffer;
using FBufferRHIRef = TRefCountPtr<FRHIBuffer>;
using FVertexBufferRHIRef = FBufferRHIRef;
using FIndexBufferRHIRef = FBufferRHIRef;
using FStructuredBufferRHIRef = FBufferRHIRef;
