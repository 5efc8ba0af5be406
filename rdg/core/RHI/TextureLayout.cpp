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
	TEXT("Result of storing a finite value too large for half.\n")
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
	return Storage == ETexelStorage::RGBA8_UNORM   ? ETexelStorage::RGBA8_SRGB
		   : Storage == ETexelStorage::BGRA8_UNORM ? ETexelStorage::BGRA8_SRGB
												   : Storage;
}

/** A mip that lies at Offset. */
FTextureMipLayout LayOutMip(const FRHITextureDesc& Desc, size_t TexelBytes, int32 MipIndex, size_t Offset)
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
	return Mip;
}

/** Calls Function with each mip of a plane that begins at Offset; returns the offset behind it. */
template<typename TFunction>
size_t ForEachMip(const FRHITextureDesc& Desc, ETexelStorage Storage, size_t Offset, TFunction Function)
{
	const size_t TexelBytes = GetTexelStorageInfo(Storage).BytesPerTexel;
	for (int32 MipIndex = 0; MipIndex < Desc.NumMips; ++MipIndex)
	{
		const FTextureMipLayout Mip = LayOutMip(Desc, TexelBytes, MipIndex, Offset);
		Offset += size_t(Mip.SlicePitch) * Mip.SizeZ;
		Function(Mip);
	}
	return Offset;
}

/** Calls Function with the number of each plane, its storage and each of its mips; returns the texture's size. */
template<typename TFunction>
size_t ForEachPlane(const FRHITextureDesc& Desc, TFunction Function)
{
	const ETexelStorage First = GetTexelStorage(Desc);
	size_t Offset = ForEachMip(
		Desc, First, GTextureAlignment, [&](const FTextureMipLayout& Mip) { Function(size_t(0), First, Mip); });
	if (Desc.Format == PF_DepthStencil)
	{
		Offset = ForEachMip(Desc, ETexelStorage::R8_UINT, Offset,
			[&](const FTextureMipLayout& Mip) { Function(size_t(1), ETexelStorage::R8_UINT, Mip); });
	}
	return Offset + GTextureAlignment;
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
	return GScopedOverride ? *GScopedOverride
						   : EStorageOverride(std::clamp(CVarDrydockStorage.GetValueOnAnyThread(), 0, 2));
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
	for (FTexturePlaneLayout& Plane : Layout.Planes)
	{
		Plane.Mips.reserve(Desc.NumMips);
	}
	Layout.SizeInBytes = ForEachPlane(Desc,
		[&](size_t Plane, ETexelStorage Storage, const FTextureMipLayout& Mip)
		{
			Layout.Planes[Plane].Storage = Storage;
			Layout.Planes[Plane].Mips.push_back(Mip);
		});
	return Layout;
}

size_t ComputeTextureSize(const FRHITextureDesc& Desc)
{
	return ForEachPlane(Desc, [](size_t, ETexelStorage, const FTextureMipLayout&) {});
}

} // namespace Drydock
