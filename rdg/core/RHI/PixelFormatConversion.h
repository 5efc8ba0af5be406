// Texel conversion, one texel at a time: the reference for every faster path. Rounding is to nearest even and happens
// once, from float and from double alike; nothing depends on the processor's rounding or denormal mode, except that a
// store to a 32-bit format from double uses the hardware's conversion.
//   half       finite overflow from 65520 gives Inf (or 65504 with bSaturate); denormals kept; NaN made quiet
//   R11G11B10  negative and -Inf give 0, NaN stays NaN, +Inf stays, finite overflow gives the largest finite value
//   UNORM      NaN gives 0, clamp to 0..1, then round
//   sRGB       IEC 61966-2-1 on red, green and blue, correctly rounded; alpha as UNORM
//   UINT       from reals: NaN gives 0, truncated, clamped to the range; from integers: clamped to the range
// Channels a format lacks read as 0, alpha as 1. Source: D3D11.3 functional specification 3.2, with
// round-to-nearest-even where it allows a choice; IEC 61966-2-1.
#pragma once

#include "DrydockAPI.h"
#include "ShaderKernel.h"

#include <cstddef>
#include <cstdint>

namespace Drydock
{

enum class ETexelKind : uint8_t
{
	Unorm,
	Srgb,
	Float,
	Uint
};

struct FTexelStorageInfo
{
	const char* Name; // "RGBA16_FLOAT"
	ETexelKind Kind;
	uint8_t NumChannels;
	uint8_t BytesPerTexel;
	uint8_t BitsPerChannel; // of the first channel
};

/** Indexed by ETexelStorage. */
inline constexpr FTexelStorageInfo GTexelStorageInfos[] = {
	{"R8_UNORM", ETexelKind::Unorm, 1, 1, 8},
	{"RG8_UNORM", ETexelKind::Unorm, 2, 2, 8},
	{"RGBA8_UNORM", ETexelKind::Unorm, 4, 4, 8},
	{"BGRA8_UNORM", ETexelKind::Unorm, 4, 4, 8},
	{"RGBA8_SRGB", ETexelKind::Srgb, 4, 4, 8},
	{"BGRA8_SRGB", ETexelKind::Srgb, 4, 4, 8},
	{"RGB10A2_UNORM", ETexelKind::Unorm, 4, 4, 10},
	{"R16_UNORM", ETexelKind::Unorm, 1, 2, 16},
	{"RG16_UNORM", ETexelKind::Unorm, 2, 4, 16},
	{"RGBA16_UNORM", ETexelKind::Unorm, 4, 8, 16},
	{"R16_FLOAT", ETexelKind::Float, 1, 2, 16},
	{"RG16_FLOAT", ETexelKind::Float, 2, 4, 16},
	{"RGBA16_FLOAT", ETexelKind::Float, 4, 8, 16},
	{"R11G11B10_FLOAT", ETexelKind::Float, 3, 4, 11},
	{"R32_FLOAT", ETexelKind::Float, 1, 4, 32},
	{"RG32_FLOAT", ETexelKind::Float, 2, 8, 32},
	{"RGB32_FLOAT", ETexelKind::Float, 3, 12, 32},
	{"RGBA32_FLOAT", ETexelKind::Float, 4, 16, 32},
	{"R64_FLOAT", ETexelKind::Float, 1, 8, 64},
	{"RG64_FLOAT", ETexelKind::Float, 2, 16, 64},
	{"RGB64_FLOAT", ETexelKind::Float, 3, 24, 64},
	{"RGBA64_FLOAT", ETexelKind::Float, 4, 32, 64},
	{"R8_UINT", ETexelKind::Uint, 1, 1, 8},
	{"R16_UINT", ETexelKind::Uint, 1, 2, 16},
	{"R32_UINT", ETexelKind::Uint, 1, 4, 32},
	{"RG8_UINT", ETexelKind::Uint, 2, 2, 8},
	{"RG16_UINT", ETexelKind::Uint, 2, 4, 16},
	{"RG32_UINT", ETexelKind::Uint, 2, 8, 32},
	{"RGBA8_UINT", ETexelKind::Uint, 4, 4, 8},
	{"RGBA16_UINT", ETexelKind::Uint, 4, 8, 16},
	{"RGBA32_UINT", ETexelKind::Uint, 4, 16, 32},
	{"R32_SINT", ETexelKind::Uint, 1, 4, 32},
};
static_assert(sizeof(GTexelStorageInfos) / sizeof(FTexelStorageInfo) == size_t(ETexelStorage::Count));

/** Storage must be below ETexelStorage::Count. */
constexpr const FTexelStorageInfo& GetTexelStorageInfo(ETexelStorage Storage)
{
	return GTexelStorageInfos[size_t(Storage)];
}

/** Writes BytesPerTexel bytes from red, green, blue, alpha. bSaturate: finite half overflow gives the largest finite
 *  value (r.Drydock.StoreOverflow 1). */
DRYDOCK_API void EncodeTexel(ETexelStorage Storage, const float RGBA[4], void* Texel, bool bSaturate = false);
DRYDOCK_API void EncodeTexel(ETexelStorage Storage, const double RGBA[4], void* Texel, bool bSaturate = false);

/** UINT and SINT storage only: a value above the channel's range becomes its largest. */
DRYDOCK_API void EncodeTexel(ETexelStorage Storage, const uint32_t RGBA[4], void* Texel);

/** Exact, except that float receives 64-bit texels and 32-bit integers rounded to nearest even. */
DRYDOCK_API void DecodeTexel(ETexelStorage Storage, const void* Texel, float OutRGBA[4]);
DRYDOCK_API void DecodeTexel(ETexelStorage Storage, const void* Texel, double OutRGBA[4]);

/** UINT and SINT storage only, the bits; missing channels read 0, alpha 1. */
DRYDOCK_API void DecodeTexel(ETexelStorage Storage, const void* Texel, uint32_t OutRGBA[4]);

/** IEEE binary16 from any real. A float converts to double exactly, so one rounding serves both. */
DRYDOCK_API uint16_t EncodeHalf(double Value, bool bSaturate = false);
DRYDOCK_API double DecodeHalf(uint16_t Bits);

/** Unsigned 5-bit-exponent floats of R11G11B10: MantissaBits is 6 (red, green) or 5 (blue). */
DRYDOCK_API uint32_t EncodeUnsignedMiniFloat(double Value, int32_t MantissaBits);
DRYDOCK_API double DecodeUnsignedMiniFloat(uint32_t Bits, int32_t MantissaBits);

/** Bits 1..16. */
DRYDOCK_API uint32_t EncodeUnorm(double Value, int32_t Bits);
DRYDOCK_API double DecodeUnorm(uint32_t Value, int32_t Bits);

/** 8-bit sRGB code of a linear value, correctly rounded, and back. */
DRYDOCK_API uint8_t EncodeSrgb8(double Linear);
DRYDOCK_API double DecodeSrgb8(uint8_t Code);

/** The storage of a widened texture: the same channels as reals of 32 or 64 bits. Integer storage is returned as is;
 *  channels come in RGBA order. */
DRYDOCK_API ETexelStorage WidenTexelStorage(ETexelStorage Storage, bool b64Bit);

} // namespace Drydock
