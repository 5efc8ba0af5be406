// Lays out a texture's texels in memory: 64-byte-aligned rows, slices, mips and planes, with 64 readable bytes on
// either side, so that vector loads near an edge stay inside.
#pragma once

#include <optional>
#include <vector>

#include "RHITextureDesc.h"
#include "ShaderKernel.h"

namespace Drydock
{

constexpr size_t GTextureAlignment = 64;

/** The values of r.Drydock.Storage; textures keep the storage they were created with. */
enum class EStorageOverride : int32
{
	Native = 0,
	Float32 = 1,
	Float64 = 2,
};

/** The value of r.Drydock.Storage, unless an FScopedStorageOverride replaces it. */
DRYDOCK_API EStorageOverride GetStorageOverride();

/** Sets the storage of textures that this thread creates in its scope, whatever r.Drydock.Storage is. Scopes nest. */
class DRYDOCK_API FScopedStorageOverride : private FNoncopyable
{
public:
	explicit FScopedStorageOverride(EStorageOverride Override);
	~FScopedStorageOverride();

private:
	const std::optional<EStorageOverride> Before;
};

/** r.Drydock.StoreOverflow: a finite value too large for half is stored as 65504 instead of infinity. */
DRYDOCK_API bool IsStoreOverflowSaturated();

/** The storage of a format (and, for 8-bit formats, of the sRGB flag). */
DRYDOCK_API ETexelStorage GetNativeTexelStorage(const FRHITextureDesc& Desc);

/** The storage a texture created now would get. Integer and depth-stencil formats are never widened. */
DRYDOCK_API ETexelStorage GetTexelStorage(const FRHITextureDesc& Desc);

struct FTextureMipLayout
{
	size_t Offset = 0; // bytes from the texture's memory to texel 0
	int32 SizeX = 0;
	int32 SizeY = 0;
	int32 SizeZ = 0; // depth of a 3D texture's mip, else array slices
	int32 RowPitch = 0;
	int64 SlicePitch = 0;
};

struct FTexturePlaneLayout
{
	ETexelStorage Storage = ETexelStorage::Count;
	std::vector<FTextureMipLayout> Mips;
};

struct FTextureLayout
{
	std::vector<FTexturePlaneLayout> Planes; // one; depth-stencil: depth, stencil
	size_t SizeInBytes = 0;                  // margins included
};

/** The layout of a texture created now. Desc must be valid. */
DRYDOCK_API FTextureLayout ComputeTextureLayout(const FRHITextureDesc& Desc);

/** Its SizeInBytes, without making the lists: asked for each texture of a graph. */
DRYDOCK_API size_t ComputeTextureSize(const FRHITextureDesc& Desc);

} // namespace Drydock
