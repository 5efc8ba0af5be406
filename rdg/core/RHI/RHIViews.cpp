// Makes views: ranges of mips and slices, and formats that reinterpret a texel.
#include "RHIViews.h"

#include "PixelFormatConversion.h"

FRHIView::FRHIView(FRHITexture* InTexture, EPixelFormat InFormat, uint32 InFirstMip, uint32 InNumMips,
	uint32 InFirstSlice, uint32 InNumSlices)
	: Texture(InTexture)
	, Format(InFormat)
	, FirstMip(InFirstMip)
	, NumMips(InNumMips)
	, FirstSlice(InFirstSlice)
	, NumSlices(InNumSlices)
{
	checkf(InTexture, TEXT("a view needs a texture"));
	checkf(Format < PF_MAX, TEXT("a view of texture %s has no format"), *Texture->GetName().ToString());
	const FRHITextureDesc& Desc = Texture->GetDesc();
	const TCHAR* const What = TEXT("a view of texture %s goes beyond its mips or slices");
	checkf(FirstMip < Desc.NumMips, What, *Texture->GetName().ToString());
	NumMips = NumMips ? NumMips : Desc.NumMips - FirstMip;
	const uint32 AllSlices = uint32(Texture->GetMipLayout(int32(FirstMip)).SizeZ);
	checkf(FirstSlice < AllSlices, What, *Texture->GetName().ToString());
	NumSlices = NumSlices ? NumSlices : AllSlices - FirstSlice;
	checkf(FirstMip + NumMips <= Desc.NumMips && FirstSlice + NumSlices <= AllSlices, What,
		*Texture->GetName().ToString());
	GetViewStorage();
}

FRHIView::FRHIView(FRHIBuffer* InBuffer, const FRHIBufferSRVCreateInfo& Info)
	: Buffer(InBuffer)
	, Format(Info.Format)
	, FirstByte(Info.StartOffsetBytes)
{
	checkf(InBuffer, TEXT("a view needs a buffer"));
	checkf(Format < PF_MAX, TEXT("a view of buffer %s has no format"), *Buffer->GetName().ToString());
	const uint32 ElementBytes =
		Format != PF_Unknown ? uint32(GPixelFormats[Format].BlockBytes) : FMath::Max(1u, Buffer->GetStride());
	NumBytes = Info.NumElements * ElementBytes;
	checkf(uint64(FirstByte) + uint64(Info.NumElements) * ElementBytes <= Buffer->GetSize(),
		TEXT("a view of buffer %s goes beyond its %u bytes"), *Buffer->GetName().ToString(), Buffer->GetSize());
}

Drydock::ETexelStorage FRHIView::GetViewStorage() const
{
	const Drydock::ETexelStorage Stored = Texture->GetStorage(GetPlane() < Texture->GetNumPlanes() ? GetPlane() : 0);
	if (Format == PF_Unknown || Format == Texture->GetFormat() || (Format == PF_X24_G8 && Texture->GetNumPlanes() > 1))
	{
		return Stored;
	}
	const Drydock::FTexelStorageInfo& StoredInfo = Drydock::GetTexelStorageInfo(Stored);
	const Drydock::FTexelStorageInfo& ViewInfo = Drydock::GetTexelStorageInfo(GPixelFormats[Format].Storage);
	if (Texture->IsWidened() && ViewInfo.Kind != Drydock::ETexelKind::Uint &&
		ViewInfo.NumChannels == StoredInfo.NumChannels)
	{
		return Stored; // widened texels have no encoding to reinterpret
	}
	checkf(GPixelFormats[Format].Supported && ViewInfo.BytesPerTexel == StoredInfo.BytesPerTexel,
		TEXT("texture %s (%s) cannot be viewed as %s: texels differ in size%s"), *Texture->GetName().ToString(),
		GetPixelFormatString(Texture->GetFormat()), GetPixelFormatString(Format),
		Texture->IsWidened() ? TEXT(" (r.Drydock.Storage widened it)") : TEXT(""));
	return GPixelFormats[Format].Storage;
}

Drydock::FKernelTexture FRHIView::GetKernelTexture() const
{
	checkf(IsTexture(), TEXT("the view of buffer %s is used as a texture"), *Buffer->GetName().ToString());
	const int32 Mip = int32(FirstMip);
	const uint32 AllSlices = uint32(Texture->GetMipLayout(Mip).SizeZ);
	Drydock::FKernelTexture View = Texture->GetKernelView(Mip, int32(NumMips), -1, GetPlane());
	View.Storage = GetViewStorage();
	if (FirstSlice > 0 || NumSlices < AllSlices)
	{
		RangeTable.assign(View.Mips, View.Mips + NumMips);
		for (Drydock::FKernelMip& Level : RangeTable)
		{
			Level.Data += int64(FirstSlice) * Level.SlicePitch;
			Level.SizeZ = int32(NumSlices);
		}
		View.Mips = RangeTable.data();
	}
	return View;
}

Drydock::FKernelBuffer FRHIView::GetKernelBuffer() const
{
	checkf(IsBuffer(), TEXT("the view of texture %s is used as a buffer"), *Texture->GetName().ToString());
	return Buffer->GetKernelView(Format, FirstByte, NumBytes);
}

uint64 FRHIView::GetSizeInBytes() const
{
	if (IsBuffer())
	{
		return NumBytes ? NumBytes : Buffer->GetSize() - FirstByte;
	}
	uint64 Bytes = 0;
	const uint64 TexelBytes = Drydock::GetTexelStorageInfo(GetViewStorage()).BytesPerTexel;
	for (uint32 Mip = FirstMip; Mip < FirstMip + NumMips; ++Mip)
	{
		const Drydock::FTextureMipLayout& At = Texture->GetMipLayout(int32(Mip));
		const uint64 Slices = Texture->GetDesc().IsTexture3D() ? uint64(At.SizeZ) : NumSlices;
		Bytes += TexelBytes * uint64(At.SizeX) * uint64(At.SizeY) * Slices;
	}
	return Bytes;
}

FRHIShaderResourceView::FRHIShaderResourceView(FRHITexture* InTexture, const FRHITextureSRVCreateInfo& Info)
	: FRHIView(InTexture, Info.Format, Info.MipLevel, Info.NumMipLevels, Info.FirstArraySlice, Info.NumArraySlices)
{
}

FRHIShaderResourceView::FRHIShaderResourceView(FRHIBuffer* InBuffer, const FRHIBufferSRVCreateInfo& Info)
	: FRHIView(InBuffer, Info)
{
}

FRHIUnorderedAccessView::FRHIUnorderedAccessView(FRHITexture* InTexture, const FRHITextureUAVCreateInfo& Info)
	: FRHIView(InTexture,
		  Info.Format != PF_Unknown ? Info.Format : (InTexture ? InTexture->GetDesc().UAVFormat : PF_Unknown),
		  Info.MipLevel, 1, Info.FirstArraySlice, Info.NumArraySlices)
{
}

FRHIUnorderedAccessView::FRHIUnorderedAccessView(FRHIBuffer* InBuffer, const FRHIBufferUAVCreateInfo& Info)
	: FRHIView(InBuffer, Info)
	, bSupportsAtomicCounter(Info.bSupportsAtomicCounter)
	, bSupportsAppendBuffer(Info.bSupportsAppendBuffer)
{
	const bool bStructured = EnumHasAnyFlags(InBuffer->GetUsage(), EBufferUsageFlags::StructuredBuffer) && !IsTyped();
	checkf(bStructured || !(bSupportsAtomicCounter || bSupportsAppendBuffer),
		TEXT("a view of buffer %s has a counter, and the buffer is not structured"), *InBuffer->GetName().ToString());
}

Drydock::FKernelBuffer FRHIUnorderedAccessView::GetKernelCounter() const
{
	checkf(bSupportsAtomicCounter || bSupportsAppendBuffer, TEXT("the view has no counter"));
	return GetBuffer()->GetKernelCounter(bSupportsAtomicCounter, bSupportsAppendBuffer);
}
