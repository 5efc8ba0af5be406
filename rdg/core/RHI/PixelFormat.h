// Pixel formats under the engine's names and numbers: those whose texels drydock stores. Block-compressed, video and
// most signed formats of the engine have no storage here and are left out, so that using one is an error at compile
// time. Source: engine PixelFormat.h.
#pragma once

#include <array>

#include "CoreMinimal.h"
#include "ShaderKernel.h"

enum EPixelFormat : uint8
{
	PF_Unknown = 0,
	PF_A32B32G32R32F = 1,
	PF_B8G8R8A8 = 2,
	PF_G8 = 3,
	PF_G16 = 4,
	PF_FloatRGB = 9, // R11G11B10, as on desktop RHIs
	PF_FloatRGBA = 10,
	PF_DepthStencil = 11, // 32-bit float depth, 8-bit stencil in a second plane
	PF_ShadowDepth = 12,
	PF_R32_FLOAT = 13,
	PF_G16R16 = 14,
	PF_G16R16F = 15,
	PF_G16R16F_FILTER = 16,
	PF_G32R32F = 17,
	PF_A2B10G10R10 = 18,
	PF_A16B16G16R16 = 19,
	PF_D24 = 20, // stored as 32-bit float
	PF_R16F = 21,
	PF_R16F_FILTER = 22,
	PF_FloatR11G11B10 = 26,
	PF_R32_UINT = 28,
	PF_R32_SINT = 29,
	PF_R16_UINT = 32,
	PF_R16G16B16A16_UINT = 34,
	PF_R8G8B8A8 = 37,
	PF_R8G8 = 40,
	PF_X24_G8 = 44, // not a texture's format: the view of a depth-stencil texture's stencil plane
	PF_R32G32B32A32_UINT = 48,
	PF_R16G16_UINT = 49,
	PF_R8_UINT = 57,
	PF_L8 = 58,
	PF_R8G8B8A8_UINT = 60,
	PF_R16G16B16A16_UNORM = 62,
	PF_R32G32_UINT = 68,
	PF_R8 = 71,
	PF_R8G8_UINT = 79,
	PF_R32G32B32F = 82,
	PF_MAX = 93,
};

/** The uses of a format. Every stored format can be used for everything. */
enum class EPixelFormatCapabilities : uint32
{
	None = 0,
	Texture1D = 1 << 0,
	Texture2D = 1 << 1,
	Texture3D = 1 << 2,
	TextureCube = 1 << 3,
	RenderTarget = 1 << 5,
	DepthStencil = 1 << 6,
	TextureMipmaps = 1 << 7,
	TextureLoad = 1 << 8,
	TextureSample = 1 << 9,
	TextureGather = 1 << 10,
	TextureAtomics = 1 << 11,
	TextureStore = 1 << 12,
	TextureBlendable = 1 << 13,
	Buffer = 1 << 16,
	VertexBuffer = 1 << 17,
	IndexBuffer = 1 << 18,
	BufferLoad = 1 << 19,
	BufferStore = 1 << 20,
	BufferAtomics = 1 << 21,
	UAV = 1 << 22,
	TypedUAVLoad = 1 << 23,
	TypedUAVStore = 1 << 24,
	AnyTexture = Texture1D | Texture2D | Texture3D | TextureCube,
	AllTextureFlags = AnyTexture | RenderTarget | DepthStencil | TextureMipmaps | TextureLoad | TextureSample |
					  TextureGather | TextureAtomics | TextureStore | TextureBlendable,
	AllBufferFlags = Buffer | VertexBuffer | IndexBuffer | BufferLoad | BufferStore | BufferAtomics,
	AllUAVFlags = UAV | TypedUAVLoad | TypedUAVStore,
	AllFlags = AllTextureFlags | AllBufferFlags | AllUAVFlags,
};
ENUM_CLASS_FLAGS(EPixelFormatCapabilities)

/** One row of GPixelFormats. Rows of formats that are not stored have Supported == false and Name "unknown". */
struct FPixelFormatInfo
{
	const TCHAR* Name = TEXT("unknown"); // without "PF_"
	int32 BlockSizeX = 1;
	int32 BlockSizeY = 1;
	int32 BlockSizeZ = 1;
	int32 BlockBytes = 0; // bytes per texel in native storage
	int32 NumComponents = 0;
	bool Supported = false;
	EPixelFormatCapabilities Capabilities = EPixelFormatCapabilities::None;
	EPixelFormat UnrealFormat = PF_Unknown;
	Drydock::ETexelStorage Storage = Drydock::ETexelStorage::Count; // native, linear
};

/** Indexed by EPixelFormat. */
extern DRYDOCK_API const std::array<FPixelFormatInfo, PF_MAX> GPixelFormats;

/** "PF_FloatRGBA"; "PF_unknown" for what is not stored. */
DRYDOCK_API const TCHAR* GetPixelFormatString(EPixelFormat Format);

/** The format of that name, with or without "PF_", ignoring case; PF_Unknown when there is none. */
DRYDOCK_API EPixelFormat GetPixelFormatFromString(const TCHAR* Name);

FORCEINLINE bool IsDepthOrStencilFormat(EPixelFormat Format)
{
	return Format == PF_D24 || Format == PF_DepthStencil || Format == PF_X24_G8 || Format == PF_ShadowDepth;
}

FORCEINLINE bool IsStencilFormat(EPixelFormat Format)
{
	return Format == PF_DepthStencil || Format == PF_X24_G8;
}

/** Texels are unsigned integers: read as uint, never filtered, never widened. */
DRYDOCK_API bool IsInteger(EPixelFormat Format);

inline bool RHIPixelFormatHasCapabilities(EPixelFormat Format, EPixelFormatCapabilities Capabilities)
{
	return EnumHasAllFlags(GPixelFormats[Format].Capabilities, Capabilities);
}

namespace UE::PixelFormat
{

inline bool HasCapabilities(EPixelFormat Format, EPixelFormatCapabilities Capabilities)
{
	return RHIPixelFormatHasCapabilities(Format, Capabilities);
}

} // namespace UE::PixelFormat

inline bool RHIIsTypedUAVLoadSupported(EPixelFormat Format)
{
	return GPixelFormats[Format].Supported;
}

/** Floating-point texels that may exceed 0..1. */
DRYDOCK_API bool IsFloatFormat(EPixelFormat Format);
