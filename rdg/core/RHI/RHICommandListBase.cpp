// Creation, locks, uploads, and the functions outside the class that forward to the immediate list. Source: engine
// RHICommandList.h, DynamicRHI.h.
#include "RHICommandList.h"

#include "PixelFormatConversion.h"
#include "TextureTransfer.h"

#include <cstring>

FRHICommandListBase::~FRHICommandListBase() = default;

FTextureRHIRef FRHICommandListBase::CreateTexture(const FRHITextureCreateDesc& Desc)
{
	return new FRHITexture(Desc, Desc.DebugName);
}

FBufferRHIRef FRHICommandListBase::CreateBuffer(
	uint32 Size, EBufferUsageFlags Usage, uint32 Stride, ERHIAccess State, const FRHIResourceCreateInfo& Info)
{
	return CreateBuffer(FRHIBufferDesc(Size, Stride, Usage), State, Info);
}

FBufferRHIRef FRHICommandListBase::CreateBuffer(
	const FRHIBufferDesc& Desc, ERHIAccess, const FRHIResourceCreateInfo& Info)
{
	FBufferRHIRef Buffer = new FRHIBuffer(Desc, Info.DebugName);
	if (Info.ResourceArray)
	{
		const uint32 NumBytes = FMath::Min(Desc.Size, Info.ResourceArray->GetResourceDataSize());
		std::memcpy(Buffer->GetData(), Info.ResourceArray->GetResourceData(), NumBytes);
		Info.ResourceArray->Discard();
	}
	return Buffer;
}

FBufferRHIRef FRHICommandListBase::CreateVertexBuffer(
	uint32 Size, EBufferUsageFlags Usage, const FRHIResourceCreateInfo& Info)
{
	return CreateBuffer(Size, Usage | EBufferUsageFlags::VertexBuffer, 0, ERHIAccess::VertexOrIndexBuffer, Info);
}

FBufferRHIRef FRHICommandListBase::CreateStructuredBuffer(
	uint32 Stride, uint32 Size, EBufferUsageFlags Usage, const FRHIResourceCreateInfo& Info)
{
	return CreateBuffer(Size, Usage | EBufferUsageFlags::StructuredBuffer, Stride, ERHIAccess::SRVMask, Info);
}

FShaderResourceViewRHIRef FRHICommandListBase::CreateShaderResourceView(
	FRHITexture* Texture, const FRHITextureSRVCreateInfo& Info)
{
	return new FRHIShaderResourceView(Texture, Info);
}

FShaderResourceViewRHIRef FRHICommandListBase::CreateShaderResourceView(FRHITexture* Texture, uint8 MipLevel)
{
	return new FRHIShaderResourceView(Texture, FRHITextureSRVCreateInfo(MipLevel, 1));
}

FShaderResourceViewRHIRef FRHICommandListBase::CreateShaderResourceView(FRHIBuffer* Buffer)
{
	return new FRHIShaderResourceView(Buffer, FRHIBufferSRVCreateInfo());
}

FShaderResourceViewRHIRef FRHICommandListBase::CreateShaderResourceView(FRHIBuffer* Buffer, uint32, EPixelFormat Format)
{
	return new FRHIShaderResourceView(Buffer, FRHIBufferSRVCreateInfo(Format));
}

FUnorderedAccessViewRHIRef FRHICommandListBase::CreateUnorderedAccessView(FRHITexture* Texture, uint32 MipLevel)
{
	return new FRHIUnorderedAccessView(Texture, FRHITextureUAVCreateInfo(uint8(MipLevel)));
}

FUnorderedAccessViewRHIRef FRHICommandListBase::CreateUnorderedAccessView(FRHIBuffer* Buffer, EPixelFormat Format)
{
	return new FRHIUnorderedAccessView(Buffer, FRHIBufferUAVCreateInfo(Format));
}

FUnorderedAccessViewRHIRef FRHICommandListBase::CreateUnorderedAccessView(
	FRHIBuffer* Buffer, bool bUseUAVCounter, bool bAppendBuffer)
{
	FRHIBufferUAVCreateInfo Info;
	Info.bSupportsAtomicCounter = bUseUAVCounter;
	Info.bSupportsAppendBuffer = bAppendBuffer;
	return new FRHIUnorderedAccessView(Buffer, Info);
}

void* FRHICommandListBase::LockBuffer(FRHIBuffer* Buffer, uint32 Offset, uint32 Size, EResourceLockMode)
{
	check(Buffer);
	checkf(uint64(Offset) + Size <= Buffer->GetSize(), TEXT("buffer %s has %u bytes; %u at %u were locked"),
		*Buffer->GetName().ToString(), Buffer->GetSize(), Size, Offset);
	return Buffer->GetData() + Offset;
}

void FRHICommandListBase::UnlockBuffer(FRHIBuffer* Buffer)
{
	check(Buffer);
}

void* FRHICommandListBase::LockTexture2D(
	FRHITexture* Texture, uint32 MipIndex, EResourceLockMode Mode, uint32& OutStride, bool)
{
	check(Texture);
	const auto [Entry, bInserted] = LockedTextures.try_emplace(Texture);
	checkf(bInserted, TEXT("texture %s is locked already"), *Texture->GetName().ToString());
	FLockedTexture& Locked = Entry->second;
	Locked.MipIndex = MipIndex;
	Locked.Mode = Mode;
	const Drydock::FTextureMipLayout& At = Texture->GetMipLayout(int32(MipIndex));
	if (!Texture->IsWidened())
	{
		OutStride = uint32(At.RowPitch);
		return Texture->GetTexel(0, 0, int32(MipIndex));
	}

	Locked.Pitch = uint32(At.SizeX) * Drydock::GetNativeTexelBytes(Texture);
	Locked.Staging.resize(size_t(Locked.Pitch) * At.SizeY);
	const FIntRect Whole(0, 0, At.SizeX, At.SizeY);
	Drydock::ReadNativeTexels(Texture, Whole, int32(MipIndex), 0, Locked.Staging.data(), Locked.Pitch);
	OutStride = Locked.Pitch;
	return Locked.Staging.data();
}

void FRHICommandListBase::UnlockTexture2D(FRHITexture* Texture, uint32 MipIndex, bool)
{
	check(Texture);
	const auto Entry = LockedTextures.find(Texture);
	checkf(Entry != LockedTextures.end() && Entry->second.MipIndex == MipIndex,
		TEXT("texture %s is not locked at mip %u"), *Texture->GetName().ToString(), MipIndex);
	const FLockedTexture& Locked = Entry->second;
	if (!Locked.Staging.empty() && Locked.Mode != RLM_ReadOnly)
	{
		const Drydock::FTextureMipLayout& At = Texture->GetMipLayout(int32(MipIndex));
		const FIntRect Whole(0, 0, At.SizeX, At.SizeY);
		Drydock::WriteNativeTexels(Texture, Whole, int32(MipIndex), 0, Locked.Staging.data(), Locked.Pitch);
	}
	Texture->Touch(); // what was written since the lock
	LockedTextures.erase(Entry);
}

void FRHICommandListBase::UpdateTexture2D(FRHITexture* Texture, uint32 MipIndex, const FUpdateTextureRegion2D& Region,
	uint32 SourcePitch, const uint8* SourceData)
{
	check(Texture && SourceData);
	if (Region.Width == 0 || Region.Height == 0)
	{
		return;
	}
	const FIntPoint Min(int32(Region.DestX), int32(Region.DestY));
	const FIntRect Rect(Min, Min + FIntPoint(int32(Region.Width), int32(Region.Height)));
	Drydock::WriteNativeTexels(Texture, Rect, int32(MipIndex), 0, SourceData, SourcePitch);
}

FRHICommandListImmediate& FRHICommandListExecutor::GetImmediateCommandList()
{
	static FRHICommandListImmediate List;
	return List;
}

namespace
{

FRHICommandListImmediate& GetImmediate()
{
	return FRHICommandListExecutor::GetImmediateCommandList();
}

} // namespace

FTextureRHIRef RHICreateTexture(const FRHITextureCreateDesc& Desc)
{
	return GetImmediate().CreateTexture(Desc);
}

FBufferRHIRef RHICreateBuffer(
	uint32 Size, EBufferUsageFlags Usage, uint32 Stride, ERHIAccess State, const FRHIResourceCreateInfo& Info)
{
	return GetImmediate().CreateBuffer(Size, Usage, Stride, State, Info);
}

FBufferRHIRef RHICreateVertexBuffer(uint32 Size, EBufferUsageFlags Usage, const FRHIResourceCreateInfo& Info)
{
	return GetImmediate().CreateVertexBuffer(Size, Usage, Info);
}

FBufferRHIRef RHICreateStructuredBuffer(
	uint32 Stride, uint32 Size, EBufferUsageFlags Usage, const FRHIResourceCreateInfo& Info)
{
	return GetImmediate().CreateStructuredBuffer(Stride, Size, Usage, Info);
}

FShaderResourceViewRHIRef RHICreateShaderResourceView(FRHITexture* Texture, uint8 MipLevel)
{
	return GetImmediate().CreateShaderResourceView(Texture, MipLevel);
}

FShaderResourceViewRHIRef RHICreateShaderResourceView(FRHITexture* Texture, const FRHITextureSRVCreateInfo& Info)
{
	return GetImmediate().CreateShaderResourceView(Texture, Info);
}

FShaderResourceViewRHIRef RHICreateShaderResourceView(FRHIBuffer* Buffer)
{
	return GetImmediate().CreateShaderResourceView(Buffer);
}

FUnorderedAccessViewRHIRef RHICreateUnorderedAccessView(FRHITexture* Texture, uint32 MipLevel)
{
	return GetImmediate().CreateUnorderedAccessView(Texture, MipLevel);
}

FUnorderedAccessViewRHIRef RHICreateUnorderedAccessView(FRHIBuffer* Buffer, EPixelFormat Format)
{
	return GetImmediate().CreateUnorderedAccessView(Buffer, Format);
}

FUnorderedAccessViewRHIRef RHICreateUnorderedAccessView(FRHIBuffer* Buffer, bool bUseUAVCounter, bool bAppendBuffer)
{
	return GetImmediate().CreateUnorderedAccessView(Buffer, bUseUAVCounter, bAppendBuffer);
}

void* RHILockBuffer(FRHIBuffer* Buffer, uint32 Offset, uint32 Size, EResourceLockMode Mode)
{
	return GetImmediate().LockBuffer(Buffer, Offset, Size, Mode);
}

void RHIUnlockBuffer(FRHIBuffer* Buffer)
{
	GetImmediate().UnlockBuffer(Buffer);
}

void* RHILockTexture2D(
	FRHITexture* Texture, uint32 MipIndex, EResourceLockMode Mode, uint32& OutStride, bool bLockWithinMiptail, bool)
{
	return GetImmediate().LockTexture2D(Texture, MipIndex, Mode, OutStride, bLockWithinMiptail);
}

void RHIUnlockTexture2D(FRHITexture* Texture, uint32 MipIndex, bool bLockWithinMiptail, bool)
{
	GetImmediate().UnlockTexture2D(Texture, MipIndex, bLockWithinMiptail);
}

void RHIUpdateTexture2D(FRHITexture* Texture, uint32 MipIndex, const FUpdateTextureRegion2D& Region, uint32 SourcePitch,
	const uint8* SourceData)
{
	GetImmediate().UpdateTexture2D(Texture, MipIndex, Region, SourcePitch, SourceData);
}
