// Copies read-backs at once: there is no GPU to wait for.
#include "RHIGPUReadback.h"

#include "TextureTransfer.h"

FRHIGPUMemoryReadback::~FRHIGPUMemoryReadback() = default;

void FRHIGPUMemoryReadback::Unlock()
{
	ensureMsgf(bLocked, TEXT("Unlock of a readback that is not locked"));
	bLocked = false;
}

void FRHIGPUBufferReadback::EnqueueCopy(FRHICommandList&, FRHIBuffer* SourceBuffer, uint32 NumBytes)
{
	check(SourceBuffer);
	checkf(NumBytes <= SourceBuffer->GetSize(), TEXT("readback of %u bytes of buffer %s, which has %u"), NumBytes,
		*SourceBuffer->GetName().ToString(), SourceBuffer->GetSize());
	const uint8* const Data = SourceBuffer->GetData();
	Bytes.assign(Data, Data + (NumBytes ? NumBytes : SourceBuffer->GetSize()));
	bEnqueued = true;
}

void* FRHIGPUBufferReadback::Lock(uint32 NumBytes)
{
	checkf(
		NumBytes <= Bytes.size(), TEXT("a readback of %u bytes was locked; %zu were copied"), NumBytes, Bytes.size());
	bLocked = true;
	return bEnqueued ? Bytes.data() : nullptr;
}

void FRHIGPUTextureReadback::EnqueueCopy(FRHICommandList&, FRHITexture* SourceTexture, const FIntVector& SourcePosition,
	uint32 SourceSlice, const FIntVector& Size)
{
	check(SourceTexture);
	const FIntPoint Min(SourcePosition.X, SourcePosition.Y);
	Extent = Size.X == 0 ? SourceTexture->GetSizeXY() - Min : FIntPoint(Size.X, Size.Y);
	const FIntPoint Whole = SourceTexture->GetSizeXY();
	checkf(Min.X >= 0 && Min.Y >= 0 && Extent.X > 0 && Extent.Y > 0 && Extent.X <= Whole.X - Min.X &&
			   Extent.Y <= Whole.Y - Min.Y,
		TEXT("readback of %d x %d texels at (%d, %d) of texture %s, which has %d x %d"), Extent.X, Extent.Y, Min.X,
		Min.Y, *SourceTexture->GetName().ToString(), Whole.X, Whole.Y);
	const size_t RowBytes = size_t(Extent.X) * Drydock::GetNativeTexelBytes(SourceTexture);
	const int32 Slice = SourceTexture->GetDesc().IsTexture3D() ? SourcePosition.Z : int32(SourceSlice);
	Bytes.resize(RowBytes * size_t(Extent.Y));
	Drydock::ReadNativeTexels(SourceTexture, FIntRect(Min, Min + Extent), 0, Slice, Bytes.data(), RowBytes);
	bEnqueued = true;
}

void* FRHIGPUTextureReadback::Lock(int32& OutRowPitchInPixels, int32* OutBufferHeight)
{
	OutRowPitchInPixels = Extent.X;
	if (OutBufferHeight)
	{
		*OutBufferHeight = Extent.Y;
	}
	bLocked = true;
	return bEnqueued ? Bytes.data() : nullptr;
}

void* FRHIGPUTextureReadback::Lock(uint32)
{
	int32 RowPitchInPixels;
	return Lock(RowPitchInPixels);
}
