// Moving texels between textures and plain memory, converting where a texture is stored wider than its format. Inner to
// the command list.
#pragma once

#include "RHIResources.h"

namespace Drydock
{

/** Reads texels [X, X+Width) x [Y, Y+Height) of a mip and slice into Dest as the texture's own format lays them out. */
void ReadNativeTexels(FRHITexture* Texture, FIntRect Rect, int32 Mip, int32 Slice, uint8* Dest, size_t DestPitch);

/** The reverse. */
void WriteNativeTexels(
	FRHITexture* Texture, FIntRect Rect, int32 Mip, int32 Slice, const uint8* Source, size_t SourcePitch);

/** Bytes of one texel in the texture's own format. */
uint32 GetNativeTexelBytes(const FRHITexture* Texture);

/** FRHICommandList::CopyTexture. Returns the number of texels copied. */
uint64 CopyTextureRegion(FRHITexture* Source, FRHITexture* Dest, const FRHICopyTextureInfo& Info);

/** FRHICommandListImmediate::ReadSurfaceData. */
void ReadSurface(
	FRHITexture* Texture, FIntRect Rect, TArray<FLinearColor>& OutData, const FReadSurfaceDataFlags& Flags);
void ReadSurface(FRHITexture* Texture, FIntRect Rect, TArray<FColor>& OutData, const FReadSurfaceDataFlags& Flags);

/** Clears every texel or element of the view; texels convert as the format stores. Returns how many. */
uint64 ClearView(const FRHIUnorderedAccessView* View, const FVector4f& Value);
uint64 ClearView(const FRHIUnorderedAccessView* View, const FUintVector4& Value);

} // namespace Drydock
