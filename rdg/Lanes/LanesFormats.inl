// The texel formats with tuned paths, decoded N at a time. Wide formats (8 and 16 bytes) are filtered as whole texels
// and split into channels last; narrow ones (up to 4 bytes) become channels when they are read.
// Included by the LanesSampling_*.cpp only.
#pragma once

#include "LanesOps.inl"

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

/** Narrow formats: Bits are words with the texel in their low bytes. */
struct FR11G11B10Format
{
	static constexpr ETexelStorage Storage = ETexelStorage::R11G11B10_FLOAT;
	static constexpr bool bWide = false;
	static constexpr int Bytes = 4;
	static constexpr int Channels = 3;

	/** The channels are halves without a sign and with a shorter mantissa. */
	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(TRaw<uint32_t, N> Bits, TRaw<float, N> C[4])
	{
		C[0] = TLaneOps<N>::DecodeHalf((Bits << 4) & 0x7FF0u);
		C[1] = TLaneOps<N>::DecodeHalf((Bits >> 7) & 0x7FF0u);
		C[2] = TLaneOps<N>::DecodeHalf((Bits >> 17) & 0x7FE0u);
	}
};

struct FR32Format
{
	static constexpr ETexelStorage Storage = ETexelStorage::R32_FLOAT;
	static constexpr bool bWide = false;
	static constexpr int Bytes = 4;
	static constexpr int Channels = 1;

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(TRaw<uint32_t, N> Bits, TRaw<float, N> C[4])
	{
		C[0] = TRaw<float, N>(Bits);
	}
};

struct FR16Format
{
	static constexpr ETexelStorage Storage = ETexelStorage::R16_FLOAT;
	static constexpr bool bWide = false;
	static constexpr int Bytes = 2;
	static constexpr int Channels = 1;

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(TRaw<uint32_t, N> Bits, TRaw<float, N> C[4])
	{
		C[0] = TLaneOps<N>::DecodeHalf(Bits & 0xFFFFu);
	}
};

struct FRg16Format
{
	static constexpr ETexelStorage Storage = ETexelStorage::RG16_FLOAT;
	static constexpr bool bWide = false;
	static constexpr int Bytes = 4;
	static constexpr int Channels = 2;

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(TRaw<uint32_t, N> Bits, TRaw<float, N> C[4])
	{
		C[0] = TLaneOps<N>::DecodeHalf(Bits & 0xFFFFu);
		C[1] = TLaneOps<N>::DecodeHalf(Bits >> 16);
	}
};

template<int N>
DRYDOCK_LANES_INLINE TRaw<float, N> DecodeUnormField(TRaw<uint32_t, N> Bits, int Shift, uint32_t Max)
{
	return TLaneOps<N>::DivideExact(
		__builtin_convertvector(TRaw<int32_t, N>((Bits >> Shift) & Max), TRaw<float, N>), float(Max));
}

struct FRgba8Format
{
	static constexpr ETexelStorage Storage = ETexelStorage::RGBA8_UNORM;
	static constexpr bool bWide = false;
	static constexpr int Bytes = 4;
	static constexpr int Channels = 4;

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(TRaw<uint32_t, N> Bits, TRaw<float, N> C[4])
	{
		C[0] = DecodeUnormField<N>(Bits, 0, 255);
		C[1] = DecodeUnormField<N>(Bits, 8, 255);
		C[2] = DecodeUnormField<N>(Bits, 16, 255);
		C[3] = DecodeUnormField<N>(Bits, 24, 255);
	}
};

struct FBgra8Format
{
	static constexpr ETexelStorage Storage = ETexelStorage::BGRA8_UNORM;
	static constexpr bool bWide = false;
	static constexpr int Bytes = 4;
	static constexpr int Channels = 4;

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(TRaw<uint32_t, N> Bits, TRaw<float, N> C[4])
	{
		FRgba8Format::Decode<N>(Bits, C);
		const TRaw<float, N> Blue = C[0];
		C[0] = C[2];
		C[2] = Blue;
	}
};

struct FRgb10A2Format
{
	static constexpr ETexelStorage Storage = ETexelStorage::RGB10A2_UNORM;
	static constexpr bool bWide = false;
	static constexpr int Bytes = 4;
	static constexpr int Channels = 4;

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(TRaw<uint32_t, N> Bits, TRaw<float, N> C[4])
	{
		C[0] = DecodeUnormField<N>(Bits, 0, 1023);
		C[1] = DecodeUnormField<N>(Bits, 10, 1023);
		C[2] = DecodeUnormField<N>(Bits, 20, 1023);
		C[3] = DecodeUnormField<N>(Bits, 30, 3);
	}
};

struct FR8Format
{
	static constexpr ETexelStorage Storage = ETexelStorage::R8_UNORM;
	static constexpr bool bWide = false;
	static constexpr int Bytes = 1;
	static constexpr int Channels = 1;

	template<int N>
	static DRYDOCK_LANES_INLINE void Decode(TRaw<uint32_t, N> Bits, TRaw<float, N> C[4])
	{
		C[0] = DecodeUnormField<N>(Bits, 0, 255);
	}
};

/** N neighbouring narrow texels as words. */
template<typename FFormat, int N>
DRYDOCK_LANES_INLINE TRaw<uint32_t, N> LoadWords(const uint8_t* P)
{
	if constexpr (FFormat::Bytes == 4)
	{
		return LoadRaw<TRaw<uint32_t, N>>(P);
	}
	else if constexpr (FFormat::Bytes == 2)
	{
		return __builtin_convertvector(LoadRaw<TRaw<uint16_t, N>>(P), TRaw<uint32_t, N>);
	}
	else
	{
		return __builtin_convertvector(LoadRaw<TRaw<uint8_t, N>>(P), TRaw<uint32_t, N>);
	}
}

/** f(FFormat{}) for the tuned format of a storage; false when it has none. */
template<typename F>
DRYDOCK_LANES_INLINE bool VisitFormat(ETexelStorage Storage, F f)
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

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
