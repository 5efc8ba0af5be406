// Read-backs. The copy is made when it is enqueued, so it is ready at once. Source: engine RHIGPUReadback.h.
#pragma once

#include <vector>

#include "RHICommandList.h"

class DRYDOCK_API FRHIGPUMemoryReadback
{
public:
	explicit FRHIGPUMemoryReadback(FName InRequestName)
		: RequestName(InRequestName)
	{
	}
	virtual ~FRHIGPUMemoryReadback();

	/** Something was enqueued. */
	bool IsReady() const { return bEnqueued; }
	bool IsReady(uint32) const { return bEnqueued; }
	FName GetName() const { return RequestName; }
	void Wait(FRHICommandListImmediate&, uint32) {}

	/** The bytes, and again until Unlock. Null when nothing was enqueued. */
	virtual void* Lock(uint32 NumBytes) = 0;
	virtual void Unlock();

protected:
	std::vector<uint8> Bytes;
	bool bEnqueued = false;
	bool bLocked = false;

private:
	FName RequestName;
};

class DRYDOCK_API FRHIGPUBufferReadback final : public FRHIGPUMemoryReadback
{
public:
	using FRHIGPUMemoryReadback::FRHIGPUMemoryReadback;

	/** Copies the first NumBytes of the buffer; 0: all. */
	void EnqueueCopy(FRHICommandList& RHICmdList, FRHIBuffer* SourceBuffer, uint32 NumBytes = 0);

	void* Lock(uint32 NumBytes) override;
	uint64 GetGPUSizeBytes() const { return Bytes.size(); }
};

class DRYDOCK_API FRHIGPUTextureReadback final : public FRHIGPUMemoryReadback
{
public:
	using FRHIGPUMemoryReadback::FRHIGPUMemoryReadback;

	/** Copies mip 0 of a texture, or the box at SourcePosition (Size 0: the rest of the texture), of one slice. Texels
	 * arrive in the texture's own format, whatever r.Drydock.Storage is. */
	void EnqueueCopy(FRHICommandList& RHICmdList, FRHITexture* SourceTexture,
		const FIntVector& SourcePosition = FIntVector(0, 0, 0), uint32 SourceSlice = 0,
		const FIntVector& Size = FIntVector(0, 0, 0));

	/** Rows lie OutRowPitchInPixels texels apart. */
	void* Lock(int32& OutRowPitchInPixels, int32* OutBufferHeight = nullptr);
	void* Lock(uint32 NumBytes) override;

private:
	FIntPoint Extent = FIntPoint(0, 0);
};
