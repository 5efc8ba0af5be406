// Views of textures (mips, slices, another format) and buffers, for reading and writing. Source: engine RHIResources.h.
#pragma once

#include <vector>

#include "RHIBuffer.h"
#include "RHITexture.h"

/** Zero counts mean "all from the first". */
struct FRHITextureSRVCreateInfo
{
	explicit FRHITextureSRVCreateInfo(
		uint8 InMipLevel = 0, uint8 InNumMipLevels = 0, EPixelFormat InFormat = PF_Unknown)
		: Format(InFormat)
		, MipLevel(InMipLevel)
		, NumMipLevels(InNumMipLevels)
	{
	}
	FRHITextureSRVCreateInfo(uint8 InMipLevel, uint8 InNumMipLevels, uint16 InFirstArraySlice, uint16 InNumArraySlices,
		EPixelFormat InFormat = PF_Unknown)
		: Format(InFormat)
		, MipLevel(InMipLevel)
		, NumMipLevels(InNumMipLevels)
		, FirstArraySlice(InFirstArraySlice)
		, NumArraySlices(InNumArraySlices)
	{
	}

	bool operator==(const FRHITextureSRVCreateInfo&) const = default;

	EPixelFormat Format;
	uint8 MipLevel;
	uint8 NumMipLevels;
	uint16 FirstArraySlice = 0;
	uint16 NumArraySlices = 0;
};

struct FRHITextureUAVCreateInfo
{
	explicit FRHITextureUAVCreateInfo(uint8 InMipLevel = 0, EPixelFormat InFormat = PF_Unknown,
		uint16 InFirstArraySlice = 0, uint16 InNumArraySlices = 0)
		: Format(InFormat)
		, MipLevel(InMipLevel)
		, FirstArraySlice(InFirstArraySlice)
		, NumArraySlices(InNumArraySlices)
	{
	}

	bool operator==(const FRHITextureUAVCreateInfo&) const = default;

	EPixelFormat Format;
	uint8 MipLevel;
	uint16 FirstArraySlice;
	uint16 NumArraySlices;
};

/** Format PF_Unknown: structured or raw. NumElements counts texels of Format, or strides. */
struct FRHIBufferSRVCreateInfo
{
	explicit FRHIBufferSRVCreateInfo(
		EPixelFormat InFormat = PF_Unknown, uint32 InStartOffsetBytes = 0, uint32 InNumElements = 0)
		: Format(InFormat)
		, StartOffsetBytes(InStartOffsetBytes)
		, NumElements(InNumElements)
	{
	}

	bool operator==(const FRHIBufferSRVCreateInfo&) const = default;

	EPixelFormat Format;
	uint32 StartOffsetBytes;
	uint32 NumElements;
};

/** One of the flags gives a view of a structured buffer a counter (FRHIUnorderedAccessView::GetKernelCounter). */
struct FRHIBufferUAVCreateInfo : FRHIBufferSRVCreateInfo
{
	using FRHIBufferSRVCreateInfo::FRHIBufferSRVCreateInfo;

	bool operator==(const FRHIBufferUAVCreateInfo&) const = default;

	bool bSupportsAtomicCounter = false; // IncrementCounter and DecrementCounter of a RWStructuredBuffer
	bool bSupportsAppendBuffer = false;  // AppendStructuredBuffer, ConsumeStructuredBuffer
};

/** Keeps its resource alive. */
class DRYDOCK_API FRHIView : public FRHIResource
{
public:
	bool IsTexture() const { return Texture.IsValid(); }
	bool IsBuffer() const { return Buffer.IsValid(); }
	FRHITexture* GetTexture() const { return Texture; }
	FRHIBuffer* GetBuffer() const { return Buffer; }

	/** A buffer seen as texels of a format, not as structures or bytes. */
	bool IsTyped() const { return Format != PF_Unknown; }

	uint32 GetFirstMip() const { return FirstMip; }
	uint32 GetNumMips() const { return NumMips; }

	/** The resource as a shader sees it through this view. The wrong kind fails a check. Valid while the view lives. */
	Drydock::FKernelTexture GetKernelTexture() const;
	Drydock::FKernelBuffer GetKernelBuffer() const;

	/** Bytes of the texels or elements in the view. */
	uint64 GetSizeInBytes() const;

protected:
	FRHIView(FRHITexture* InTexture, EPixelFormat InFormat, uint32 InFirstMip, uint32 InNumMips, uint32 InFirstSlice,
		uint32 InNumSlices);
	FRHIView(FRHIBuffer* InBuffer, const FRHIBufferSRVCreateInfo& Info);

private:
	Drydock::ETexelStorage GetViewStorage() const;
	int32 GetPlane() const { return Format == PF_X24_G8 ? 1 : 0; }

	TRefCountPtr<FRHITexture> Texture;
	TRefCountPtr<FRHIBuffer> Buffer;
	EPixelFormat Format = PF_Unknown;
	uint32 FirstMip = 0;
	uint32 NumMips = 0;
	uint32 FirstSlice = 0;
	uint32 NumSlices = 0;
	uint32 FirstByte = 0;
	uint32 NumBytes = 0;
	mutable std::vector<Drydock::FKernelMip> RangeTable; // mips of a view of some, but not all, slices
};

class DRYDOCK_API FRHIShaderResourceView final : public FRHIView
{
public:
	FRHIShaderResourceView(FRHITexture* InTexture, const FRHITextureSRVCreateInfo& Info);
	FRHIShaderResourceView(FRHIBuffer* InBuffer, const FRHIBufferSRVCreateInfo& Info);
};

class DRYDOCK_API FRHIUnorderedAccessView final : public FRHIView
{
public:
	FRHIUnorderedAccessView(FRHITexture* InTexture, const FRHITextureUAVCreateInfo& Info);
	FRHIUnorderedAccessView(FRHIBuffer* InBuffer, const FRHIBufferUAVCreateInfo& Info);

	bool SupportsAtomicCounter() const { return bSupportsAtomicCounter; }
	bool SupportsAppendBuffer() const { return bSupportsAppendBuffer; }

	/** The view's hidden counter, four bytes: how many elements were appended and not consumed, or how often it was
	 * incremented. 0 when the buffer is made, and in a buffer that a pool gives out anew; passes, graphs and frames
	 * follow on from each other. Views of a buffer with the same flags are one view, and have one counter, as the
	 * engine keeps them. Beyond the buffer's elements and below 0 it goes on (modulo 2^32), as in Direct3D. Unreal has
	 * no call that reads or sets it, and clearing the buffer leaves it as it is: a shader reads it by IncrementCounter
	 * and DecrementCounter. A view without a counter is a check. */
	Drydock::FKernelBuffer GetKernelCounter() const;

private:
	bool bSupportsAtomicCounter = false;
	bool bSupportsAppendBuffer = false;
};

using FShaderResourceViewRHIRef = TRefCountPtr<FRHIShaderResourceView>;
using FUnorderedAccessViewRHIRef = TRefCountPtr<FRHIUnorderedAccessView>;
