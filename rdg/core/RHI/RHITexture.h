// A texture: a description and memory holding its texels in their real format. Memory comes with the first touch, or is
// given by PlaceAt (the graph's transient heap). Source: engine RHIResources.h; memory and texel access are drydock's.
#pragma once

#include <atomic>
#include <vector>

#include "Misc/EngineApi.h"
#include "RHIResource.h"
#include "RHITextureDesc.h"
#include "ShaderKernel.h"
#include "TexelBlock.h"
#include "TextureLayout.h"

/** A resource that views can be made of. */
class DRYDOCK_API FRHIViewableResource : public FRHIResource
{
public:
	explicit FRHIViewableResource(const TCHAR* InName)
		: Name(InName)
	{
	}

	FName GetName() const { return Name; }
	void SetName(FName InName) { Name = InName; }

private:
	FName Name;
};

class DRYDOCK_API FRHITexture : public FRHIViewableResource
{
public:
	/** Desc must be valid (checked). Storage follows r.Drydock.Storage at this moment. */
	FRHITexture(const FRHITextureDesc& InDesc, const TCHAR* InName);

	const FRHITextureDesc& GetDesc() const { return Desc; }
	EPixelFormat GetFormat() const { return Desc.Format; }
	ETextureCreateFlags GetFlags() const { return Desc.Flags; }
	uint32 GetNumMips() const { return Desc.NumMips; }
	uint32 GetNumSamples() const { return Desc.NumSamples; }
	bool IsMultisampled() const { return Desc.NumSamples > 1; }
	uint32 GetSizeX() const { return uint32(Desc.Extent.X); }
	uint32 GetSizeY() const { return uint32(Desc.Extent.Y); }
	uint32 GetSizeZ() const { return Desc.IsTexture3D() ? Desc.Depth : Desc.ArraySize; }
	FIntPoint GetSizeXY() const { return Desc.Extent; }
	FIntVector GetSizeXYZ() const { return FIntVector(Desc.Extent.X, Desc.Extent.Y, int32(GetSizeZ())); }
	FIntVector GetMipDimensions(uint8 MipIndex) const;

	const FClearValueBinding& GetClearBinding() const { return Desc.ClearValue; }
	bool HasClearValue() const { return Desc.ClearValue.ColorBinding != EClearBinding::ENoneBound; }
	FLinearColor GetClearColor() const { return Desc.ClearValue.GetClearColor(); }

	FRHITexture* GetTexture2D() { return Desc.Dimension == ETextureDimension::Texture2D ? this : nullptr; }
	FRHITexture* GetTexture2DArray() { return Desc.Dimension == ETextureDimension::Texture2DArray ? this : nullptr; }
	FRHITexture* GetTexture3D() { return Desc.IsTexture3D() ? this : nullptr; }
	FRHITexture* GetTextureCube() { return Desc.IsTextureCube() ? this : nullptr; }

	/** Bytes a texture created now would need, margins included. */
	static size_t ComputeSize(const FRHITextureDesc& Desc);

	size_t GetSizeInBytes() const { return Layout.SizeInBytes; }
	Drydock::ETexelStorage GetStorage(int32 Plane = 0) const { return Layout.Planes[Plane].Storage; }
	const Drydock::FTextureMipLayout& GetMipLayout(int32 Mip, int32 Plane = 0) const
	{
		return Layout.Planes[Plane].Mips[Mip];
	}
	int32 GetNumPlanes() const { return int32(Layout.Planes.size()); }

	/** Storage differs from the format's own (r.Drydock.Storage). */
	bool IsWidened() const { return GetStorage() != Drydock::GetNativeTexelStorage(Desc); }

	/** Puts the texels at Memory: GetSizeInBytes() bytes, 64-byte aligned, that outlive their use. Contents are taken
	 * as they are. Views taken before follow. */
	void PlaceAt(void* Memory);
	bool HasMemory() const { return Memory.Get() != nullptr; }

	/** Allocates zeroed memory unless there is some. Every access below does. */
	void EnsureMemory();

	/** The texture as a shader sees it. NumMips < 0: all from FirstMip. Slice >= 0: that array layer or depth slice as
	 * a 2D texture. Plane 1: the stencil of a depth-stencil texture. Valid while this texture lives. Whoever writes
	 * through it beside draws and dispatches calls Touch then. */
	Drydock::FKernelTexture GetKernelView(int32 FirstMip = 0, int32 NumMips = -1, int32 Slice = -1, int32 Plane = 0);

	/** Address of a texel, to be written at once (else call Touch then). Indices are checked. */
	uint8* GetTexel(int32 X, int32 Y, int32 Mip = 0, int32 Z = 0, int32 Plane = 0)
	{
		Touch();
		return FindTexel(X, Y, Mip, Z, Plane);
	}
	/** The same for those who only read. */
	const uint8* GetTexelToRead(int32 X, int32 Y, int32 Mip = 0, int32 Z = 0, int32 Plane = 0)
	{
		return FindTexel(X, Y, Mip, Z, Plane);
	}

	/** Texels may be others from here on: their hashes are not known. From any thread. */
	void Touch()
	{
		if (!bTouched.load(std::memory_order_relaxed))
		{
			bTouched.store(true, std::memory_order_relaxed);
		}
	}
	/** A hash of all texels of a mip; computed where it is not known. */
	Drydock::FMemoryHash GetMipHash(int32 Mip, int32 Plane = 0);
	/** For who has written all of the mip's texels, or some of them (a hash that is not known). */
	void SetMipHash(int32 Mip, int32 Plane, const Drydock::FMemoryHash& Hash);
	/** The hashes of all textures: something wrote a texture, and nobody knows which. */
	static void ForgetMipHashes();
	/** The mip and plane that an address is in; false: none. */
	bool FindMip(const uint8* Address, int32& OutMip, int32& OutPlane) const;

	/** One texel, converted as a shader's load and store convert. Z is a depth slice or an array layer. */
	FLinearColor ReadTexel(int32 X, int32 Y, int32 Mip = 0, int32 Z = 0);
	void WriteTexel(int32 X, int32 Y, const FLinearColor& Value, int32 Mip = 0, int32 Z = 0);
	FVector4 ReadTexelDouble(int32 X, int32 Y, int32 Mip = 0, int32 Z = 0);
	void WriteTexelDouble(int32 X, int32 Y, const FVector4& Value, int32 Mip = 0, int32 Z = 0);

	/** Integer formats, bit for bit. */
	FUintVector4 ReadTexelUint(int32 X, int32 Y, int32 Mip = 0, int32 Z = 0);
	void WriteTexelUint(int32 X, int32 Y, const FUintVector4& Value, int32 Mip = 0, int32 Z = 0);

	/** Texels [X, X + Colors.Num()) of a row. */
	void ReadRow(int32 X, int32 Y, TArrayView<FLinearColor> OutColors, int32 Mip = 0, int32 Z = 0);
	void WriteRow(int32 X, int32 Y, TConstArrayView<FLinearColor> Colors, int32 Mip = 0, int32 Z = 0);

	/** Another texture of this description, layout and contents. */
	TRefCountPtr<FRHITexture> Clone();
	/** All that a clone holds, bit for bit. */
	void CopyFrom(FRHITexture& Source);

	/** Every texel of every mip and slice, as the format stores the value. Stencil is left alone. */
	void Fill(const FLinearColor& Value);

	/** Fills a rectangle (half-open) of one mip; Slice < 0: of every slice. Texel holds BytesPerTexel bytes of the
	 *  plane's storage. */
	void FillRect(const void* Texel, FIntRect Rect, int32 Mip, int32 Slice = -1, int32 Plane = 0);

private:
	void RebuildMipTables();
	uint8* FindTexel(int32 X, int32 Y, int32 Mip, int32 Z, int32 Plane);

	FRHITextureDesc Desc;
	Drydock::FTextureLayout Layout;
	Drydock::FResourceMemory Memory;
	// Per plane: NumMips entries for the whole texture, then NumMips for each slice. Never resized, so views stay
	// valid.
	std::vector<std::vector<Drydock::FKernelMip>> MipTables;
	std::vector<Drydock::FMemoryHash> MipHashes; // of all mips, plane by plane; those since a touch are not known
	uint64 MipHashesSince = 0;                   // how often all hashes were forgotten then
	std::atomic<bool> bTouched{false};
};

using FRHITexture2D = FRHITexture;
using FRHITexture2DArray = FRHITexture;
using FRHITexture3D = FRHITexture;
using FRHITextureCube = FRHITexture;
using FTextureRHIRef = TRefCountPtr<FRHITexture>;
using FTexture2DRHIRef DRYDOCK_API_FTexture2DRHIRef = FTextureRHIRef;
using FTexture2DArrayRHIRef = FTextureRHIRef;
using FTexture3DRHIRef = FTextureRHIRef;
using FTextureCubeRHIRef = FTextureRHIRef;
using FTextureRHIParamRef = FRHITexture*;
