// The texel formats, N texels at a time, with the same bits as DecodeTexel and EncodeTexel. The wide ones (red, green,
// blue and alpha as floats or halves) are filtered as whole texels and split into channels last; the others are words
// that become channels when they are read. Only formats of 64 bits a channel have no code here: they are for reference
// runs. Included by the LanesSampling_*.cpp only.
#pragma once

#include "LanesOps.inl"
#include "LanesSrgb.h"
#include "PixelFormatConversion.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

struct FRgba32Format
{
	static constexpr ETexelStorage Storage = ETexelStorage::RGBA32_FLOAT;
	static constexpr bool bWide = true;
	static constexpr int Bytes = 16;
	static constexpr int Channels = 4;

	template<int N>
	static DRYDOCK_LANES_INLINE TRaw<float, N> Load(const uint8_t* P)
	{
		return LoadRaw<TRaw<float, N>>(P);
	}
	template<int N>
	static DRYDOCK_LANES_INLINE void Store(uint8_t* P, TRaw<float, N> X)
	{
		StoreRaw(P, X);
	}
};

struct FRgba16Format
{
	static constexpr ETexelStorage Storage = ETexelStorage::RGBA16_FLOAT;
	static constexpr bool bWide = true;
	static constexpr int Bytes = 8;
	static constexpr int Channels = 4;

	template<int N>
	static DRYDOCK_LANES_INLINE TRaw<float, N> Load(const uint8_t* P)
	{
		return TLaneOps<N>::LoadHalves(P);
	}
	template<int N>
	static DRYDOCK_LANES_INLINE void Store(uint8_t* P, TRaw<float, N> X)
	{
		TLaneOps<N>::StoreHalves(P, X);
	}
};

/** One wide texel. */
template<typename FFormat>
DRYDOCK_LANES_INLINE TRaw<float, 4> LoadQuad(const uint8_t* P)
{
	if constexpr (FFormat::Storage == ETexelStorage::RGBA32_FLOAT)
	{
		return LoadRaw<TRaw<float, 4>>(P);
	}
	else
	{
#if DRYDOCK_LANES_LEVEL >= 3
		return TRaw<float, 4>(_mm_cvtph_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(P))));
#else
		return TLaneOps<4>::LoadHalves(P);
#endif
	}
}

// Narrow formats follow: Decode and Encode know the words that a texel consists of, the lowest bytes first. Encode sets
// bits in words of zeros.

/** X / Max of the integer that Bits holds above Shift, correctly rounded. */
template<int N>
DRYDOCK_LANES_INLINE TRaw<float, N> DecodeUnormField(TRaw<uint32_t, N> Bits, int Shift, uint32_t Max)
{
	return TLaneOps<N>::DivideExact(
		__builtin_convertvector(TRaw<int32_t, N>((Bits >> Shift) & Max), TRaw<float, N>), float(Max));
}

/** X * Max rounded to the nearest even integer; NaN gives 0. */
template<int N>
DRYDOCK_LANES_INLINE TRaw<uint32_t, N> EncodeUnormField(TRaw<float, N> X, uint32_t Max)
{
	using FWord = TRaw<uint32_t, N>;
	const TReal<float, N> Clamped = Saturate(TReal<float, N>(X));
#if DRYDOCK_LANES_LEVEL >= 3
	// The sum is rounded once; its last bit is worth 1.
	return FWord(Fused(Clamped, TReal<float, N>(float(Max)), TReal<float, N>(0x1p23f)).V) & 0x7FFFFFu;
#else
	FWord Result;
	constexpr int H = N / 2;
	TRaw<float, H> Parts[2];
	TRaw<int32_t, H> Codes[2];
	__builtin_memcpy(Parts, &Clamped, sizeof(Parts));
	for (int i = 0; i < 2; ++i)
	{
		const TReal<double, H> Wide(__builtin_convertvector(Parts[i], TRaw<double, H>)); // the product is exact
		Codes[i] = __builtin_convertvector(RoundEven(Wide * TReal<double, H>(double(Max))).V, TRaw<int32_t, H>);
	}
	__builtin_memcpy(&Result, Codes, sizeof(Codes));
	return Result;
#endif
}

/** Channels of Bits bits each, the first in the lowest ones; bBgra: blue is the first. */
template<ETexelStorage InStorage, int InChannels, int Bits, bool bBgra = false>
struct TUnormFormat
{
	static constexpr ETexelStorage Storage = InStorage;
	static constexpr bool bWide = false;
	static constexpr int Bytes = InChannels * Bits / 8;
	static constexpr int Channels = InChannels;
	static constexpr uint32_t Max = (1u << Bits) - 1;

	static constexpr int BitOf(int Channel) { return (bBgra && Channel < 3 ? 2 - Channel : Channel) * Bits; }

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(const TRaw<uint32_t, N>* W, TRaw<float, N> C[4])
	{
		for (int c = 0; c < Channels; ++c)
		{
			C[c] = DecodeUnormField<N>(W[BitOf(c) / 32], BitOf(c) % 32, Max);
		}
	}
	template<int N>
	static DRYDOCK_LANES_INLINE void Encode(const TRaw<float, N> C[4], TRaw<uint32_t, N>* W)
	{
		for (int c = 0; c < Channels; ++c)
		{
			W[BitOf(c) / 32] |= EncodeUnormField<N>(C[c], Max) << (BitOf(c) % 32);
		}
	}
};

using FR8Format = TUnormFormat<ETexelStorage::R8_UNORM, 1, 8>;
using FRg8Format = TUnormFormat<ETexelStorage::RG8_UNORM, 2, 8>;
using FRgba8Format = TUnormFormat<ETexelStorage::RGBA8_UNORM, 4, 8>;
using FBgra8Format = TUnormFormat<ETexelStorage::BGRA8_UNORM, 4, 8, true>;
using FR16UnormFormat = TUnormFormat<ETexelStorage::R16_UNORM, 1, 16>;
using FRg16UnormFormat = TUnormFormat<ETexelStorage::RG16_UNORM, 2, 16>;
using FRgba16UnormFormat = TUnormFormat<ETexelStorage::RGBA16_UNORM, 4, 16>;

struct FRgb10A2Format
{
	static constexpr ETexelStorage Storage = ETexelStorage::RGB10A2_UNORM;
	static constexpr bool bWide = false;
	static constexpr int Bytes = 4;
	static constexpr int Channels = 4;

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(const TRaw<uint32_t, N>* W, TRaw<float, N> C[4])
	{
		for (int c = 0; c < 4; ++c)
		{
			C[c] = DecodeUnormField<N>(W[0], 10 * c, c < 3 ? 1023 : 3);
		}
	}
	template<int N>
	static DRYDOCK_LANES_INLINE void Encode(const TRaw<float, N> C[4], TRaw<uint32_t, N>* W)
	{
		for (int c = 0; c < 4; ++c)
		{
			W[0] |= EncodeUnormField<N>(C[c], c < 3 ? 1023 : 3) << (10 * c);
		}
	}
};

/** Red, green and blue as sRGB codes, by tables; alpha as UNORM. */
template<ETexelStorage InStorage, bool bBgra>
struct TSrgbFormat
{
	using FLinear = TUnormFormat<InStorage, 4, 8, bBgra>;
	static constexpr ETexelStorage Storage = InStorage;
	static constexpr bool bWide = false;
	static constexpr int Bytes = 4;
	static constexpr int Channels = 4;

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(const TRaw<uint32_t, N>* W, TRaw<float, N> C[4])
	{
		const auto* const Table = reinterpret_cast<const uint8_t*>(GetSrgb8Decodes());
		for (int c = 0; c < 3; ++c)
		{
			const TRaw<uint32_t, N> Code = (W[0] >> FLinear::BitOf(c)) & 255;
			C[c] = TRaw<float, N>(TLaneOps<N>::Gather(Table, TRaw<int32_t, N>(Code * 4)));
		}
		C[3] = DecodeUnormField<N>(W[0], 24, 255);
	}
	template<int N>
	static DRYDOCK_LANES_INLINE void Encode(const TRaw<float, N> C[4], TRaw<uint32_t, N>* W)
	{
		using FInt = TRaw<int32_t, N>;
		const auto* const Table = reinterpret_cast<const uint8_t*>(GetSrgb8Encodes());
		for (int c = 0; c < 3; ++c)
		{
			const FInt Bits = FInt(Saturate(TReal<float, N>(C[c])).V);
			const FInt Inside = Bits < GSrgb8FirstBits ? (FInt{} + GSrgb8FirstBits) : Bits;
			const FInt Place = ((Inside - GSrgb8FirstBits) >> 16) * 4;
			const FInt Entry = FInt(TLaneOps<N>::Gather(Table, Place));
			const FInt Code = (Entry >> 20) - ((Inside & 0xFFFF) >= (Entry & 0xFFFFF));
			W[0] |= TRaw<uint32_t, N>(Code) << FLinear::BitOf(c);
		}
		W[0] |= EncodeUnormField<N>(C[3], 255) << 24;
	}
};
using FRgba8SrgbFormat = TSrgbFormat<ETexelStorage::RGBA8_SRGB, false>;
using FBgra8SrgbFormat = TSrgbFormat<ETexelStorage::BGRA8_SRGB, true>;

template<ETexelStorage InStorage, int InChannels>
struct THalfFormat
{
	static constexpr ETexelStorage Storage = InStorage;
	static constexpr bool bWide = false;
	static constexpr int Bytes = InChannels * 2;
	static constexpr int Channels = InChannels;

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(const TRaw<uint32_t, N>* W, TRaw<float, N> C[4])
	{
		for (int c = 0; c < Channels; ++c)
		{
			C[c] = TLaneOps<N>::DecodeHalf((W[0] >> (16 * c)) & 0xFFFFu);
		}
	}
	template<int N>
	static DRYDOCK_LANES_INLINE void Encode(const TRaw<float, N> C[4], TRaw<uint32_t, N>* W)
	{
		for (int c = 0; c < Channels; ++c)
		{
			W[0] |= Convert::FloatToHalf(TReal<float, N>(C[c])).V << (16 * c);
		}
	}
};
using FR16Format = THalfFormat<ETexelStorage::R16_FLOAT, 1>;
using FRg16Format = THalfFormat<ETexelStorage::RG16_FLOAT, 2>;

template<ETexelStorage InStorage, int InChannels>
struct TFloatFormat
{
	static constexpr ETexelStorage Storage = InStorage;
	static constexpr bool bWide = false;
	static constexpr int Bytes = InChannels * 4;
	static constexpr int Channels = InChannels;

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(const TRaw<uint32_t, N>* W, TRaw<float, N> C[4])
	{
		for (int c = 0; c < Channels; ++c)
		{
			C[c] = TRaw<float, N>(W[c]);
		}
	}
	template<int N>
	static DRYDOCK_LANES_INLINE void Encode(const TRaw<float, N> C[4], TRaw<uint32_t, N>* W)
	{
		for (int c = 0; c < Channels; ++c)
		{
			W[c] = TRaw<uint32_t, N>(C[c]);
		}
	}
};
using FR32Format = TFloatFormat<ETexelStorage::R32_FLOAT, 1>;
using FRg32Format = TFloatFormat<ETexelStorage::RG32_FLOAT, 2>;
using FRgb32Format = TFloatFormat<ETexelStorage::RGB32_FLOAT, 3>;

/** Unsigned 5-bit-exponent floats of R11G11B10, in the low bits of each word: rounded once, from the float itself. */
template<int MantissaBits, int N>
DRYDOCK_LANES_INLINE TRaw<uint32_t, N> EncodeMiniFloat(TRaw<float, N> X)
{
	using FInt = TRaw<int32_t, N>;
	using FFloat = TRaw<float, N>;
	constexpr int Shift = 23 - MantissaBits;
	constexpr int32_t Infinity = 31 << MantissaBits;
	const FInt Bits = FInt(X);
	const FInt Magnitude = Bits & 0x7FFFFFFF;
	const FInt Normal = (Magnitude - (112 << 23) + ((1 << (Shift - 1)) - 1) + ((Magnitude >> Shift) & 1)) >> Shift;
	// The unit of a denormal is 2^(-14 - MantissaBits); the last bit of a float in [Magic, 2 Magic) has the same
	// weight.
	const FFloat Magic = Broadcast<float, N>(__builtin_bit_cast(float, (127 - 14 - MantissaBits + 23) << 23));
	const FInt Denormal = FInt(FFloat(FFloat(Magnitude) + Magic)) - FInt(Magic);
	FInt Result = Magnitude < (113 << 23) ? Denormal : Normal;
	Result = Result >= Infinity ? (FInt{} + (Infinity - 1)) : Result;
	Result = Magnitude == 0x7F800000 ? (FInt{} + Infinity) : Result;
	Result = Bits < 0 ? FInt{} : Result;
	const FInt Nan = ((Magnitude >> Shift) & ((1 << MantissaBits) - 1)) | Infinity | (1 << (MantissaBits - 1));
	Result = Magnitude > 0x7F800000 ? Nan : Result;
	return TRaw<uint32_t, N>(Result);
}

struct FR11G11B10Format
{
	static constexpr ETexelStorage Storage = ETexelStorage::R11G11B10_FLOAT;
	static constexpr bool bWide = false;
	static constexpr int Bytes = 4;
	static constexpr int Channels = 3;

	/** The channels are halves without a sign and with a shorter mantissa. */
	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(const TRaw<uint32_t, N>* W, TRaw<float, N> C[4])
	{
		C[0] = TLaneOps<N>::DecodeHalf((W[0] << 4) & 0x7FF0u);
		C[1] = TLaneOps<N>::DecodeHalf((W[0] >> 7) & 0x7FF0u);
		C[2] = TLaneOps<N>::DecodeHalf((W[0] >> 17) & 0x7FE0u);
	}
	template<int N>
	static DRYDOCK_LANES_INLINE void Encode(const TRaw<float, N> C[4], TRaw<uint32_t, N>* W)
	{
		W[0] = EncodeMiniFloat<6, N>(C[0]) | (EncodeMiniFloat<6, N>(C[1]) << 11) | (EncodeMiniFloat<5, N>(C[2]) << 22);
	}
};

template<ETexelStorage InStorage, int InChannels, int Bits>
struct TUintFormat
{
	static constexpr ETexelStorage Storage = InStorage;
	static constexpr bool bWide = false;
	static constexpr int Bytes = InChannels * Bits / 8;
	static constexpr int Channels = InChannels;
	static constexpr uint32_t Max = Bits == 32 ? ~0u : (1u << Bits % 32) - 1;
	static constexpr bool bSigned = Storage == ETexelStorage::R32_SINT; // which differs where reals become integers

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(const TRaw<uint32_t, N>* W, TRaw<uint32_t, N> C[4])
	{
		for (int c = 0; c < Channels; ++c)
		{
			C[c] = (W[c * Bits / 32] >> (c * Bits % 32)) & Max;
		}
	}
	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(const TRaw<uint32_t, N>* W, TRaw<float, N> C[4])
	{
		TRaw<uint32_t, N> Codes[4];
		Decode<N>(W, Codes);
		for (int c = 0; c < Channels; ++c)
		{
			const TUint<N> Code(Codes[c]);
			C[c] = bSigned ? ToReal<float>(ToInt(Code)).V : ToReal<float>(Code).V;
		}
	}
	template<int N>
	static DRYDOCK_LANES_INLINE void Encode(const TRaw<uint32_t, N> C[4], TRaw<uint32_t, N>* W)
	{
		for (int c = 0; c < Channels; ++c)
		{
			W[c * Bits / 32] |= Min(TUint<N>(C[c]), TUint<N>(Max)).V << (c * Bits % 32);
		}
	}
	template<int N>
	static DRYDOCK_LANES_INLINE void Encode(const TRaw<float, N> C[4], TRaw<uint32_t, N>* W)
	{
		TRaw<uint32_t, N> Codes[4];
		for (int c = 0; c < Channels; ++c)
		{
			const TReal<float, N> Value(C[c]);
			Codes[c] = bSigned ? ToUint(ToInt(Value)).V : ToUint(Value).V;
		}
		Encode<N>(Codes, W);
	}
};

/** f(FFormat{}) for a storage of integers; false when it is none. */
template<typename F>
DRYDOCK_LANES_INLINE bool VisitUintFormat(ETexelStorage Storage, F f)
{
	switch (Storage)
	{
	case ETexelStorage::R8_UINT:
		return f(TUintFormat<ETexelStorage::R8_UINT, 1, 8>{});
	case ETexelStorage::R16_UINT:
		return f(TUintFormat<ETexelStorage::R16_UINT, 1, 16>{});
	case ETexelStorage::R32_UINT:
		return f(TUintFormat<ETexelStorage::R32_UINT, 1, 32>{});
	case ETexelStorage::R32_SINT:
		return f(TUintFormat<ETexelStorage::R32_SINT, 1, 32>{});
	case ETexelStorage::RG8_UINT:
		return f(TUintFormat<ETexelStorage::RG8_UINT, 2, 8>{});
	case ETexelStorage::RG16_UINT:
		return f(TUintFormat<ETexelStorage::RG16_UINT, 2, 16>{});
	case ETexelStorage::RG32_UINT:
		return f(TUintFormat<ETexelStorage::RG32_UINT, 2, 32>{});
	case ETexelStorage::RGBA8_UINT:
		return f(TUintFormat<ETexelStorage::RGBA8_UINT, 4, 8>{});
	case ETexelStorage::RGBA16_UINT:
		return f(TUintFormat<ETexelStorage::RGBA16_UINT, 4, 16>{});
	case ETexelStorage::RGBA32_UINT:
		return f(TUintFormat<ETexelStorage::RGBA32_UINT, 4, 32>{});
	default:
		return false;
	}
}

/** f(FFormat{}) for the formats that have sampling paths of their own: what pictures travel in. */
template<typename F>
DRYDOCK_LANES_INLINE bool VisitPictureFormat(ETexelStorage Storage, F f)
{
	switch (Storage)
	{
	case ETexelStorage::RGBA32_FLOAT:
		return f(FRgba32Format{});
	case ETexelStorage::RGBA16_FLOAT:
		return f(FRgba16Format{});
	case ETexelStorage::R11G11B10_FLOAT:
		return f(FR11G11B10Format{});
	case ETexelStorage::R32_FLOAT:
		return f(FR32Format{});
	case ETexelStorage::R16_FLOAT:
		return f(FR16Format{});
	case ETexelStorage::RG16_FLOAT:
		return f(FRg16Format{});
	case ETexelStorage::RGBA8_UNORM:
		return f(FRgba8Format{});
	case ETexelStorage::BGRA8_UNORM:
		return f(FBgra8Format{});
	case ETexelStorage::RGB10A2_UNORM:
		return f(FRgb10A2Format{});
	case ETexelStorage::R8_UNORM:
		return f(FR8Format{});
	default:
		return false;
	}
}

/** f(FFormat{}) for every format but those of 64 bits a channel. */
template<typename F>
DRYDOCK_LANES_INLINE bool VisitFormat(ETexelStorage Storage, F f)
{
	switch (Storage)
	{
	case ETexelStorage::RG8_UNORM:
		return f(FRg8Format{});
	case ETexelStorage::RGBA8_SRGB:
		return f(FRgba8SrgbFormat{});
	case ETexelStorage::BGRA8_SRGB:
		return f(FBgra8SrgbFormat{});
	case ETexelStorage::R16_UNORM:
		return f(FR16UnormFormat{});
	case ETexelStorage::RG16_UNORM:
		return f(FRg16UnormFormat{});
	case ETexelStorage::RGBA16_UNORM:
		return f(FRgba16UnormFormat{});
	case ETexelStorage::RG32_FLOAT:
		return f(FRg32Format{});
	case ETexelStorage::RGB32_FLOAT:
		return f(FRgb32Format{});
	default:
		return VisitPictureFormat(Storage, f) || VisitUintFormat(Storage, f);
	}
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
