// Sums of taps finished and encoded into a row of the target. Included by TapSumLanes.inl only.
#pragma once

#include "Native/StreamingStores.inl"
#include "Native/TapSumRows.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** The channels of a pack of sums, finished. */
template<int N>
DRYDOCK_LANES_INLINE void FinishSums(
	const FTapSum& Sum, int32_t Channels, int32_t Pitch, const float* Sums, TRaw<float, N> C[4])
{
	using FLanes = TReal<float, N>;
	for (int32_t c = 0; c < 4; ++c)
	{
		FLanes Value = 0.0f;
		if (c < Channels)
		{
			Value = FLanes(LoadRaw<TRaw<float, N>>(Sums + c * Pitch));
			Value = Sum.Factor != 1.0f ? Value * FLanes(Sum.Factor) : Value;
			Value = Sum.bNoNegatives && c < 3 ? Max(Value, FLanes(0.0f)) : Value;
		}
		C[c] = Value.V;
	}
}

/** Width pixels of a row of sums, [channels][Pitch], finished and encoded. */
template<int N>
inline void StoreSums(const FTapSum& Sum, const FKernelTexture& Target, int32_t Channels, int32_t Width, int32_t Pitch,
	const float* Sums, uint8_t* Place)
{
	const int32_t Bytes = GetTexelStorageInfo(Target.Storage).BytesPerTexel;
	const bool bSaturate = Target.bSaturateStore != 0;
	const bool bStreamed = IsStreamed(Target, Place);
	int32_t X = 0;
	if (!bSaturate)
	{
		VisitPictureFormat(Target.Storage,
			[&](auto Format)
			{
				for (; X + N <= Width; X += N)
				{
					TRaw<float, N> C[4];
					FinishSums<N>(Sum, Channels, Pitch, Sums + X, C);
					uint8_t* const P = Place + int64_t(X) * Format.Bytes;
					if constexpr (decltype(Format)::bWide)
					{
						if (bStreamed)
						{
							TRaw<float, N> Texels[4];
							TLaneOps<N>::Join(C, Texels);
							for (int i = 0; i < 4; ++i)
							{
								StreamTexels<N, decltype(Format)>(P + i * (N / 4) * Format.Bytes, Texels[i]);
							}
							continue;
						}
					}
					StoreTexelsOf<decltype(Format), float, N>(P, C);
				}
				return true;
			});
	}
	for (; X < Width; X += N)
	{
		TRaw<float, N> C[4];
		FinishSums<N>(Sum, Channels, Pitch, Sums + X, C);
		StorePack<N>(Target, Place + int64_t(X) * Bytes, Width - X, C);
	}
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
