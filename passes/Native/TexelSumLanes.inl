// Sums of texels in lanes: along a row by loads a texel apart, along columns by blocks of rows that share their loads.
// Included by TexelSum_*.cpp only.
#pragma once

#include "Native/StripStores.inl"
#include "Native/TexelSum.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Vectors of a row that are summed side by side. */
constexpr int GPacksAlongRow = 8;

/** Rows, and vectors of each, that are summed side by side along columns: what the registers hold. */
constexpr int GRowsOfBlock = 4;
template<int N>
constexpr int GPacksOfBlock = N >= 16 ? 4 : 2;

DRYDOCK_LANES_INLINE int32_t HoldBetween(int32_t X, int32_t Low, int32_t High)
{
	return X < Low ? Low : X > High ? High : X;
}

/** The weights of all taps, from the lowest texel on. */
inline float* SpreadWeights(const FTexelSum& Sum)
{
	float* const Weights = static_cast<float*>(GetTapMemory(0, size_t(2 * Sum.Reach + 1) * sizeof(float)));
	for (int32_t Tap = 0; Tap <= 2 * Sum.Reach; ++Tap)
	{
		Weights[Tap] = Sum.Weights[Tap < Sum.Reach ? Sum.Reach - Tap : Tap - Sum.Reach];
	}
	return Weights;
}

template<int N, int C>
struct TTexelSum
{
	using FFloat = TRaw<float, N>;

	const FTexelSum& Sum;
	const FKernelTexture& Target;
	const FKernelTile& Pixels;
	int32_t FirstX; // of the source, of the first tap
	int32_t FirstY;
	const float* Weights;
	/** Texels of a vector. */
	static constexpr int Shifts = N / C < 1 ? 1 : N / C;
	const int32_t NumTaps = 2 * Sum.Reach + 1;
	const FKernelMip& From = Sum.Source->Mips[0];

	void Decode(int32_t X, int32_t Y, int32_t Count, float* Out) const
	{
		constexpr int32_t Ahead = 2;
		const int32_t Last = Sum.RectMax[1] - 1;
		const int32_t Held = HoldBetween(Y, Sum.RectMin[1], Last);
		const int32_t Later = HoldBetween(Y + Ahead, Sum.RectMin[1], Last);
		DecodeHeldStrip<N, C>(Sum.Source->Storage, From.Data + int64_t(Held) * From.RowPitch, Sum.RectMin[0],
			Sum.RectMax[0], X, Count, Out, ptrdiff_t(Later - Held) * From.RowPitch);
	}

	/** Copies of a strip, each begun a texel further on: then a tap's loads begin where a vector does. */
	static void Shift(float* Strip, int32_t Pitch)
	{
		for (int32_t i = 0; i < Pitch - N; i += N)
		{
			for (int Copy = 1; Copy < Shifts; ++Copy)
			{
				StoreRaw(Strip + Copy * Pitch + i, LoadRaw<FFloat>(Strip + i + Copy * C));
			}
		}
	}

	/** Pitch: of the strip's copies; 0: there is the one. */
	DRYDOCK_LANES_INLINE void SumPacks(const float* Strip, int32_t Pitch, float* Out) const
	{
		FFloat Sums[GPacksAlongRow] = {};
		for (int32_t Tap = 0; Tap < NumTaps; ++Tap)
		{
			const FFloat Weight = Broadcast<float, N>(Weights[Tap]);
			const float* const Texels = Pitch == 0 ? Strip + Tap * C : Strip + Tap % Shifts * Pitch + Tap / Shifts * N;
#pragma GCC unroll 8
			for (int i = 0; i < GPacksAlongRow; ++i)
			{
				Sums[i] = Sums[i] + Weight * LoadRaw<FFloat>(Texels + i * N);
			}
		}
#pragma GCC unroll 8
		for (int i = 0; i < GPacksAlongRow; ++i)
		{
			StoreRaw(Out + i * N, Sums[i]);
		}
	}

	__attribute__((noinline)) void SumRows() const
	{
		constexpr int32_t Group = GPacksAlongRow * N;
		const int32_t Width = Pixels.MaxX - Pixels.MinX;
		const int32_t Count = Width + NumTaps - 1;
		const size_t Floats = size_t(Width) * C + Group;
		// A group begun at the last texel, and a whole step of the decoder, may reach beyond.
		const int32_t StripFloats = (Count * C + Group + 5 * N) / N * N;
		// For few taps the copies cost more than loads that cross lines.
		constexpr int32_t ManyTaps = 16;
		const bool bShifted = Shifts > 1 && NumTaps >= ManyTaps;
		const int32_t Pitch = bShifted ? StripFloats : 0;
		float* const Strip =
			static_cast<float*>(GetTapMemory(1, size_t(bShifted ? Shifts : 1) * size_t(StripFloats) * sizeof(float)));
		float* const Sums = static_cast<float*>(GetTapMemory(2, (Floats + 4 * N) * sizeof(float)));
		for (int32_t Y = Pixels.MinY; Y < Pixels.MaxY; ++Y)
		{
			Decode(FirstX, FirstY + Y - Pixels.MinY, Count, Strip);
			if (bShifted)
			{
				Shift(Strip, Pitch);
			}
			for (int32_t i = 0; i < Width * C; i += Group)
			{
				SumPacks(Strip + i, Pitch, Sums + i);
			}
			StoreStrip<N, C>(Target, Sums, Pixels.MinX, Y, Width);
		}
	}

	/** The tap of row Row for the block's rows; bAll: it has one for each of them. */
	template<bool bAll, int P>
	DRYDOCK_LANES_INLINE void AddRow(const float* Texels, int32_t Row, FFloat (&Sums)[GRowsOfBlock][P]) const
	{
		FFloat Values[P];
#pragma GCC unroll 4
		for (int i = 0; i < P; ++i)
		{
			Values[i] = LoadRaw<FFloat>(Texels + i * N);
		}
#pragma GCC unroll 4
		for (int Out = 0; Out < GRowsOfBlock; ++Out)
		{
			if (bAll || (Row >= Out && Row - Out < NumTaps))
			{
				const FFloat Weight = Broadcast<float, N>(Weights[Row - Out]);
#pragma GCC unroll 4
				for (int i = 0; i < P; ++i)
				{
					Sums[Out][i] = Sums[Out][i] + Weight * Values[i];
				}
			}
		}
	}

	/** Rows: those of the first tap of the block's first row, and on. */
	DRYDOCK_LANES_INLINE void SumBlock(const float* const* Rows, int32_t Offset, float* Out, int32_t OutPitch) const
	{
		constexpr int P = GPacksOfBlock<N>;
		FFloat Sums[GRowsOfBlock][P] = {};
		const int32_t Full = NumTaps < GRowsOfBlock ? 0 : NumTaps - GRowsOfBlock + 1;
		int32_t Row = 0;
		for (; Row < GRowsOfBlock - 1; ++Row)
		{
			AddRow<false, P>(Rows[Row] + Offset, Row, Sums);
		}
		for (; Row < GRowsOfBlock - 1 + Full; ++Row)
		{
			AddRow<true, P>(Rows[Row] + Offset, Row, Sums);
		}
		for (; Row < NumTaps + GRowsOfBlock - 1; ++Row)
		{
			AddRow<false, P>(Rows[Row] + Offset, Row, Sums);
		}
#pragma GCC unroll 4
		for (int i = 0; i < GRowsOfBlock; ++i)
		{
#pragma GCC unroll 4
			for (int k = 0; k < P; ++k)
			{
				StoreRaw(Out + i * OutPitch + k * N, Sums[i][k]);
			}
		}
	}

	__attribute__((noinline)) void SumColumns() const
	{
		constexpr int32_t Group = GPacksOfBlock<N> * N;
		constexpr int32_t Narrowest = 16;
		constexpr int32_t CacheBytes = 256 << 10;
		const int32_t Width = Pixels.MaxX - Pixels.MinX;
		const int32_t Height = Pixels.MaxY - Pixels.MinY;
		// A block begun at the last row reads beyond it: the edge row, whose sums nobody stores.
		const int32_t NumRows = Height + NumTaps - 1 + GRowsOfBlock;
		const int32_t Fits = CacheBytes / (NumRows * C * 4) / Narrowest * Narrowest;
		const int32_t Chunk = HoldBetween(Fits, Narrowest, Width < Narrowest ? Narrowest : Width);
		const int32_t Pitch = Chunk * C + Group + 4 * N;
		float* const Texels = static_cast<float*>(GetTapMemory(1, size_t(NumRows) * size_t(Pitch) * sizeof(float)));
		float* const Sums = static_cast<float*>(GetTapMemory(2, size_t(GRowsOfBlock) * size_t(Pitch) * sizeof(float)));
		const float** const Rows = static_cast<const float**>(GetTapMemory(3, size_t(NumRows) * sizeof(float*)));
		for (int32_t Column = 0; Column < Width; Column += Chunk)
		{
			const int32_t Count = Width - Column < Chunk ? Width - Column : Chunk;
			int32_t Last = -1;
			for (int32_t Row = 0; Row < NumRows; ++Row)
			{
				const int32_t Y = HoldBetween(FirstY + Row, Sum.RectMin[1], Sum.RectMax[1] - 1);
				Rows[Row] = Row > 0 && Y == Last ? Rows[Row - 1] : Texels + int64_t(Row) * Pitch;
				if (Row == 0 || Y != Last)
				{
					Decode(FirstX + Column, Y, Count, Texels + int64_t(Row) * Pitch);
				}
				Last = Y;
			}
			for (int32_t Y = 0; Y < Height; Y += GRowsOfBlock)
			{
				for (int32_t i = 0; i < Count * C; i += Group)
				{
					SumBlock(Rows + Y, i, Sums + i, Pitch);
				}
				for (int32_t Row = 0; Row < GRowsOfBlock && Y + Row < Height; ++Row)
				{
					StoreStrip<N, C>(
						Target, Sums + int64_t(Row) * Pitch, Pixels.MinX + Column, Pixels.MinY + Y + Row, Count);
				}
			}
		}
	}
};

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes

namespace Drydock
{

template<int N>
void TTexelSumLanes<N>::Run(
	const FTexelSum& Sum, const FKernelTexture& Target, const FKernelTile& Pixels, int32_t ToSourceX, int32_t ToSourceY)
{
	const float* const Weights = Lanes::SpreadWeights(Sum);
	const int32_t FirstX = Pixels.MinX + ToSourceX - (Sum.Axis == 0 ? Sum.Reach : 0);
	const int32_t FirstY = Pixels.MinY + ToSourceY - (Sum.Axis == 1 ? Sum.Reach : 0);
	Lanes::VisitStripChannels(Lanes::GetStripChannels(Target.Storage),
		[&](auto Channels)
		{
			const Lanes::TTexelSum<N, Channels> Tile{Sum, Target, Pixels, FirstX, FirstY, Weights};
			Sum.Axis == 0 ? Tile.SumRows() : Tile.SumColumns();
			Lanes::FinishStreaming();
		});
}

} // namespace Drydock
