// The shuffles and conversions that the tuned sampling paths need, once per instruction set: TLaneOps<4> (SSE 4.1),
// <8> (AVX2 with F16C), <16> (AVX-512). "AoS" registers hold N / 4 whole RGBA texels, "SoA" ones a channel of N texels.
// Included by the LanesSampling_*.cpp only.
#pragma once

#include "LanesCoordinates.inl"

// GCC 12 takes the deliberately undefined operands inside its AVX-512 header for mistakes.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wuninitialized"
#ifndef __clang__
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>
#pragma GCC diagnostic pop

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<int N>
struct TLaneOps;

/** Unaligned load of any vector. */
template<typename V>
DRYDOCK_LANES_INLINE V LoadRaw(const void* Address)
{
	V Result;
	__builtin_memcpy(&Result, Address, sizeof(V));
	return Result;
}
template<typename V>
DRYDOCK_LANES_INLINE void StoreRaw(void* Address, const V& Value)
{
	__builtin_memcpy(Address, &Value, sizeof(V));
}

#if DRYDOCK_LANES_LEVEL >= 4
template<>
struct TLaneOps<16>
{
	using FFloat = TRaw<float, 16>;
	using FInt = TRaw<int32_t, 16>;
	using FUint = TRaw<uint32_t, 16>;
	static constexpr bool bHasPermute = true;

	static DRYDOCK_LANES_INLINE FFloat LoadHalves(const uint8_t* P)
	{
		return FFloat(_mm512_cvtph_ps(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(P))));
	}
	static DRYDOCK_LANES_INLINE void StoreHalves(uint8_t* P, FFloat X)
	{
		_mm256_storeu_si256(reinterpret_cast<__m256i*>(P), _mm512_cvtps_ph(__m512(X), 0));
	}
	static DRYDOCK_LANES_INLINE FFloat DecodeHalf(FUint Bits)
	{
		return FFloat(_mm512_cvtph_ps(_mm512_cvtepi32_epi16(__m512i(Bits))));
	}
	static DRYDOCK_LANES_INLINE FUint Gather(const uint8_t* Base, FInt Offsets)
	{
		return FUint(_mm512_i32gather_epi32(__m512i(Offsets), Base, 1));
	}
	/** Correctly rounded X / D for integers X up to D = 2^k - 1, k <= 16: one Newton step on the product with the
	 * reciprocal. */
	static DRYDOCK_LANES_INLINE FFloat DivideExact(FFloat X, float D)
	{
		const __m512 Reciprocal = _mm512_set1_ps(1.0f / D);
		const __m512 Quotient = _mm512_mul_ps(__m512(X), Reciprocal);
		const __m512 Rest = _mm512_fnmadd_ps(Quotient, _mm512_set1_ps(D), __m512(X));
		return FFloat(_mm512_fmadd_ps(Rest, Reciprocal, Quotient));
	}

	/** Four AoS registers to four channels. */
	static DRYDOCK_LANES_INLINE void Split(const FFloat A[4], FFloat C[4])
	{
		const __m512i RedGreen = _mm512_setr_epi32(0, 4, 8, 12, 16, 20, 24, 28, 1, 5, 9, 13, 17, 21, 25, 29);
		const __m512i BlueAlpha = _mm512_setr_epi32(2, 6, 10, 14, 18, 22, 26, 30, 3, 7, 11, 15, 19, 23, 27, 31);
		const __m512 RG0 = _mm512_permutex2var_ps(__m512(A[0]), RedGreen, __m512(A[1]));
		const __m512 BA0 = _mm512_permutex2var_ps(__m512(A[0]), BlueAlpha, __m512(A[1]));
		const __m512 RG1 = _mm512_permutex2var_ps(__m512(A[2]), RedGreen, __m512(A[3]));
		const __m512 BA1 = _mm512_permutex2var_ps(__m512(A[2]), BlueAlpha, __m512(A[3]));
		C[0] = FFloat(_mm512_shuffle_f32x4(RG0, RG1, 0x44));
		C[1] = FFloat(_mm512_shuffle_f32x4(RG0, RG1, 0xEE));
		C[2] = FFloat(_mm512_shuffle_f32x4(BA0, BA1, 0x44));
		C[3] = FFloat(_mm512_shuffle_f32x4(BA0, BA1, 0xEE));
	}
	/** The way back. */
	static DRYDOCK_LANES_INLINE void Join(const FFloat C[4], FFloat A[4])
	{
		const __m512 RG0 = _mm512_unpacklo_ps(__m512(C[0]), __m512(C[1]));
		const __m512 RG1 = _mm512_unpackhi_ps(__m512(C[0]), __m512(C[1]));
		const __m512 BA0 = _mm512_unpacklo_ps(__m512(C[2]), __m512(C[3]));
		const __m512 BA1 = _mm512_unpackhi_ps(__m512(C[2]), __m512(C[3]));
		// Texels 0 4 8 12, 1 5 9 13, ...: then a 4 x 4 transposition of whole texels.
		const __m512 T0 = _mm512_castpd_ps(_mm512_unpacklo_pd(_mm512_castps_pd(RG0), _mm512_castps_pd(BA0)));
		const __m512 T1 = _mm512_castpd_ps(_mm512_unpackhi_pd(_mm512_castps_pd(RG0), _mm512_castps_pd(BA0)));
		const __m512 T2 = _mm512_castpd_ps(_mm512_unpacklo_pd(_mm512_castps_pd(RG1), _mm512_castps_pd(BA1)));
		const __m512 T3 = _mm512_castpd_ps(_mm512_unpackhi_pd(_mm512_castps_pd(RG1), _mm512_castps_pd(BA1)));
		const __m512 Q0 = _mm512_shuffle_f32x4(T0, T1, 0x44);
		const __m512 Q1 = _mm512_shuffle_f32x4(T0, T1, 0xEE);
		const __m512 Q2 = _mm512_shuffle_f32x4(T2, T3, 0x44);
		const __m512 Q3 = _mm512_shuffle_f32x4(T2, T3, 0xEE);
		A[0] = FFloat(_mm512_shuffle_f32x4(Q0, Q2, 0x88));
		A[1] = FFloat(_mm512_shuffle_f32x4(Q0, Q2, 0xDD));
		A[2] = FFloat(_mm512_shuffle_f32x4(Q1, Q3, 0x88));
		A[3] = FFloat(_mm512_shuffle_f32x4(Q1, Q3, 0xDD));
	}
	static DRYDOCK_LANES_INLINE FFloat Permute(FFloat Table, FInt Index)
	{
		return FFloat(_mm512_permutexvar_ps(__m512i(Index), __m512(Table)));
	}
	static DRYDOCK_LANES_INLINE FFloat Permute2(FFloat Low, FFloat High, FInt Index)
	{
		return FFloat(_mm512_permutex2var_ps(__m512(Low), __m512i(Index), __m512(High)));
	}
	/** The even words of A and B in turn, and the odd ones. */
	static DRYDOCK_LANES_INLINE void Deinterleave(FUint A, FUint B, FUint W[2])
	{
		const FInt Even = LaneIndex<16>().V * 2;
		W[0] = FUint(Permute2(FFloat(A), FFloat(B), Even));
		W[1] = FUint(Permute2(FFloat(A), FFloat(B), Even + 1));
	}
	/** The way back. */
	static DRYDOCK_LANES_INLINE void Interleave(const FUint W[2], FUint Rows[2])
	{
		const FInt Lanes = LaneIndex<16>().V;
		const FInt Low = (Lanes >> 1) | ((Lanes & 1) << 4);
		Rows[0] = FUint(Permute2(FFloat(W[0]), FFloat(W[1]), Low));
		Rows[1] = FUint(Permute2(FFloat(W[0]), FFloat(W[1]), Low + 8));
	}
	/** Texels 0 2 4 6 (1 3 5 7) of two AoS registers. */
	static DRYDOCK_LANES_INLINE FFloat EvenTexels(FFloat A, FFloat B)
	{
		return FFloat(_mm512_shuffle_f32x4(__m512(A), __m512(B), 0x88));
	}
	static DRYDOCK_LANES_INLINE FFloat OddTexels(FFloat A, FFloat B)
	{
		return FFloat(_mm512_shuffle_f32x4(__m512(A), __m512(B), 0xDD));
	}
	/** Largest integer not above X; 0x80000000 for NaN and what does not fit. */
	static DRYDOCK_LANES_INLINE FInt FloorToInt(FFloat X)
	{
		return FInt(_mm512_cvt_roundps_epi32(__m512(X), _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC));
	}
	static DRYDOCK_LANES_INLINE bool Equal(FInt A, FInt B)
	{
		return _mm512_cmpneq_epi32_mask(__m512i(A), __m512i(B)) == 0;
	}
	/** No bit of Bits set in any lane. */
	static DRYDOCK_LANES_INLINE bool NoBits(FInt A, int32_t Bits)
	{
		return _mm512_test_epi32_mask(__m512i(A), _mm512_set1_epi32(Bits)) == 0;
	}
	/** NaN in A or B. */
	static DRYDOCK_LANES_INLINE bool AnyNan(FFloat A, FFloat B)
	{
		return _mm512_cmp_ps_mask(__m512(A), __m512(B), _CMP_UNORD_Q) != 0;
	}
	static DRYDOCK_LANES_INLINE bool AnyNan(FFloat A, FFloat B, FFloat C, FFloat D)
	{
		return (_mm512_cmp_ps_mask(__m512(A), __m512(B), _CMP_UNORD_Q) |
				   _mm512_cmp_ps_mask(__m512(C), __m512(D), _CMP_UNORD_Q)) != 0;
	}
	static DRYDOCK_LANES_INLINE FFloat SetQuads(const TRaw<float, 4> Q[4])
	{
		__m512 R = _mm512_castps128_ps512(__m128(Q[0]));
		R = _mm512_insertf32x4(R, __m128(Q[1]), 1);
		R = _mm512_insertf32x4(R, __m128(Q[2]), 2);
		return FFloat(_mm512_insertf32x4(R, __m128(Q[3]), 3));
	}
};
#endif

#if DRYDOCK_LANES_LEVEL >= 3
template<>
struct TLaneOps<8>
{
	using FFloat = TRaw<float, 8>;
	using FInt = TRaw<int32_t, 8>;
	using FUint = TRaw<uint32_t, 8>;
	static constexpr bool bHasPermute = true;

	static DRYDOCK_LANES_INLINE FFloat LoadHalves(const uint8_t* P)
	{
		return FFloat(_mm256_cvtph_ps(_mm_loadu_si128(reinterpret_cast<const __m128i*>(P))));
	}
	static DRYDOCK_LANES_INLINE void StoreHalves(uint8_t* P, FFloat X)
	{
		_mm_storeu_si128(reinterpret_cast<__m128i*>(P), _mm256_cvtps_ph(__m256(X), 0));
	}
	static DRYDOCK_LANES_INLINE FFloat DecodeHalf(FUint Bits)
	{
		const __m256i Packed = _mm256_packus_epi32(__m256i(Bits), __m256i(Bits));
		return FFloat(_mm256_cvtph_ps(_mm256_castsi256_si128(_mm256_permute4x64_epi64(Packed, 0x08))));
	}
	static DRYDOCK_LANES_INLINE FUint Gather(const uint8_t* Base, FInt Offsets)
	{
		return FUint(_mm256_i32gather_epi32(reinterpret_cast<const int*>(Base), __m256i(Offsets), 1));
	}
	static DRYDOCK_LANES_INLINE FFloat DivideExact(FFloat X, float D)
	{
		const __m256 Reciprocal = _mm256_set1_ps(1.0f / D);
		const __m256 Quotient = _mm256_mul_ps(__m256(X), Reciprocal);
		const __m256 Rest = _mm256_fnmadd_ps(Quotient, _mm256_set1_ps(D), __m256(X));
		return FFloat(_mm256_fmadd_ps(Rest, Reciprocal, Quotient));
	}

	static DRYDOCK_LANES_INLINE void Transpose4x4(__m256 T0, __m256 T1, __m256 T2, __m256 T3, FFloat C[4])
	{
		const __m256 L0 = _mm256_unpacklo_ps(T0, T1);
		const __m256 H0 = _mm256_unpackhi_ps(T0, T1);
		const __m256 L1 = _mm256_unpacklo_ps(T2, T3);
		const __m256 H1 = _mm256_unpackhi_ps(T2, T3);
		C[0] = FFloat(_mm256_shuffle_ps(L0, L1, 0x44));
		C[1] = FFloat(_mm256_shuffle_ps(L0, L1, 0xEE));
		C[2] = FFloat(_mm256_shuffle_ps(H0, H1, 0x44));
		C[3] = FFloat(_mm256_shuffle_ps(H0, H1, 0xEE));
	}
	static DRYDOCK_LANES_INLINE void Split(const FFloat A[4], FFloat C[4])
	{
		const __m256 T0 = _mm256_permute2f128_ps(__m256(A[0]), __m256(A[2]), 0x20); // texels 0 4
		const __m256 T1 = _mm256_permute2f128_ps(__m256(A[0]), __m256(A[2]), 0x31);
		const __m256 T2 = _mm256_permute2f128_ps(__m256(A[1]), __m256(A[3]), 0x20);
		const __m256 T3 = _mm256_permute2f128_ps(__m256(A[1]), __m256(A[3]), 0x31);
		Transpose4x4(T0, T1, T2, T3, C);
	}
	static DRYDOCK_LANES_INLINE void Join(const FFloat C[4], FFloat A[4])
	{
		FFloat T[4];
		Transpose4x4(__m256(C[0]), __m256(C[1]), __m256(C[2]), __m256(C[3]), T); // texels 0 4, 1 5, 2 6, 3 7
		A[0] = FFloat(_mm256_permute2f128_ps(__m256(T[0]), __m256(T[1]), 0x20));
		A[1] = FFloat(_mm256_permute2f128_ps(__m256(T[2]), __m256(T[3]), 0x20));
		A[2] = FFloat(_mm256_permute2f128_ps(__m256(T[0]), __m256(T[1]), 0x31));
		A[3] = FFloat(_mm256_permute2f128_ps(__m256(T[2]), __m256(T[3]), 0x31));
	}
	static DRYDOCK_LANES_INLINE FFloat Permute(FFloat Table, FInt Index)
	{
		return FFloat(_mm256_permutevar8x32_ps(__m256(Table), __m256i(Index)));
	}
	static DRYDOCK_LANES_INLINE FFloat Permute2(FFloat Low, FFloat High, FInt Index)
	{
		const __m256 FromLow = _mm256_permutevar8x32_ps(__m256(Low), __m256i(Index));
		const __m256 FromHigh = _mm256_permutevar8x32_ps(__m256(High), __m256i(Index));
		return FFloat(_mm256_blendv_ps(FromLow, FromHigh, _mm256_castsi256_ps(_mm256_slli_epi32(__m256i(Index), 28))));
	}
	static DRYDOCK_LANES_INLINE void Deinterleave(FUint A, FUint B, FUint W[2])
	{
		const __m256 Even = _mm256_shuffle_ps(__m256(A), __m256(B), 0x88); // halves of A and B in turn
		const __m256 Odd = _mm256_shuffle_ps(__m256(A), __m256(B), 0xDD);
		W[0] = FUint(_mm256_permute4x64_epi64(__m256i(Even), 0xD8));
		W[1] = FUint(_mm256_permute4x64_epi64(__m256i(Odd), 0xD8));
	}
	static DRYDOCK_LANES_INLINE void Interleave(const FUint W[2], FUint Rows[2])
	{
		const __m256i Low = _mm256_unpacklo_epi32(__m256i(W[0]), __m256i(W[1]));
		const __m256i High = _mm256_unpackhi_epi32(__m256i(W[0]), __m256i(W[1]));
		Rows[0] = FUint(_mm256_permute2x128_si256(Low, High, 0x20));
		Rows[1] = FUint(_mm256_permute2x128_si256(Low, High, 0x31));
	}
	static DRYDOCK_LANES_INLINE FFloat EvenTexels(FFloat A, FFloat B)
	{
		return FFloat(_mm256_permute2f128_ps(__m256(A), __m256(B), 0x20));
	}
	static DRYDOCK_LANES_INLINE FFloat OddTexels(FFloat A, FFloat B)
	{
		return FFloat(_mm256_permute2f128_ps(__m256(A), __m256(B), 0x31));
	}
	static DRYDOCK_LANES_INLINE FInt FloorToInt(FFloat X)
	{
		return FInt(_mm256_cvttps_epi32(_mm256_floor_ps(__m256(X))));
	}
	static DRYDOCK_LANES_INLINE bool Equal(FInt A, FInt B)
	{
		const __m256i Difference = _mm256_xor_si256(__m256i(A), __m256i(B));
		return _mm256_testz_si256(Difference, Difference) != 0;
	}
	static DRYDOCK_LANES_INLINE bool NoBits(FInt A, int32_t Bits)
	{
		return _mm256_testz_si256(__m256i(A), _mm256_set1_epi32(Bits)) != 0;
	}
	static DRYDOCK_LANES_INLINE bool AnyNan(FFloat A, FFloat B)
	{
		return _mm256_movemask_ps(_mm256_cmp_ps(__m256(A), __m256(B), _CMP_UNORD_Q)) != 0;
	}
	static DRYDOCK_LANES_INLINE bool AnyNan(FFloat A, FFloat B, FFloat C, FFloat D)
	{
		return _mm256_movemask_ps(_mm256_or_ps(_mm256_cmp_ps(__m256(A), __m256(B), _CMP_UNORD_Q),
				   _mm256_cmp_ps(__m256(C), __m256(D), _CMP_UNORD_Q))) != 0;
	}
	static DRYDOCK_LANES_INLINE FFloat SetQuads(const TRaw<float, 4> Q[2])
	{
		return FFloat(_mm256_insertf128_ps(_mm256_castps128_ps256(__m128(Q[0])), __m128(Q[1]), 1));
	}
};
#endif

#if DRYDOCK_LANES_LEVEL >= 2
template<>
struct TLaneOps<4>
{
	using FFloat = TRaw<float, 4>;
	using FInt = TRaw<int32_t, 4>;
	using FUint = TRaw<uint32_t, 4>;
	static constexpr bool bHasPermute = false;

	static DRYDOCK_LANES_INLINE FFloat DecodeHalf(FUint Bits) { return Convert::HalfToFloat(TUint<4>(Bits)).V; }
	static DRYDOCK_LANES_INLINE FFloat LoadHalves(const uint8_t* P)
	{
		return DecodeHalf(FUint(_mm_cvtepu16_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(P)))));
	}
	static DRYDOCK_LANES_INLINE void StoreHalves(uint8_t* P, FFloat X)
	{
		const __m128i Halves = __m128i(Convert::FloatToHalf(TReal<float, 4>(X)).V);
		_mm_storel_epi64(reinterpret_cast<__m128i*>(P), _mm_packus_epi32(Halves, Halves));
	}
	static DRYDOCK_LANES_INLINE FUint Gather(const uint8_t* Base, FInt Offsets)
	{
		FUint Result;
		for (int Lane = 0; Lane < 4; ++Lane)
		{
			uint32_t Word;
			__builtin_memcpy(&Word, Base + Offsets[Lane], 4);
			Result[Lane] = Word;
		}
		return Result;
	}
	static DRYDOCK_LANES_INLINE FFloat DivideExact(FFloat X, float D) { return X / D; }
	static DRYDOCK_LANES_INLINE void Split(const FFloat A[4], FFloat C[4])
	{
		const __m128 L0 = _mm_unpacklo_ps(__m128(A[0]), __m128(A[1]));
		const __m128 H0 = _mm_unpackhi_ps(__m128(A[0]), __m128(A[1]));
		const __m128 L1 = _mm_unpacklo_ps(__m128(A[2]), __m128(A[3]));
		const __m128 H1 = _mm_unpackhi_ps(__m128(A[2]), __m128(A[3]));
		C[0] = FFloat(_mm_movelh_ps(L0, L1));
		C[1] = FFloat(_mm_movehl_ps(L1, L0));
		C[2] = FFloat(_mm_movelh_ps(H0, H1));
		C[3] = FFloat(_mm_movehl_ps(H1, H0));
	}
	static DRYDOCK_LANES_INLINE void Join(const FFloat C[4], FFloat A[4]) { Split(C, A); }
	static DRYDOCK_LANES_INLINE FFloat Permute(FFloat Table, FInt) { return Table; }
	static DRYDOCK_LANES_INLINE FFloat Permute2(FFloat Low, FFloat, FInt) { return Low; }
	static DRYDOCK_LANES_INLINE void Deinterleave(FUint A, FUint B, FUint W[2])
	{
		W[0] = FUint(_mm_shuffle_ps(__m128(A), __m128(B), 0x88));
		W[1] = FUint(_mm_shuffle_ps(__m128(A), __m128(B), 0xDD));
	}
	static DRYDOCK_LANES_INLINE void Interleave(const FUint W[2], FUint Rows[2])
	{
		Rows[0] = FUint(_mm_unpacklo_epi32(__m128i(W[0]), __m128i(W[1])));
		Rows[1] = FUint(_mm_unpackhi_epi32(__m128i(W[0]), __m128i(W[1])));
	}
	/** A register is one texel: A is the even, B the odd one. */
	static DRYDOCK_LANES_INLINE FFloat EvenTexels(FFloat A, FFloat) { return A; }
	static DRYDOCK_LANES_INLINE FFloat OddTexels(FFloat, FFloat B) { return B; }
	static DRYDOCK_LANES_INLINE FInt FloorToInt(FFloat X) { return FInt(_mm_cvttps_epi32(_mm_floor_ps(__m128(X)))); }
	static DRYDOCK_LANES_INLINE bool Equal(FInt A, FInt B)
	{
		const __m128i Difference = _mm_xor_si128(__m128i(A), __m128i(B));
		return _mm_testz_si128(Difference, Difference) != 0;
	}
	static DRYDOCK_LANES_INLINE bool NoBits(FInt A, int32_t Bits)
	{
		return _mm_testz_si128(__m128i(A), _mm_set1_epi32(Bits)) != 0;
	}
	static DRYDOCK_LANES_INLINE bool AnyNan(FFloat A, FFloat B)
	{
		return _mm_movemask_ps(_mm_cmpunord_ps(__m128(A), __m128(B))) != 0;
	}
	static DRYDOCK_LANES_INLINE bool AnyNan(FFloat A, FFloat B, FFloat C, FFloat D)
	{
		return _mm_movemask_ps(
				   _mm_or_ps(_mm_cmpunord_ps(__m128(A), __m128(B)), _mm_cmpunord_ps(__m128(C), __m128(D)))) != 0;
	}
	static DRYDOCK_LANES_INLINE FFloat SetQuads(const TRaw<float, 4> Q[1]) { return Q[0]; }
};
#endif

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
