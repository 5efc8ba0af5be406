// Allocates the memory of buffers and makes the kernel's views of it.
#include "RHIBuffer.h"

#include "PixelFormatConversion.h"

#include <algorithm>

FRHIBuffer::FRHIBuffer(const FRHIBufferDesc& InDesc, const TCHAR* InName)
	: FRHIViewableResource(InName)
	, Desc(InDesc)
{
	checkf(Desc.Size > 0, TEXT("buffer %s cannot be created: it has no bytes"), InName);
}

size_t FRHIBuffer::ComputeSize(const FRHIBufferDesc& Desc)
{
	const size_t Margins = 2 * Drydock::GTextureAlignment;
	return (Desc.Size + Margins + Drydock::GTextureAlignment - 1) / Drydock::GTextureAlignment *
		   Drydock::GTextureAlignment;
}

uint8* FRHIBuffer::GetData()
{
	EnsureMemory();
	return Memory.Get() + Drydock::GTextureAlignment;
}

Drydock::FKernelBuffer FRHIBuffer::GetKernelView(EPixelFormat Format, uint32 FirstByte, uint32 NumBytes)
{
	const uint32 ViewBytes = NumBytes == 0 && FirstByte < Desc.Size ? Desc.Size - FirstByte : NumBytes;
	checkf(ViewBytes > 0 && uint64(FirstByte) + ViewBytes <= Desc.Size,
		TEXT("buffer %s has %u bytes, none at %u to %llu"), *GetName().ToString(), Desc.Size, FirstByte,
		(unsigned long long)FirstByte + ViewBytes);

	Drydock::FKernelBuffer View{};
	View.Data = GetData() + FirstByte;
	View.SizeInBytes = ViewBytes;
	View.Stride = Desc.Stride;
	View.Storage = Drydock::ETexelStorage::R32_UINT;
	if (Format != PF_Unknown)
	{
		checkf(GPixelFormats[Format].Supported, TEXT("buffer %s: the view's format has no storage"),
			*GetName().ToString());
		View.Storage = GPixelFormats[Format].Storage;
		View.Stride = uint32(GPixelFormats[Format].BlockBytes);
	}
	return View;
}

Drydock::FKernelBuffer FRHIBuffer::GetKernelCounter(bool bSupportsAtomicCounter, bool bSupportsAppendBuffer)
{
	Drydock::FKernelBuffer View{};
	View.Data = reinterpret_cast<uint8*>(&Counters[(bSupportsAtomicCounter ? 1 : 0) + (bSupportsAppendBuffer ? 2 : 0)]);
	View.SizeInBytes = sizeof(uint32);
	View.Stride = sizeof(uint32);
	View.Storage = Drydock::ETexelStorage::R32_UINT;
	return View;
}

void FRHIBuffer::ClearCounters()
{
	std::fill(std::begin(Counters), std::end(Counters), 0u);
}
