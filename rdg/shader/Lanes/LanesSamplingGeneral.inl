// Sampling of scattered lanes: one footprint per lane. Same operations, same order, same bits as
// LanesSamplingReference.inl, except where a result is NaN. Included by the LanesSampling_*.cpp only.
#pragma once

#include "LanesTexels.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<int N>
DRYDOCK_LANES_INLINE bool AllEqual(TRaw<float, N> A, float B)
{
	return MaskBits(TMask<N>(TRaw<int32_t, N>(A != B))) == 0;
}

template<typename V, typename W>
DRYDOCK_LANES_INLINE V Blend(V A, V B, W Weight)
{
	return A + Weight * (B - A);
}

/** The formats without sampling paths of their own: which one it is comes out at each tap. */
struct FAnyFormat
{
	static constexpr bool bWide = false;
	static constexpr int Channels = 4;
	ETexelStorage Storage;
	int32_t Bytes;
};

/** N neighbouring texels of a narrow format as channels. */
template<int N, typename FFormat>
DRYDOCK_LANES_INLINE void ReadNeighbours(FFormat Format, const uint8_t* P, TRaw<float, N> C[4])
{
	if constexpr (std::is_same_v<FFormat, FAnyFormat>)
	{
		LoadTexels<float, N>(Format.Storage, P, C);
	}
	else
	{
		TRaw<uint32_t, N> W[WordsOf<FFormat>];
		LoadWords<FFormat, N>(P, W);
		FFormat::template Decode<N>(W, C);
	}
}

/** The texels of a narrow format at Base + Offsets as channels. */
template<int N, typename FFormat>
DRYDOCK_LANES_INLINE void ReadScattered(
	FFormat Format, const uint8_t* Base, TRaw<int32_t, N> Offsets, TRaw<float, N> C[4])
{
	if constexpr (std::is_same_v<FFormat, FAnyFormat>)
	{
		GatherTexels<float, N>(Format.Storage, Base, Offsets, C);
	}
	else
	{
		TRaw<uint32_t, N> W[WordsOf<FFormat>];
		GatherWords<FFormat, N>(Base, Offsets, W);
		FFormat::template Decode<N>(W, C);
	}
}

/** Writes the channels; false when one is NaN. Channels that the format lacks are 0, 0, 1. */
template<typename FFormat, int N>
DRYDOCK_LANES_INLINE bool Finish(const TRaw<float, N> C[4], float* Out)
{
	using FOps = TLaneOps<N>;
	constexpr int Channels = FFormat::Channels;
	const bool bNan = Channels > 2 ? FOps::AnyNan(C[0], C[1], C[2], C[Channels > 3 ? 3 : 2])
								   : FOps::AnyNan(C[0], C[Channels > 1 ? 1 : 0]);
	if (__builtin_expect(bNan, 0))
	{
		return false;
	}
	for (int c = 0; c < 4; ++c)
	{
		StoreRaw(Out + c * N, c < Channels ? C[c] : Broadcast<float, N>(c == 3 ? 1.0f : 0.0f));
	}
	return true;
}

/** Texels and weights of all lanes after addressing; nothing is on the border. */
template<int N>
struct TFootprints
{
	TRaw<int32_t, N> Left;
	TRaw<int32_t, N> Right;
	TRaw<int32_t, N> Top;
	TRaw<int32_t, N> Bottom;
	TRaw<float, N> WeightX;
	TRaw<float, N> WeightY;
};

/** One footprint per lane: whole texels, blended as four channels at once. */
template<typename FFormat, int N>
DRYDOCK_LANES_INLINE void SampleGeneralWide(
	const FKernelMip& Mip, const uint8_t* Base, const TFootprints<N>& F, TRaw<float, N> C[4])
{
	using FQuad = TRaw<float, 4>;
	alignas(64) int32_t Left[N], Right[N], Top[N], Bottom[N];
	alignas(64) float WeightX[N], WeightY[N];
	StoreRaw(Left, F.Left);
	StoreRaw(Right, F.Right);
	StoreRaw(Top, F.Top);
	StoreRaw(Bottom, F.Bottom);
	StoreRaw(WeightX, F.WeightX);
	StoreRaw(WeightY, F.WeightY);
	FQuad Texels[N];
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const uint8_t* Row0 = Base + int64_t(Top[Lane]) * Mip.RowPitch;
		const uint8_t* Row1 = Base + int64_t(Bottom[Lane]) * Mip.RowPitch;
		const int64_t L = int64_t(Left[Lane]) * FFormat::Bytes;
		const int64_t R = int64_t(Right[Lane]) * FFormat::Bytes;
		const float X = WeightX[Lane];
		const float Y = WeightY[Lane];
		FQuad A = LoadQuad<FFormat>(Row0 + L);
		if (Y != 0)
		{
			A = Blend(A, LoadQuad<FFormat>(Row1 + L), Y);
		}
		if (X != 0)
		{
			FQuad B = LoadQuad<FFormat>(Row0 + R);
			if (Y != 0)
			{
				B = Blend(B, LoadQuad<FFormat>(Row1 + R), Y);
			}
			A = Blend(A, B, X);
		}
		Texels[Lane] = A;
	}
	// Register k of the AoS order holds texels k * N / 4 and on.
	TRaw<float, N> A[4];
	for (int k = 0; k < 4; ++k)
	{
		A[k] = TLaneOps<N>::SetQuads(Texels + k * (N / 4));
	}
	TLaneOps<N>::Split(A, C);
}

/** One footprint per lane by gathers. */
template<int N, typename FFormat>
DRYDOCK_LANES_INLINE void SampleGeneralNarrow(
	FFormat Format, const FKernelMip& Mip, const uint8_t* Base, const TFootprints<N>& F, TRaw<float, N> C[4])
{
	using FInt = TRaw<int32_t, N>;
	using FFloat = TRaw<float, N>;
	const FInt Row0 = F.Top * Mip.RowPitch;
	const FInt Row1 = F.Bottom * Mip.RowPitch;
	const FInt L = F.Left * Format.Bytes;
	const FInt R = F.Right * Format.Bytes;
	FFloat D[4];
	ReadScattered<N>(Format, Base, Row0 + L, C);
	const bool bTwoRows = !AllEqual<N>(F.WeightY, 0.0f);
	const bool bTwoColumns = !AllEqual<N>(F.WeightX, 0.0f);
	if (bTwoRows)
	{
		ReadScattered<N>(Format, Base, Row1 + L, D);
		for (int c = 0; c < FFormat::Channels; ++c)
		{
			C[c] = F.WeightY == 0.0f ? C[c] : Blend(C[c], D[c], F.WeightY);
		}
	}
	if (!bTwoColumns)
	{
		return;
	}
	FFloat E[4];
	ReadScattered<N>(Format, Base, Row0 + R, E);
	if (bTwoRows)
	{
		ReadScattered<N>(Format, Base, Row1 + R, D);
		for (int c = 0; c < FFormat::Channels; ++c)
		{
			E[c] = F.WeightY == 0.0f ? E[c] : Blend(E[c], D[c], F.WeightY);
		}
	}
	for (int c = 0; c < FFormat::Channels; ++c)
	{
		C[c] = F.WeightX == 0.0f ? C[c] : Blend(C[c], E[c], F.WeightX);
	}
}

/** False when the texture is too large for gathers, which take 32-bit offsets. */
template<int N, typename FFormat>
DRYDOCK_LANES_INLINE bool SampleGeneral(
	FFormat Format, const FKernelMip& Mip, const uint8_t* Base, const TFootprints<N>& F, TRaw<float, N> C[4])
{
	if constexpr (FFormat::bWide)
	{
		SampleGeneralWide<FFormat, N>(Mip, Base, F, C);
		return true;
	}
	else
	{
		if (int64_t(Mip.RowPitch) * Mip.SizeY > 0x7FFFFFFF)
		{
			return false;
		}
		SampleGeneralNarrow<N>(Format, Mip, Base, F, C);
		return true;
	}
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
