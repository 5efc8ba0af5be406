// Taps that all lie in the same columns, four rows of pixels at a time: a blur's vertical direction, of a picture as
// wide or half as wide. A row of texels is then read once for the pixels above and below it. Included by
// TapSumLanes.inl only.
#pragma once

#include "Native/TapSumRows.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Vectors of each row: what the registers hold. */
template<int N, bool bMixed>
constexpr int GPacksOfTapBlock = (N >= 16 ? 4 : 2) / (bMixed ? 2 : 1);

/** A tap of a block: the texels of its first row and of the four below, of the first channel. */
struct FTapColumn
{
	const float* Rows[GRowsOfTapBlock + 1];
	float Weight; // of the row below
	const float* Weights;
};

/** The columns that the lanes of a block read: Left, or, where Weight is not 0, Left mixed with Right. */
struct FColumnPair
{
	ptrdiff_t Left;
	ptrdiff_t Right;
	float Weight;
};

/** Sums begin with 0, so that the sign of a zero that held places would lose is lost anyway. */
inline bool CanSumInBlocks(const FSourcePlan& Plan)
{
	bool bSame = Plan.Source->bFromZero && (Plan.Step == 256 || Plan.Step == 128);
	for (int32_t Index = 0; Index < Plan.Source->NumTaps; ++Index)
	{
		bSame = bSame && Plan.Taps[Index].bRowsInStep && Plan.Taps[Index].First == Plan.Taps[0].First;
	}
	return bSame;
}

/** One channel of a block. */
template<int N, bool bMixed>
DRYDOCK_LANES_INLINE void SumColumnPacks(const FTapColumn* Taps, int32_t NumTaps, FColumnPair Columns, ptrdiff_t From,
	int Channel, float* Out, ptrdiff_t OutPitch)
{
	using FFloat = TRaw<float, N>;
	constexpr int P = GPacksOfTapBlock<N, bMixed>;
	const FFloat WeightX = Broadcast<float, N>(Columns.Weight);
	FFloat Sums[GRowsOfTapBlock][P] = {};
	for (int32_t Index = 0; Index < NumTaps; ++Index)
	{
		const FTapColumn& Tap = Taps[Index];
		const FFloat Factor = Broadcast<float, N>(Tap.Weights[Channel]);
		const FFloat WeightY = Broadcast<float, N>(Tap.Weight);
		const bool bAlone = Tap.Weight == 0;
		FFloat Left[P];
		FFloat Right[P];
#pragma GCC unroll 4
		for (int i = 0; i < P; ++i)
		{
			Left[i] = LoadRaw<FFloat>(Tap.Rows[0] + Columns.Left + From + i * N);
			Right[i] = bMixed ? LoadRaw<FFloat>(Tap.Rows[0] + Columns.Right + From + i * N) : Left[i];
		}
#pragma GCC unroll 4
		for (int Row = 0; Row < GRowsOfTapBlock; ++Row)
		{
			const float* const Next = Tap.Rows[Row + 1] + From;
#pragma GCC unroll 4
			for (int i = 0; i < P; ++i)
			{
				const FFloat NextLeft = LoadRaw<FFloat>(Next + Columns.Left + i * N);
				FFloat Value = bAlone ? Left[i] : Left[i] + WeightY * (NextLeft - Left[i]);
				if constexpr (bMixed)
				{
					const FFloat NextRight = LoadRaw<FFloat>(Next + Columns.Right + i * N);
					const FFloat Beside = bAlone ? Right[i] : Right[i] + WeightY * (NextRight - Right[i]);
					Value = Value + WeightX * (Beside - Value);
					Right[i] = NextRight;
				}
				Sums[Row][i] = Sums[Row][i] + Value * Factor;
				Left[i] = NextLeft;
			}
		}
	}
#pragma GCC unroll 4
	for (int Row = 0; Row < GRowsOfTapBlock; ++Row)
	{
#pragma GCC unroll 4
		for (int i = 0; i < P; ++i)
		{
			StoreRaw(Out + Row * OutPitch + i * N, Sums[Row][i]);
		}
	}
}

/** Count lanes of one channel of a block; true when none is NaN. */
template<int N, bool bMixed>
__attribute__((noinline)) bool SumColumnRows(const FTapColumn* Taps, int32_t NumTaps, FColumnPair Columns,
	ptrdiff_t From, int Channel, int32_t Count, float* Out, ptrdiff_t OutPitch)
{
	for (int32_t Lane = 0; Lane < Count; Lane += GPacksOfTapBlock<N, bMixed> * N)
	{
		SumColumnPacks<N, bMixed>(Taps, NumTaps, Columns, From + Lane, Channel, Out + Lane, OutPitch);
	}
	bool bNan = false;
	for (int32_t Row = 0; Row < GRowsOfTapBlock; ++Row)
	{
		for (int32_t Lane = 0; Lane < Count; Lane += N)
		{
			const TRaw<float, N> Sum = LoadRaw<TRaw<float, N>>(Out + Row * OutPitch + Lane);
			bNan |= TLaneOps<N>::AnyNan(Sum, Sum);
		}
	}
	return !bNan;
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
