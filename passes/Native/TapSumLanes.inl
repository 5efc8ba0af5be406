// The sum of taps in lanes: few taps by the lines of samples that they share (TapLineStretches.inl); others in chunks
// of columns whose source rows stay in the cache, row by row, channel by channel, four vectors side by side. Included
// by TapSum_*.cpp only.
#pragma once

#include "Native/TapLineStretches.inl"
#include "Native/TapSumColumns.inl"
#include "Native/TapSumStores.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** A tap of one row: lane i is A[i], or, where Weight is not 0, A[i] mixed with B[i]; outside Begin and End A[i] alone.
 * The pointers are the first channel's; the other channels follow a stride apart. */
struct FTapRow
{
	const float* A;
	const float* B;
	float Weight;
	int32_t Begin;
	int32_t End;
	const float* Weights; // of the channels
};

/** Lanes 1 to N of A and B side by side. */
template<int N>
DRYDOCK_LANES_INLINE TRaw<float, N> ShiftByOne(TRaw<float, N> A, TRaw<float, N> B)
{
	return ShuffleLanes(A, B, [](int Lane) { return Lane + 1; });
}

/** V vectors of one channel. bCareful: where a mixture is NaN, the sampler's other rule decides. */
template<int N, int V, bool bCareful>
DRYDOCK_LANES_INLINE void SumVectors(
	const FTapRow* Taps, int32_t NumTaps, ptrdiff_t From, int Channel, int32_t Lane, bool bFromZero, float* Out)
{
	using FFloat = TRaw<float, N>;
	FFloat Sums[V] = {};
	for (int32_t Index = 0; Index < NumTaps; ++Index)
	{
		const FTapRow& Tap = Taps[Index];
		FFloat Values[V + 1];
#pragma GCC unroll 4
		for (int v = 0; v < V; ++v)
		{
			Values[v] = LoadRaw<FFloat>(Tap.A + From + Lane + v * N);
		}
		// Neighbours along a row are shifted out of what is there: most loads would cross a line.
		const bool bBeside = V > 1 && Tap.B == Tap.A + 1;
		if (bBeside)
		{
			Values[V] = LoadRaw<FFloat>(Tap.A + From + Lane + V * N);
		}
		if (Tap.Weight != 0)
		{
			const FFloat Weight = Broadcast<float, N>(Tap.Weight);
			const bool bAll = Lane >= Tap.Begin && Lane + V * N <= Tap.End;
#pragma GCC unroll 4
			for (int v = 0; v < V; ++v)
			{
				const FFloat B =
					bBeside ? ShiftByOne<N>(Values[v], Values[v + 1]) : LoadRaw<FFloat>(Tap.B + From + Lane + v * N);
				FFloat Mixed;
				if constexpr (bCareful)
				{
					Mixed = MixCarefully<N>(Values[v], B, Weight);
				}
				else
				{
					Mixed = Values[v] + Weight * (B - Values[v]);
				}
				if (__builtin_expect(!bAll, 0))
				{
					const TRaw<int32_t, N> Place = LaneIndex<N>().V + (Lane + v * N);
					Mixed = ((Place >= Tap.Begin) & (Place < Tap.End)) ? Mixed : Values[v];
				}
				Values[v] = Mixed;
			}
		}
		const float Factor = Tap.Weights[Channel];
		if (Factor != 1.0f)
		{
			const FFloat Factors = Broadcast<float, N>(Factor);
#pragma GCC unroll 4
			for (int v = 0; v < V; ++v)
			{
				Values[v] = Values[v] * Factors;
			}
		}
		if (Index == 0 && !bFromZero)
		{
#pragma GCC unroll 4
			for (int v = 0; v < V; ++v)
			{
				Sums[v] = Values[v];
			}
		}
		else
		{
#pragma GCC unroll 4
			for (int v = 0; v < V; ++v)
			{
				Sums[v] = Sums[v] + Values[v];
			}
		}
	}
#pragma GCC unroll 4
	for (int v = 0; v < V; ++v)
	{
		StoreRaw(Out + Lane + v * N, Sums[v]);
	}
}

/** Count lanes of one channel; true when none is NaN. */
template<int N, bool bCareful>
__attribute__((noinline)) bool SumRow(
	const FTapRow* Taps, int32_t NumTaps, ptrdiff_t From, int Channel, int32_t Count, bool bFromZero, float* Out)
{
	int32_t Lane = 0;
	for (; Lane + GTapGroup * N <= Count; Lane += GTapGroup * N)
	{
		SumVectors<N, GTapGroup, bCareful>(Taps, NumTaps, From, Channel, Lane, bFromZero, Out);
	}
	for (; Lane < Count; Lane += N)
	{
		SumVectors<N, 1, bCareful>(Taps, NumTaps, From, Channel, Lane, bFromZero, Out);
	}
	bool bNan = false;
	for (Lane = 0; Lane < Count && !bCareful; Lane += N)
	{
		const TRaw<float, N> Sum = LoadRaw<TRaw<float, N>>(Out + Lane);
		bNan |= TLaneOps<N>::AnyNan(Sum, Sum);
	}
	return !bNan;
}

/** The sums of one source over a chunk: Width pixels from column First of the tile on. */
template<int N>
struct TSourceChunk
{
	using FFloat = TRaw<float, N>;

	static constexpr int32_t Endless = 1 << 30;

	const FSourcePlan& Plan;
	int32_t Channels;
	int32_t First;
	int32_t Width;
	int32_t Pitch; // floats of a channel of what comes out
	TTexelRows<N> Rows;
	TMixedRows<N> Mixed;
	FTapRow* Taps;
	float* Resampled;

	TSourceChunk(const FSourcePlan& InPlan, int32_t InChannels, int32_t InFirst, int32_t InWidth, int32_t InPitch)
		: Plan(InPlan)
		, Channels(InChannels)
		, First(InFirst)
		, Width(InWidth)
		, Pitch(InPitch)
		, Rows(MakeRows(InPlan, InChannels, InFirst, InWidth))
		, Mixed(Rows, InPlan.Source->NumTaps)
		, Taps(static_cast<FTapRow*>(GetTapMemory(TapRowsMemory, 2 * size_t(InPlan.Source->NumTaps) * sizeof(FTapRow))))
		, Resampled(nullptr)
	{
		if (Plan.Step == 0)
		{
			const size_t Floats = size_t(Plan.Source->NumTaps) * size_t(Channels) * size_t(Pitch);
			Resampled = static_cast<float*>(GetTapMemory(ResampledMemory, Floats * sizeof(float)));
		}
	}

	/** Row of the tile; Out is [channels][Pitch], Scratch [channels][2][Pitch]. */
	void SumOneRow(int32_t Row, float* Out, float* Scratch)
	{
		const FTapSource& Source = *Plan.Source;
		const int32_t Streams = Plan.Step == 128 ? 2 : 1;
		const int32_t Count = (Width + Streams - 1) / Streams;
		for (int32_t Index = 0; Index < Source.NumTaps; ++Index)
		{
			for (int32_t Stream = 0; Stream < Streams; ++Stream)
			{
				FTapRow& Tap = Taps[Stream * Source.NumTaps + Index];
				Tap = Plan.Step == 0 ? Resample(Index, Row) : FindTexels(Plan.Taps[Index], Row, Stream, Streams);
				Tap.Weights = Source.Taps[Index].Weight;
			}
		}
		for (int32_t Stream = 0; Stream < Streams; ++Stream)
		{
			const FTapRow* const StreamTaps = Taps + Stream * Source.NumTaps;
			for (int32_t c = 0; c < Channels; ++c)
			{
				float* const To = Streams == 1 ? Out + c * Pitch : Scratch + (c * 2 + Stream) * Pitch;
				const ptrdiff_t From = ptrdiff_t(c) * (Plan.Step == 0 ? Pitch : Rows.Stride);
				if (!SumRow<N, false>(StreamTaps, Source.NumTaps, From, c, Count, Source.bFromZero, To))
				{
					SumRow<N, true>(StreamTaps, Source.NumTaps, From, c, Count, Source.bFromZero, To);
				}
			}
		}
		for (int32_t c = 0; c < Channels && Streams == 2; ++c)
		{
			Interleave(Scratch + c * 2 * Pitch, Scratch + (c * 2 + 1) * Pitch, Out + c * Pitch);
		}
	}

	/** Rows of the tile from Row on, a block of them; Out is [rows][channels][Pitch], Scratch twice that. */
	void SumBlock(int32_t Row, float* Out, float* Scratch)
	{
		const int32_t NumTaps = Plan.Source->NumTaps;
		auto* const Columns =
			static_cast<FTapColumn*>(GetTapMemory(ColumnsMemory, size_t(NumTaps) * sizeof(FTapColumn)));
		for (int32_t Index = 0; Index < NumTaps; ++Index)
		{
			const int32_t Place = Plan.Taps[Index].FirstRow + 256 * Row;
			for (int32_t i = 0; i <= GRowsOfTapBlock; ++i)
			{
				Columns[Index].Rows[i] = Rows.GetHeld(TexelBelow(Place) + i);
			}
			Columns[Index].Weight = WeightOfNext(Place);
			Columns[Index].Weights = Plan.Source->Taps[Index].Weight;
		}
		const ptrdiff_t RowPitch = ptrdiff_t(Channels) * Pitch;
		const int32_t Streams = Plan.Step == 128 ? 2 : 1;
		bool bNumbers = true;
		for (int32_t Stream = 0; Stream < Streams && bNumbers; ++Stream)
		{
			const int32_t Place = Plan.Taps[0].First + Plan.Step * (First + Stream);
			const int32_t Column = TexelBelow(Place) - Rows.FirstColumn;
			const FColumnPair Pair = {Column, Column + 1, WeightOfNext(Place)};
			float* const To = Streams == 1 ? Out : Scratch + Stream * GRowsOfTapBlock * RowPitch;
			for (int32_t c = 0; c < Channels && bNumbers; ++c)
			{
				const auto SumRows = Pair.Weight == 0 ? &SumColumnRows<N, false> : &SumColumnRows<N, true>;
				bNumbers = SumRows(Columns, NumTaps, Pair, ptrdiff_t(c) * Rows.Stride, c,
					(Width + Streams - 1) / Streams, To + ptrdiff_t(c) * Pitch, RowPitch);
			}
		}
		for (int32_t i = 0; i < GRowsOfTapBlock && !bNumbers; ++i)
		{
			SumOneRow(Row + i, Out + i * RowPitch, Scratch);
		}
		for (int32_t i = 0; i < GRowsOfTapBlock * Channels && bNumbers && Streams == 2; ++i)
		{
			const float* const Even = Scratch + ptrdiff_t(i) * Pitch;
			Interleave(Even, Even + GRowsOfTapBlock * RowPitch, Out + ptrdiff_t(i) * Pitch);
		}
	}

private:
	/** The columns that the taps of a chunk read. */
	static TTexelRows<N> MakeRows(const FSourcePlan& Plan, int32_t Channels, int32_t First, int32_t Width)
	{
		int32_t Lowest = 1 << 30;
		int32_t Highest = -(1 << 30);
		const auto Take = [&](int32_t Place)
		{
			const int32_t Below = TexelBelow(Place);
			Lowest = Below < Lowest ? Below : Lowest;
			Highest = Below > Highest ? Below : Highest;
		};
		for (int32_t Index = 0; Index < Plan.Source->NumTaps; ++Index)
		{
			const FTapPlan& Tap = Plan.Taps[Index];
			for (int32_t X = First; X < First + Width; X += Plan.Step == 0 || Width == 1 ? 1 : Width - 1)
			{
				Take(Plan.Step == 0 ? Tap.Columns[X] : Tap.First + Plan.Step * X);
			}
		}
		return TTexelRows<N>(Plan, Channels, Lowest, Highest + 2 - Lowest);
	}

	/** The texels for every Streams-th pixel from Stream on. */
	FTapRow FindTexels(const FTapPlan& Tap, int32_t Row, int32_t Stream, int32_t Streams)
	{
		const int32_t Pixel = First + Stream;
		const int32_t Place = Tap.First + Plan.Step * Pixel;
		const int32_t Column = TexelBelow(Place) - Rows.FirstColumn;
		const int32_t Half = Rows.Stride / 2;
		const int32_t Left = !Rows.bSplit ? Column : (Column & 1) * Half + (Column >> 1);
		const int32_t Right = !Rows.bSplit ? Column + 1 : (Column & 1 ? 0 : Half) + ((Column + 1) >> 1);
		const float WeightX = WeightOfNext(Place);
		const float WeightY = WeightOfNext(Tap.Rows[Row]);
		const float* const Top = WeightY == 0 || WeightX == 0 ? Rows.Get(TexelBelow(Tap.Rows[Row])) : nullptr;
		if (WeightX == 0)
		{
			const float* const Bottom = WeightY == 0 ? Top : Rows.Get(TexelBelow(Tap.Rows[Row]) + 1);
			return {Top + Left, Bottom + Left, WeightY, 0, Endless, nullptr};
		}
		const float* const Texels = Top ? Top : Mixed.Get(Tap.Rows[Row]);
		// Lanes past the chunk are anything.
		const bool bEnds = Tap.End < First + Width;
		return {Texels + Left, Texels + Right, WeightX, CeilDivide(Tap.Begin - Pixel, Streams),
			bEnds ? CeilDivide(Tap.End - Pixel, Streams) : Endless, nullptr};
	}

	/** Each pixel from its own place. */
	FTapRow Resample(int32_t Index, int32_t Row)
	{
		using FInt = TRaw<int32_t, N>;
		using FOps = TLaneOps<N>;
		const FTapPlan& Tap = Plan.Taps[Index];
		const float* const Texels =
			WeightOfNext(Tap.Rows[Row]) == 0 ? Rows.Get(TexelBelow(Tap.Rows[Row])) : Mixed.Get(Tap.Rows[Row]);
		float* const Out = Resampled + size_t(Index) * size_t(Channels) * size_t(Pitch);
		for (int32_t X = 0; X < Width; X += N)
		{
			FInt Places = LoadRaw<FInt>(Tap.Columns + First + X);
			// Past the chunk's last pixel lie places of another chunk, or of none.
			Places = LaneIndex<N>().V + X < Width ? Places : Broadcast<int32_t, N>(Tap.Columns[First]);
			const FInt Fixed = Places - 128;
			const FInt Offsets = ((Fixed >> 8) - Rows.FirstColumn) * 4;
			const FFloat Weight = __builtin_convertvector(Fixed & 255, FFloat) * Broadcast<float, N>(1.0f / 256);
			// A picture that is enlarged: all in one vector of texels.
			const FInt Beside = (Fixed >> 8) - (Fixed[0] >> 8);
			const bool bNear = FOps::bHasPermute && !AnyLane(TMask<N>((Beside < 0) | (Beside > N - 2)));
			for (int32_t c = 0; c < Channels; ++c)
			{
				const auto* const Base = reinterpret_cast<const uint8_t*>(Texels + c * Rows.Stride);
				FFloat A;
				FFloat B;
				if (bNear)
				{
					const FFloat Both = LoadRaw<FFloat>(Base + Offsets[0]);
					A = FOps::Permute(Both, Beside);
					B = FOps::Permute(Both, Beside + 1);
				}
				else
				{
					A = FFloat(FOps::Gather(Base, Offsets));
					B = FFloat(FOps::Gather(Base, Offsets + 4));
				}
				const FFloat Mixture = MixCarefully<N>(A, B, Weight);
				StoreRaw(Out + c * Pitch + X, Weight == 0.0f ? A : Mixture);
			}
		}
		return {Out, Out, 0.0f, 0, Endless, nullptr};
	}

	static DRYDOCK_LANES_INLINE int32_t CeilDivide(int32_t X, int32_t Streams)
	{
		return Streams == 1 ? X : (X + 1) >> 1;
	}

	void Interleave(const float* Even, const float* Odd, float* Out) const
	{
		using FUint = TRaw<uint32_t, N>;
		for (int32_t X = 0; X < Width; X += 2 * N)
		{
			const FUint Halves[2] = {LoadRaw<FUint>(Even + X / 2), LoadRaw<FUint>(Odd + X / 2)};
			FUint Both[2];
			TLaneOps<N>::Interleave(Halves, Both);
			StoreRaw(Out + X, Both[0]);
			StoreRaw(Out + X + N, Both[1]);
		}
	}
};

/** Columns of a chunk: as many as keep the first source's rows in the cache. */
inline int32_t ChooseChunk(const FSourcePlan& Plan, int32_t Channels, int32_t TileWidth)
{
	const int64_t CacheBytes = (Plan.bInBlocks ? 128 : 48) << 10;
	constexpr int32_t Narrowest = 64;
	const int64_t Step = Plan.Step == 0 ? 256 : Plan.Step;
	const int64_t BytesAPixel = int64_t(Plan.LiveRows) * Channels * 4 * Step / 256 + 1;
	const int64_t Fits = CacheBytes / BytesAPixel / Narrowest * Narrowest;
	return Fits >= TileWidth ? TileWidth : Fits < Narrowest ? Narrowest : int32_t(Fits);
}

/** False when a source cannot be planned; OutPlans has one for each source. */
template<int N>
inline bool PlanSources(const FTapSum& Sum, const FKernelTile& Tile, FSourcePlan* OutPlans)
{
	int32_t NumTaps = 0;
	for (int32_t Index = 0; Index < Sum.NumSources; ++Index)
	{
		NumTaps += Sum.Sources[Index].NumTaps;
	}
	const size_t IntsATap = 2 * size_t(RoundUpTo(Tile.MaxX - Tile.MinX, N) + RoundUpTo(Tile.MaxY - Tile.MinY, N));
	// A pack is also read from the last column on.
	int32_t* Ints =
		static_cast<int32_t*>(GetTapMemory(PlacesMemory, (size_t(NumTaps) * IntsATap + N) * sizeof(int32_t)));
	FTapPlan* TapPlans = static_cast<FTapPlan*>(GetTapMemory(TapPlansMemory, size_t(NumTaps) * sizeof(FTapPlan)));
	for (int32_t Index = 0; Index < Sum.NumSources; ++Index)
	{
		const FTapSource& Source = Sum.Sources[Index];
		if (!PlanSource<N>(Source, Tile, Ints, TapPlans, OutPlans[Index]))
		{
			return false;
		}
		OutPlans[Index].bInBlocks = Index == 0 && CanSumInBlocks(OutPlans[Index]);
		Ints += size_t(Source.NumTaps) * IntsATap;
		TapPlans += Source.NumTaps;
	}
	return true;
}

template<int N>
inline bool SumTile(
	const FTapSum& Sum, const FKernelTexture& Target, const FKernelTile& Tile, int32_t ToTargetX, int32_t ToTargetY)
{
	constexpr int32_t MostSources = 2;
	const int32_t Width = Tile.MaxX - Tile.MinX;
	const int32_t Height = Tile.MaxY - Tile.MinY;
	const int32_t Channels = GetTexelStorageInfo(Target.Storage).NumChannels;
	if (Sum.NumSources > MostSources)
	{
		return false;
	}
	FSourcePlan Plans[MostSources];
	if (!PlanSources<N>(Sum, Tile, Plans))
	{
		return false;
	}
	if (Sum.NumSources == 1 && SumTapLines<N>(Sum, Plans[0], Target, Tile, ToTargetX, ToTargetY))
	{
		return true;
	}

	const int32_t Chunk = ChooseChunk(Plans[0], Channels, Width);
	// Floats of a channel's row: two streams write whole packs.
	const int32_t Pitch = RoundUpTo(Chunk, 2 * N) + GTapGroup * N;
	const size_t RowFloats = size_t(Channels) * size_t(Pitch);
	const int32_t KeptRows = RoundUpTo(Height, GRowsOfTapBlock);
	float* const Sums = static_cast<float*>(
		GetTapMemory(SumsMemory, (size_t(KeptRows) + 1 + 2 * GRowsOfTapBlock) * RowFloats * sizeof(float)));
	float* const Other = Sums + size_t(KeptRows) * RowFloats;
	float* const Scratch = Other + RowFloats;
	const FKernelMip& Mip = Target.Mips[0];
	const int32_t Bytes = GetTexelStorageInfo(Target.Storage).BytesPerTexel;
	for (int32_t First = 0; First < Width; First += Chunk)
	{
		const int32_t ChunkWidth = Width - First < Chunk ? Width - First : Chunk;
		const auto Store = [&](int32_t Row, const float* RowSums)
		{
			uint8_t* const Place = Mip.Data + int64_t(Tile.MinY + Row + ToTargetY) * Mip.RowPitch +
								   int64_t(Tile.MinX + First + ToTargetX) * Bytes;
			StoreSums<N>(Sum, Target, Channels, ChunkWidth, Pitch, RowSums, Place);
		};
		for (int32_t Index = 0; Index < Sum.NumSources; ++Index)
		{
			TSourceChunk<N> SourceChunk(Plans[Index], Channels, First, ChunkWidth, Pitch);
			const bool bLast = Index + 1 == Sum.NumSources;
			for (int32_t Row = 0; Row < Height; ++Row)
			{
				// All rows are kept if another source is added to them.
				float* const RowSums = Sums + size_t(Sum.NumSources == 1 ? Row % GRowsOfTapBlock : Row) * RowFloats;
				if (!Plans[Index].bInBlocks || Row >= Height / GRowsOfTapBlock * GRowsOfTapBlock)
				{
					SourceChunk.SumOneRow(Row, Index == 0 ? RowSums : Other, Scratch);
				}
				else if (Row % GRowsOfTapBlock == 0)
				{
					SourceChunk.SumBlock(Row, RowSums, Scratch);
				}
				for (size_t X = 0; X < RowFloats && Index > 0; X += N)
				{
					StoreRaw(RowSums + X, LoadRaw<TRaw<float, N>>(RowSums + X) + LoadRaw<TRaw<float, N>>(Other + X));
				}
				if (bLast)
				{
					Store(Row, RowSums);
				}
			}
		}
	}
	return true;
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes

namespace Drydock
{

template<int N>
bool TTapSumLanes<N>::Run(
	const FTapSum& Sum, const FKernelTexture& Target, const FKernelTile& Tile, int32_t ToTargetX, int32_t ToTargetY)
{
	const bool bDone = Lanes::SumTile<N>(Sum, Target, Tile, ToTargetX, ToTargetY);
	Lanes::FinishStreaming();
	return bDone;
}

} // namespace Drydock
