// Lays textures out in memory, and holds the console variables that change how texels are stored.
#include "TextureLayout.h"

#include "HAL/IConsoleManager.h"
#include "PixelFormatConversion.h"

#include <algorithm>

static TAutoConsoleVariable<int32> CVarDrydockStorage(TEXT("r.Drydock.Storage"), 0,
	TEXT("How textures created from now on keep their texels.\n") TEXT(" 0: in their own format (default)\n")
		TEXT(" 1: float and UNORM formats as 32-bit floats, neither rounded nor clamped\n")
			TEXT(" 2: the same as 64-bit floats"));

static TAutoConsoleVariable<int32> CVarDrydockStoreOverflow(TEXT("r.Drydock.StoreOverflow"), 0,
	TEXT("What a finite value too large for half becomes when stored.\n")
		TEXT(" 0: infinity, as hardware converts (default)\n") TEXT(" 1: 65504"));

namespace Drydock
{

namespace
{

// Rows whose pitch is a multiple of this compete for the same cache sets; a column walk would miss on every row.
constexpr size_t GCacheSetStride = 4096;

size_t AlignUp(size_t Size)
{
	return (Size + GTextureAlignment - 1) / GTextureAlignment * GTextureAlignment;
}

ETexelStorage ToSrgb(ETexelStorage Storage)
{
	switch (Storage)
	{
	case ETexelStorage::RGBA8_UNORM:
		return ETexelStorage::RGBA8_SRGB;
	case ETexelStorage::BGRA8_UNORM:
		return ETexelStorage::BGRA8_SRGB;
	default:
		return Storage;
	}
}

/** Appends a plane at Offset and returns the offset behind it. */
size_t AddPlane(const FRHITextureDesc& Desc, ETexelStorage Storage, size_t Offset, FTexturePlaneLayout& OutPlane)
{
	OutPlane.Storage = Storage;
	const size_t TexelBytes = GetTexelStorageInfo(Storage).BytesPerTexel;
	for (int32 MipIndex = 0; MipIndex < Desc.NumMips; ++MipIndex)
	{
		FTextureMipLayout Mip;
		Mip.Offset = Offset;
		Mip.SizeX = std::max(1, Desc.Extent.X >> MipIndex);
		Mip.SizeY = std::max(1, Desc.Extent.Y >> MipIndex);
		Mip.SizeZ = Desc.IsTexture3D() ? std::max(1, Desc.Depth >> MipIndex) : Desc.GetNumSlices();

		size_t RowPitch = AlignUp(size_t(Mip.SizeX) * TexelBytes);
		if (RowPitch % GCacheSetStride == 0)
		{
			RowPitch += GTextureAlignment;
		}
		Mip.RowPitch = int32(RowPitch);
		Mip.SlicePitch = int64(RowPitch) * Mip.SizeY;
		Offset += size_t(Mip.SlicePitch) * Mip.SizeZ;
		OutPlane.Mips.push_back(Mip);
	}
	return Offset;
}

} // namespace

static thread_local std::optional<EStorageOverride> GScopedOverride;

FScopedStorageOverride::FScopedStorageOverride(EStorageOverride Override)
	: Before(GScopedOverride)
{
	GScopedOverride = Override;
}

FScopedStorageOverride::~FScopedStorageOverride()
{
	GScopedOverride = Before;
}

EStorageOverride GetStorageOverride()
{
	if (GScopedOverride)
	{
		return *GScopedOverride;
	}
	return EStorageOverride(std::clamp(CVarDrydockStorage.GetValueOnAnyThread(), 0, 2));
}

bool IsStoreOverflowSaturated()
{
	return CVarDrydockStoreOverflow.GetValueOnAnyThread() != 0;
}

ETexelStorage GetNativeTexelStorage(const FRHITextureDesc& Desc)
{
	const ETexelStorage Storage = GPixelFormats[Desc.Format].Storage;
	return EnumHasAnyFlags(Desc.Flags, ETextureCreateFlags::SRGB) ? ToSrgb(Storage) : Storage;
}

ETexelStorage GetTexelStorage(const FRHITextureDesc& Desc)
{
	const ETexelStorage Native = GetNativeTexelStorage(Desc);
	const EStorageOverride Override = GetStorageOverride();
	if (Override == EStorageOverride::Native || IsDepthOrStencilFormat(Desc.Format))
	{
		return Native;
	}
	return WidenTexelStorage(Native, Override == EStorageOverride::Float64);
}

FTextureLayout ComputeTextureLayout(const FRHITextureDesc& Desc)
{
	FTextureLayout Layout;
	Layout.Planes.resize(Desc.Format == PF_DepthStencil ? 2 : 1);
	size_t Offset = AddPlane(Desc, GetTexelStorage(Desc), GTextureAlignment, Layout.Planes[0]);
	if (Layout.Planes.size() > 1)
	{
		Offset = AddPlane(Desc, ETexelStorage::R8_UINT, Offset, Layout.Planes[1]);
	}
	Layout.SizeInBytes = Offset + GTextureAlignment;
	return Layout;
}

} // namespace Drydock
