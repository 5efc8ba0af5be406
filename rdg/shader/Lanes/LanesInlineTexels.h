// Reads and stores whole texels inside a kernel: RGBA floats and halves, split into channels and joined. The same bits
// as by the library; generic vectors, because an intrinsics header costs a third of a shader's compile time.
#pragma once

#include "LanesResources.h"
#include "LanesTaps.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** A sample's four channels: single values, because what is in arrays goes through memory. */
template<typename Real, int N>
struct TChannels
{
	TReal<Real, N>& R;
	TReal<Real, N>& G;
	TReal<Real, N>& B;
	TReal<Real, N>& A;
};

#if DRYDOCK_LANES_LEVEL >= 2
/** Four registers of N / 4 RGBA texels to four channels. */
template<int N>
DRYDOCK_LANES_INLINE void SplitTexels(
	TRaw<float, N> A, TRaw<float, N> B, TRaw<float, N> C, TRaw<float, N> D, TChannels<float, N> Out)
{
	using FRaw = TRaw<float, N>;
	if constexpr (N == 16)
	{
		const FRaw RG0 = __builtin_shufflevector(A, B, 0, 4, 8, 12, 16, 20, 24, 28, 1, 5, 9, 13, 17, 21, 25, 29);
		const FRaw RG1 = __builtin_shufflevector(C, D, 0, 4, 8, 12, 16, 20, 24, 28, 1, 5, 9, 13, 17, 21, 25, 29);
		const FRaw BA0 = __builtin_shufflevector(A, B, 2, 6, 10, 14, 18, 22, 26, 30, 3, 7, 11, 15, 19, 23, 27, 31);
		const FRaw BA1 = __builtin_shufflevector(C, D, 2, 6, 10, 14, 18, 22, 26, 30, 3, 7, 11, 15, 19, 23, 27, 31);
		Out.R.V = __builtin_shufflevector(RG0, RG1, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23);
		Out.G.V = __builtin_shufflevector(RG0, RG1, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
		Out.B.V = __builtin_shufflevector(BA0, BA1, 0, 1, 2, 3, 4, 5, 6, 7, 16, 17, 18, 19, 20, 21, 22, 23);
		Out.A.V = __builtin_shufflevector(BA0, BA1, 8, 9, 10, 11, 12, 13, 14, 15, 24, 25, 26, 27, 28, 29, 30, 31);
	}
	else if constexpr (N == 8)
	{
		const FRaw T0 = __builtin_shufflevector(A, C, 0, 1, 2, 3, 8, 9, 10, 11); // texels 0 4
		const FRaw T1 = __builtin_shufflevector(A, C, 4, 5, 6, 7, 12, 13, 14, 15);
		const FRaw T2 = __builtin_shufflevector(B, D, 0, 1, 2, 3, 8, 9, 10, 11);
		const FRaw T3 = __builtin_shufflevector(B, D, 4, 5, 6, 7, 12, 13, 14, 15);
		const FRaw RG0 = __builtin_shufflevector(T0, T1, 0, 8, 1, 9, 4, 12, 5, 13);
		const FRaw BA0 = __builtin_shufflevector(T0, T1, 2, 10, 3, 11, 6, 14, 7, 15);
		const FRaw RG1 = __builtin_shufflevector(T2, T3, 0, 8, 1, 9, 4, 12, 5, 13);
		const FRaw BA1 = __builtin_shufflevector(T2, T3, 2, 10, 3, 11, 6, 14, 7, 15);
		Out.R.V = __builtin_shufflevector(RG0, RG1, 0, 1, 8, 9, 4, 5, 12, 13);
		Out.G.V = __builtin_shufflevector(RG0, RG1, 2, 3, 10, 11, 6, 7, 14, 15);
		Out.B.V = __builtin_shufflevector(BA0, BA1, 0, 1, 8, 9, 4, 5, 12, 13);
		Out.A.V = __builtin_shufflevector(BA0, BA1, 2, 3, 10, 11, 6, 7, 14, 15);
	}
	else
	{
		const FRaw RG0 = __builtin_shufflevector(A, B, 0, 4, 1, 5);
		const FRaw BA0 = __builtin_shufflevector(A, B, 2, 6, 3, 7);
		const FRaw RG1 = __builtin_shufflevector(C, D, 0, 4, 1, 5);
		const FRaw BA1 = __builtin_shufflevector(C, D, 2, 6, 3, 7);
		Out.R.V = __builtin_shufflevector(RG0, RG1, 0, 1, 4, 5);
		Out.G.V = __builtin_shufflevector(RG0, RG1, 2, 3, 6, 7);
		Out.B.V = __builtin_shufflevector(BA0, BA1, 0, 1, 4, 5);
		Out.A.V = __builtin_shufflevector(BA0, BA1, 2, 3, 6, 7);
	}
}

/** The way back, in place. */
template<int N>
DRYDOCK_LANES_INLINE void JoinTexels(TRaw<float, N>& R, TRaw<float, N>& G, TRaw<float, N>& B, TRaw<float, N>& A)
{
	using FRaw = TRaw<float, N>;
	if constexpr (N == 16)
	{
		const FRaw RG0 = __builtin_shufflevector(R, G, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
		const FRaw RG1 = __builtin_shufflevector(R, G, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
		const FRaw BA0 = __builtin_shufflevector(B, A, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
		const FRaw BA1 = __builtin_shufflevector(B, A, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
		R = __builtin_shufflevector(RG0, BA0, 0, 1, 16, 17, 2, 3, 18, 19, 4, 5, 20, 21, 6, 7, 22, 23);
		G = __builtin_shufflevector(RG0, BA0, 8, 9, 24, 25, 10, 11, 26, 27, 12, 13, 28, 29, 14, 15, 30, 31);
		B = __builtin_shufflevector(RG1, BA1, 0, 1, 16, 17, 2, 3, 18, 19, 4, 5, 20, 21, 6, 7, 22, 23);
		A = __builtin_shufflevector(RG1, BA1, 8, 9, 24, 25, 10, 11, 26, 27, 12, 13, 28, 29, 14, 15, 30, 31);
	}
	else if constexpr (N == 8)
	{
		const FRaw RG0 = __builtin_shufflevector(R, G, 0, 8, 1, 9, 4, 12, 5, 13);
		const FRaw RG1 = __builtin_shufflevector(R, G, 2, 10, 3, 11, 6, 14, 7, 15);
		const FRaw BA0 = __builtin_shufflevector(B, A, 0, 8, 1, 9, 4, 12, 5, 13);
		const FRaw BA1 = __builtin_shufflevector(B, A, 2, 10, 3, 11, 6, 14, 7, 15);
		const FRaw T0 = __builtin_shufflevector(RG0, BA0, 0, 1, 8, 9, 4, 5, 12, 13); // texels 0 4
		const FRaw T1 = __builtin_shufflevector(RG0, BA0, 2, 3, 10, 11, 6, 7, 14, 15);
		const FRaw T2 = __builtin_shufflevector(RG1, BA1, 0, 1, 8, 9, 4, 5, 12, 13);
		const FRaw T3 = __builtin_shufflevector(RG1, BA1, 2, 3, 10, 11, 6, 7, 14, 15);
		R = __builtin_shufflevector(T0, T1, 0, 1, 2, 3, 8, 9, 10, 11);
		G = __builtin_shufflevector(T2, T3, 0, 1, 2, 3, 8, 9, 10, 11);
		B = __builtin_shufflevector(T0, T1, 4, 5, 6, 7, 12, 13, 14, 15);
		A = __builtin_shufflevector(T2, T3, 4, 5, 6, 7, 12, 13, 14, 15);
	}
	else
	{
		const FRaw RG0 = __builtin_shufflevector(R, G, 0, 4, 1, 5);
		const FRaw RG1 = __builtin_shufflevector(R, G, 2, 6, 3, 7);
		const FRaw BA0 = __builtin_shufflevector(B, A, 0, 4, 1, 5);
		const FRaw BA1 = __builtin_shufflevector(B, A, 2, 6, 3, 7);
		R = __builtin_shufflevector(RG0, BA0, 0, 1, 4, 5);
		G = __builtin_shufflevector(RG0, BA0, 2, 3, 6, 7);
		B = __builtin_shufflevector(RG1, BA1, 0, 1, 4, 5);
		A = __builtin_shufflevector(RG1, BA1, 2, 3, 6, 7);
	}
}

/** A NaN in A or B. */
template<int N>
DRYDOCK_LANES_INLINE bool HasNan(TRaw<float, N> A, TRaw<float, N> B)
{
#if DRYDOCK_LANES_LEVEL >= 4
	if constexpr (N == 16)
	{
		return __builtin_ia32_cmpps512_mask(A, B, 3, 0xFFFF, 4) != 0;
	}
#endif
	return AnyLane(TMask<N>(TRaw<int32_t, N>(A != A) | TRaw<int32_t, N>(B != B)));
}

template<int N>
DRYDOCK_LANES_INLINE TRaw<float, N> LoadFloatTexels(const uint8_t* P)
{
	TRaw<float, N> X;
	__builtin_memcpy(&X, P, sizeof(X));
	return X;
}

/** Halves to floats; only where the processor converts them. */
template<int N>
DRYDOCK_LANES_INLINE TRaw<float, N> LoadHalfTexels(const uint8_t* P)
{
	TRaw<int16_t, N> Bits;
	__builtin_memcpy(&Bits, P, sizeof(Bits));
#if DRYDOCK_LANES_LEVEL >= 4
	if constexpr (N == 16)
	{
		return __builtin_ia32_vcvtph2ps512_mask(Bits, TRaw<float, 16>{}, 0xFFFF, 4);
	}
#endif
#if DRYDOCK_LANES_LEVEL >= 3
	if constexpr (N == 8)
	{
		return __builtin_ia32_vcvtph2ps256(Bits);
	}
#endif
	return TRaw<float, N>{};
}
/** Floats to halves, as LoadHalfTexels. */
template<int N>
DRYDOCK_LANES_INLINE void StoreHalfTexels(uint8_t* P, TRaw<float, N> X)
{
	TRaw<int16_t, N> Bits{};
#if DRYDOCK_LANES_LEVEL >= 4
	if constexpr (N == 16)
	{
		Bits = __builtin_ia32_vcvtps2ph512_mask(X, 0, Bits, 0xFFFF);
	}
#endif
#if DRYDOCK_LANES_LEVEL >= 3
	if constexpr (N == 8)
	{
		Bits = __builtin_ia32_vcvtps2ph256(X, 0);
	}
#endif
	__builtin_memcpy(P, &Bits, sizeof(Bits));
}
#endif

/** The kind of whole texels that a target takes as they are. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE EWholeTexels GetWholeTexels(const FKernelTarget& Target)
{
	if (!std::is_same_v<Real, float> || DRYDOCK_LANES_LEVEL < 2 || Target.bBlend || (Target.WriteMask & 15) != 15)
	{
		return EWholeTexels::None;
	}
	return Target.Texture.Storage == ETexelStorage::RGBA32_FLOAT ? EWholeTexels::Float
		   : N > 4 && Target.Texture.Storage == ETexelStorage::RGBA16_FLOAT && !Target.Texture.bSaturateStore
			   ? EWholeTexels::Half
			   : EWholeTexels::None;
}

/** StoreTarget; Kind: what GetWholeTexels gave for the target. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE void StoreTarget(TMask<N> Mask, EWholeTexels Kind, const FKernelTarget& Target, int32_t X0,
	int32_t Y, TReal<Real, N> R, TReal<Real, N> G, TReal<Real, N> B, TReal<Real, N> A)
{
#if DRYDOCK_LANES_LEVEL >= 2
	if constexpr (std::is_same_v<Real, float>)
	{
		const FKernelMip& Mip = Target.Texture.Mips[0];
		if (__builtin_expect(Kind != EWholeTexels::None && AllLanes(Mask) && X0 >= 0 && X0 <= Mip.SizeX - N &&
								 uint32_t(Y) < uint32_t(Mip.SizeY),
				1))
		{
			const bool bFloat = N == 4 || Kind == EWholeTexels::Float;
			uint8_t* const P = Mip.Data + int64_t(Y) * Mip.RowPitch + int64_t(X0) * (bFloat ? 16 : 8);
			JoinTexels<N>(R.V, G.V, B.V, A.V);
			if (bFloat)
			{
				__builtin_memcpy(P, &R, sizeof(R));
				__builtin_memcpy(P + 4 * N, &G, sizeof(G));
				__builtin_memcpy(P + 8 * N, &B, sizeof(B));
				__builtin_memcpy(P + 12 * N, &A, sizeof(A));
			}
			else
			{
				StoreHalfTexels<N>(P, R.V);
				StoreHalfTexels<N>(P + 2 * N, G.V);
				StoreHalfTexels<N>(P + 4 * N, B.V);
				StoreHalfTexels<N>(P + 6 * N, A.V);
			}
			return;
		}
	}
#endif
	StoreTarget(Mask, Target, X0, Y, TColor<Real, N>(R, G, B, A));
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
