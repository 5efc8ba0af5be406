// Samples and loads of kernels that have a tap (LanesTaps.h).
#pragma once

#include "LanesInlineTexels.h"
#include "LanesTaps.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<int Count>
DRYDOCK_LANES_INLINE void ForgetTaps(FKernelTap (&Taps)[Count])
{
	for (FKernelTap& Tap : Taps)
	{
		Tap.Begin = 0; // which is compared before Length says that there is nothing
		Tap.Length = 0;
	}
}

/** x and z are the same in all rows, y and w in all columns: the interpolant of a full-screen triangle. */
DRYDOCK_LANES_INLINE bool IsStill(const FKernelInterpolant& Interpolant, int Components)
{
	bool bStill = true;
	for (int c = 0; c < Components; ++c)
	{
		bStill = bStill && (c % 2 == 0 ? Interpolant.DY[c] : Interpolant.DX[c]) == 0;
	}
	return bStill;
}

DRYDOCK_LANES_INLINE bool KnowsTexels(const FKernelTap* Tap, int32_t X, int32_t Y)
{
	return Tap && uint32_t(X) - uint32_t(Tap->Begin) < Tap->Length && Tap->Row == Y;
}

/** Samples that the tap does not know. */
template<typename Real, int N>
__attribute__((noinline)) void SampleTap(const FKernelTexture& Texture, const FKernelSampler& Sampler, TReal<Real, N> U,
	TReal<Real, N> V, Real Level, FKernelTap* Tap, bool bLearn, int32_t X0, int32_t Y, Real* Out)
{
	if (Tap && bLearn)
	{
		TSampling<Real, N>::LearnSample2D(Texture, Sampler, LanesOf(U), LanesOf(V), Level, Out, *Tap, X0, Y);
		return;
	}
	TSampling<Real, N>::Sample2D(Texture, Sampler, LanesOf(U), LanesOf(V), nullptr, &Level, true, Out);
}
template<typename Real, int N>
__attribute__((noinline)) void LoadTap(const FKernelTexture& Texture, TInt<N> X, TInt<N> Y, int32_t Mip,
	FKernelTap* Tap, bool bLearn, int32_t X0, int32_t Row, Real* Out)
{
	if (Tap && bLearn)
	{
		TSampling<Real, N>::LearnLoad2D(Texture, IndicesOf(X), IndicesOf(Y), Mip, Out, *Tap, X0, Row);
		return;
	}
	TSampling<Real, N>::Load(Texture, IndicesOf(X), IndicesOf(Y), nullptr, &Mip, true, Out);
}

/** The texels of the pack of pixels (X0.., Y): those that the tap knows, else what Other(Texels) writes. bInline: whole
 *  texels are read here, which is faster and more code. */
template<bool bInline, typename Real, int N, typename FOther>
DRYDOCK_LANES_INLINE void ReadTap(TChannels<Real, N> Out, const FKernelTap* Tap, int32_t X0, int32_t Y, FOther Other)
{
	bool bRead = false;
	TReal<Real, N> Texels[4];
	if constexpr (std::is_same_v<Real, float>)
	{
		const bool bKnown = KnowsTexels(Tap, X0, Y);
#if DRYDOCK_LANES_LEVEL >= 2
		if (bInline && __builtin_expect(bKnown && Tap->Kind != EWholeTexels::None, 1))
		{
			using FRaw = TRaw<float, N>;
			const uint8_t* const P = Tap->Row0 + Tap->Column + int64_t(X0) * Tap->Stride;
			const bool bFloat = N == 4 || Tap->Kind == EWholeTexels::Float;
			const FRaw A = bFloat ? LoadFloatTexels<N>(P) : LoadHalfTexels<N>(P);
			const FRaw B = bFloat ? LoadFloatTexels<N>(P + 4 * N) : LoadHalfTexels<N>(P + 2 * N);
			const FRaw C = bFloat ? LoadFloatTexels<N>(P + 8 * N) : LoadHalfTexels<N>(P + 4 * N);
			const FRaw D = bFloat ? LoadFloatTexels<N>(P + 12 * N) : LoadHalfTexels<N>(P + 6 * N);
			if (__builtin_expect(!(HasNan<N>(A, B) | HasNan<N>(C, D)), 1))
			{
				SplitTexels<N>(A, B, C, D, Out);
				return;
			}
		}
#endif
		bRead = bKnown && Tap->Function(*Tap, X0, LanesOf(Texels[0]));
	}
	if (!bRead)
	{
		Other(LanesOf(Texels[0]));
	}
	Out.R = Texels[0];
	Out.G = Texels[1];
	Out.B = Texels[2];
	Out.A = Texels[3];
}

/** SampleLevel2D at the pack of pixels (X0.., Y) with a tap, which may be null. bLearn: all lanes are what every pixel
 * of the tile is. */
template<bool bInline, typename Real, int N>
DRYDOCK_LANES_INLINE void SampleLevel2D(TChannels<Real, N> Out, const FKernelTexture& Texture,
	const FKernelSampler& Sampler, TReal<Real, N> U, TReal<Real, N> V, Real Level, FKernelTap* Tap, bool bLearn,
	int32_t X0, int32_t Y)
{
	ReadTap<bInline>(Out, Tap, X0, Y,
		[&](Real* Texels) { SampleTap<Real, N>(Texture, Sampler, U, V, Level, Tap, bLearn, X0, Y, Texels); });
}

/** Load2D so. */
template<bool bInline, typename Real, int N>
DRYDOCK_LANES_INLINE void Load2D(TChannels<Real, N> Out, const FKernelTexture& Texture, TInt<N> X, TInt<N> Y,
	int32_t Mip, FKernelTap* Tap, bool bLearn, int32_t X0, int32_t Row)
{
	ReadTap<bInline>(
		Out, Tap, X0, Row, [&](Real* Texels) { LoadTap<Real, N>(Texture, X, Y, Mip, Tap, bLearn, X0, Row, Texels); });
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
