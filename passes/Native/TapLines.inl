// Few bilinear taps whose samples neighbouring pixels share: each sample is mixed once, into a line of samples one to a
// pixel, and a tap is that line, shifted by whole pixels. Dual Kawase, the pyramid, halving. Included by
// TapLineStretches.inl only.
#pragma once

#include "Native/StripStores.inl"
#include "Native/TapLinePlan.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Texels of A and B in turn: the first N lanes of them, or the next. */
template<int N, int C, int Part>
DRYDOCK_LANES_INLINE TRaw<float, N> AlternateTexels(TRaw<float, N> A, TRaw<float, N> B)
{
	const auto Choose = [](int Lane)
	{
		const int Texel = (Lane + Part * N) / C;
		return (Texel & 1) * N + (Texel >> 1) * C + Lane % C;
	};
	return ShuffleLanes(A, B, Choose);
}

/** The sums of a tile of one source whose taps are lines. C: floats of a texel. */
template<int N, int C>
class TTapLines
{
	using FFloat = TRaw<float, N>;

	/** Floats that whole vectors may read and write beyond a row. */
	static constexpr int32_t Beside = 8 * N;
	static constexpr int32_t NoRow = -(1 << 30);
	/** Vectors that are summed side by side. */
	static constexpr int Group = 4;

public:
	TTapLines(const FTapSum& InSum, const FSourcePlan& InPlan, const FLinePlan& InLines, const FKernelTexture& InTarget,
		const FKernelTile& InTile)
		: Sum(InSum)
		, Plan(InPlan)
		, Lines(InLines)
		, Source(*InPlan.Source)
		, Target(InTarget)
		, Tile(InTile)
		, TexelFloats(RoundUpTo(InLines.NumTexels * C, N) + Beside)
		, LineFloats(RoundUpTo(InLines.NumPositions * C, N) + Beside)
	{
		const int32_t NumStrips = Plan.LiveRows + 1;
		Strips =
			static_cast<float*>(GetTapMemory(TexelRowsMemory, size_t(NumStrips) * size_t(TexelFloats) * sizeof(float)));
		Mixed = Strips + size_t(Plan.LiveRows) * size_t(TexelFloats);
		StripRows = static_cast<int32_t*>(GetTapMemory(FlagsMemory, size_t(Plan.LiveRows) * sizeof(int32_t)));
		for (int32_t Slot = 0; Slot < Plan.LiveRows; ++Slot)
		{
			StripRows[Slot] = NoRow;
		}
		LineTexels = static_cast<float*>(
			GetTapMemory(ResampledMemory, (size_t(2 * GMostLineTaps + 1) * size_t(LineFloats) + N) * sizeof(float)));
		DriftingWeights = LineTexels + size_t(GMostLineTaps) * size_t(LineFloats);
		Sums = DriftingWeights + size_t(GMostLineTaps) * size_t(LineFloats);
		for (int32_t Index = 0; Index < Lines.NumColumns && Lines.Columns[Index].Drifting; ++Index)
		{
			float* const To = DriftingWeights + size_t(Index) * size_t(LineFloats);
			for (int32_t i = 0; i < Lines.NumPositions * C; ++i)
			{
				To[i] = WeightOfNext(Lines.Columns[Index].Drifting[i / C]);
			}
		}
		for (int32_t Index = 0; Index < Source.NumTaps; ++Index)
		{
			for (int32_t Lane = 0; Lane < N; ++Lane)
			{
				Weights[Index][Lane] = Source.Taps[Index].Weight[Lane % C];
				bWeightless = bWeightless && Weights[Index][Lane] == 1.0f;
			}
		}
		// Floats that lie in the texture as they are wanted are read there.
		const bool bSameFloats = (C == 4 && Source.Texture->Storage == ETexelStorage::RGBA32_FLOAT) ||
								 (C == 1 && Source.Texture->Storage == ETexelStorage::R32_FLOAT);
		bInPlace = bSameFloats && Lines.FirstTexel >= Source.RectMin[0] &&
				   Lines.FirstTexel + Lines.NumTexels + Beside / C <= Source.RectMax[0];
	}

	/** False, with anything stored, where a sum is NaN: other rules decide there. */
	bool Run(int32_t ToTargetX, int32_t ToTargetY)
	{
		const int32_t Width = Tile.MaxX - Tile.MinX;
		const FKernelMip& Mip = Target.Mips[0];
		const int32_t Bytes = GetTexelStorageInfo(Target.Storage).BytesPerTexel;
		for (int32_t Row = 0; Row < Tile.MaxY - Tile.MinY; ++Row)
		{
			const float* Taps[GMostLineTaps];
			// Lines that are known first, so that none of them makes room for another.
			for (int Pass = 0; Pass < 2; ++Pass)
			{
				for (int32_t Index = 0; Index < Source.NumTaps; ++Index)
				{
					const FLineTap& Tap = Lines.Taps[Index];
					Taps[Index] = GetLine(Row, Tap.Columns, Plan.Taps[Index].Rows[Row], Pass > 0) + Tap.Shift * C;
				}
			}
			uint8_t* const Place =
				Mip.Data + int64_t(Tile.MinY + Row + ToTargetY) * Mip.RowPitch + int64_t(Tile.MinX + ToTargetX) * Bytes;
			if (!StoreRowOf(Taps, Width, Place))
			{
				return false;
			}
		}
		return true;
	}

private:
	static DRYDOCK_LANES_INLINE FFloat Mix(FFloat A, FFloat B, FFloat Weight) { return A + Weight * (B - A); }

	/** Bytes to the row that is asked for while this one is read. */
	ptrdiff_t GetLater(int32_t Row) const
	{
		constexpr int32_t Ahead = 2;
		const int32_t Rest = Source.RectMax[1] - 1 - Row;
		return ptrdiff_t(Rest < Ahead ? Rest : Ahead) * Source.Texture->Mips[0].RowPitch;
	}

	/** Texels of a row, of the rect, from the first one on. */
	const float* GetRow(int32_t Row)
	{
		const FKernelMip& Mip = Source.Texture->Mips[0];
		const ETexelStorage Storage = Source.Texture->Storage;
		const int32_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
		const int32_t Last = Source.RectMax[1] - 1;
		const int32_t Y = Row < Source.RectMin[1] ? Source.RectMin[1] : Row > Last ? Last : Row;
		const uint8_t* const Texels = Mip.Data + int64_t(Y) * Mip.RowPitch;
		const int32_t Slot = (Y - Source.RectMin[1]) % Plan.LiveRows;
		float* const Strip = Strips + size_t(Slot) * size_t(TexelFloats);
		if (StripRows[Slot] != Y)
		{
			StripRows[Slot] = Y;
			if (!bInPlace)
			{
				DecodeHeldStrip<N, C>(Storage, Texels, Source.RectMin[0], Source.RectMax[0], Lines.FirstTexel,
					Lines.NumTexels, Strip, GetLater(Y));
			}
		}
		return bInPlace ? reinterpret_cast<const float*>(Texels + int64_t(Lines.FirstTexel) * Bytes) : Strip;
	}

	/** The mixture of two rows at a place. */
	const float* MixRows(int32_t Place)
	{
		const float* const A = GetRow(TexelBelow(Place));
		if (WeightOfNext(Place) == 0)
		{
			return A;
		}
		if (MixedPlace != Place)
		{
			MixedPlace = Place;
			const float* const B = GetRow(TexelBelow(Place) + 1);
			const FFloat Weight = Broadcast<float, N>(WeightOfNext(Place));
			float* const Out = Mixed;
			const int32_t Count = Lines.NumTexels * C;
			// Rows that are decoded are asked for there.
			const ptrdiff_t LaterA = bInPlace ? GetLater(TexelBelow(Place)) : 0;
			const ptrdiff_t LaterB = bInPlace ? GetLater(TexelBelow(Place) + 1) : 0;
			for (int32_t i = 0; i < Count; i += N)
			{
				__builtin_prefetch(reinterpret_cast<const char*>(A + i) + LaterA);
				__builtin_prefetch(reinterpret_cast<const char*>(B + i) + LaterB);
				StoreRaw(Out + i, Mix(LoadRaw<FFloat>(A + i), LoadRaw<FFloat>(B + i), Weight));
			}
		}
		return Mixed;
	}

	/** The line of columns at a place, for a row of the tile, which keeps it. */
	const float* GetLine(int32_t Row, int32_t Columns, int32_t Place, bool bMake)
	{
		int32_t Free = 0;
		for (int32_t Slot = 0; Slot < GMostLineTaps; ++Slot)
		{
			FLine& Line = Kept[Slot];
			if (Line.Place == Place && Line.Columns == Columns)
			{
				Line.Row = Row;
				return LineTexels + size_t(Slot) * size_t(LineFloats);
			}
			Free = Kept[Free].Row == Row ? Slot : Free;
		}
		float* const Texels = LineTexels + size_t(Free) * size_t(LineFloats);
		if (bMake)
		{
			Kept[Free] = {Columns, Place, Row};
			MakeLine(Columns, MixRows(Place), Texels);
		}
		return Texels;
	}

	/** Row: texels from the first one on. */
	void MakeLine(int32_t Index, const float* Row, float* Line) const
	{
		const FLineColumns& Columns = Lines.Columns[Index];
		const float* const Texels = Row + (TexelBelow(Columns.Place) - Lines.FirstTexel) * C;
		const float Weight = WeightOfNext(Columns.Place);
		if (Columns.Drifting)
		{
			HalveDrifting(Texels, DriftingWeights + size_t(Index) * size_t(LineFloats), Line);
		}
		else if (Lines.Step == 512)
		{
			Weight == 0 ? HalveTexels<false>(Texels, Weight, Line) : HalveTexels<true>(Texels, Weight, Line);
		}
		else if (Lines.Step == 256)
		{
			Weight == 0 ? MoveTexels<false>(Texels, Weight, Line) : MoveTexels<true>(Texels, Weight, Line);
		}
		else
		{
			DoubleTexels(Columns.Place, Row, Line);
		}
		HoldTexels(Columns, 0, Columns.Begin, Row, Line);
		HoldTexels(Columns, Columns.End, Lines.NumPositions, Row, Line);
	}

	/** The edge texel, unmixed: the row goes on with it. */
	void HoldTexels(const FLineColumns& Columns, int32_t Begin, int32_t End, const float* Row, float* Line) const
	{
		for (int32_t i = Begin; i < End; ++i)
		{
			const int32_t Texel = TexelBelow(Columns.Place + Lines.Step * i) - Lines.FirstTexel;
			__builtin_memcpy(Line + i * C, Row + Texel * C, C * sizeof(float));
		}
	}

	template<bool bMixed>
	DRYDOCK_LANES_INLINE void HalveTexels(const float* Texels, float Weight, float* Line) const
	{
		const FFloat Weights = Broadcast<float, N>(Weight);
		const int32_t Count = Lines.NumPositions * C;
		for (int32_t i = 0; i < Count; i += N)
		{
			const FFloat Low = LoadRaw<FFloat>(Texels + 2 * i);
			const FFloat High = LoadRaw<FFloat>(Texels + 2 * i + N);
			FFloat Value = PickTexels<C, 0>(Low, High);
			if constexpr (bMixed)
			{
				Value = Mix(Value, PickTexels<C, 1>(Low, High), Weights);
			}
			StoreRaw(Line + i, Value);
		}
	}

	/** With a weight for each float of the line. */
	DRYDOCK_LANES_INLINE void HalveDrifting(const float* Texels, const float* PositionWeights, float* Line) const
	{
		const int32_t Count = Lines.NumPositions * C;
		for (int32_t i = 0; i < Count; i += N)
		{
			const FFloat Low = LoadRaw<FFloat>(Texels + 2 * i);
			const FFloat High = LoadRaw<FFloat>(Texels + 2 * i + N);
			const FFloat Value = PickTexels<C, 0>(Low, High);
			const FFloat Weight = LoadRaw<FFloat>(PositionWeights + i);
			const FFloat Mixed = Mix(Value, PickTexels<C, 1>(Low, High), Weight);
			StoreRaw(Line + i, Weight == 0.0f ? Value : Mixed);
		}
	}

	template<bool bMixed>
	DRYDOCK_LANES_INLINE void MoveTexels(const float* Texels, float Weight, float* Line) const
	{
		const FFloat Weights = Broadcast<float, N>(Weight);
		const int32_t Count = Lines.NumPositions * C;
		for (int32_t i = 0; i < Count; i += N)
		{
			FFloat Value = LoadRaw<FFloat>(Texels + i);
			if constexpr (bMixed)
			{
				Value = Mix(Value, LoadRaw<FFloat>(Texels + i + C), Weights);
			}
			StoreRaw(Line + i, Value);
		}
	}

	/** Every second position moves a texel on. */
	DRYDOCK_LANES_INLINE void DoubleTexels(int32_t Place, const float* Row, float* Line) const
	{
		const int32_t Odd = Place + Lines.Step;
		const float* const EvenTexels = Row + (TexelBelow(Place) - Lines.FirstTexel) * C;
		const float* const OddTexels = Row + (TexelBelow(Odd) - Lines.FirstTexel) * C;
		const FFloat EvenWeight = Broadcast<float, N>(WeightOfNext(Place));
		const FFloat OddWeight = Broadcast<float, N>(WeightOfNext(Odd));
		const bool bEvenAlone = WeightOfNext(Place) == 0;
		const bool bOddAlone = WeightOfNext(Odd) == 0;
		const int32_t Count = Lines.NumPositions * C;
		for (int32_t i = 0; i < Count; i += 2 * N)
		{
			FFloat A = LoadRaw<FFloat>(EvenTexels + i / 2);
			FFloat B = LoadRaw<FFloat>(OddTexels + i / 2);
			A = bEvenAlone ? A : Mix(A, LoadRaw<FFloat>(EvenTexels + i / 2 + C), EvenWeight);
			B = bOddAlone ? B : Mix(B, LoadRaw<FFloat>(OddTexels + i / 2 + C), OddWeight);
			StoreRaw(Line + i, AlternateTexels<N, C, 0>(A, B));
			StoreRaw(Line + i + N, AlternateTexels<N, C, 1>(A, B));
		}
	}

	/** V vectors of sums from lane First on, finished; false when one is NaN. NumTaps 0: as many as the source has. */
	template<int NumTaps, int V>
	DRYDOCK_LANES_INLINE bool SumVectors(
		const float* const* Taps, const FFloat* TapWeights, int32_t First, int32_t Count, FFloat Values[V]) const
	{
		const TRaw<int32_t, N> Lane = LaneIndex<N>().V;
		const int32_t Last = NumTaps == 0 ? Source.NumTaps : NumTaps;
#pragma GCC unroll 8
		for (int32_t Index = 0; Index < Last; ++Index)
		{
			const float* const Texels = Taps[Index] + First;
			const FFloat Weight = TapWeights[Index];
#pragma GCC unroll 4
			for (int v = 0; v < V; ++v)
			{
				const FFloat Value = LoadRaw<FFloat>(Texels + v * N);
				// A product with 1 would make the tiny number of a single tap 0.
				const FFloat Product = NumTaps == 1 && bWeightless ? Value : Value * Weight;
				Values[v] = Index > 0 ? Values[v] + Product : bFromZero ? Product + 0.0f : Product;
			}
		}
		bool bNan = false;
#pragma GCC unroll 4
		for (int v = 0; v < V; ++v)
		{
			if (First + V * N <= Count)
			{
				bNan |= TLaneOps<N>::AnyNan(Values[v], Values[v]);
			}
			else
			{
				bNan |= AnyLane(TMask<N>((Values[v] != Values[v]) & (Lane + (First + v * N) < Count)));
			}
			Values[v] = bFactor ? Values[v] * Broadcast<float, N>(Sum.Factor) : Values[v];
			if (bNoNegatives)
			{
				const FFloat Held = Max(TReal<float, N>(Values[v]), TReal<float, N>(0.0f)).V;
				Values[v] = Lane % C == 3 ? Values[v] : Held;
			}
		}
		return !bNan;
	}

	/** Count floats to a row; false when one is NaN. */
	template<int NumTaps, typename FStore>
	DRYDOCK_LANES_INLINE bool SumRow(const float* const* RowTaps, int32_t Count, FStore Store) const
	{
		// Copies, which no store can change.
		constexpr int MostTaps = NumTaps == 0 ? GMostLineTaps : NumTaps;
		const float* Taps[MostTaps];
		FFloat TapWeights[MostTaps];
		for (int Index = 0; Index < (NumTaps == 0 ? Source.NumTaps : NumTaps); ++Index)
		{
			Taps[Index] = RowTaps[Index];
			TapWeights[Index] = LoadRaw<FFloat>(Weights[Index]);
		}
		bool bNumbers = true;
		int32_t i = 0;
		for (; i + Group * N <= Count; i += Group * N)
		{
			FFloat Values[Group] = {};
			bNumbers &= SumVectors<NumTaps, Group>(Taps, TapWeights, i, Count, Values);
#pragma GCC unroll 4
			for (int v = 0; v < Group; ++v)
			{
				Store(i + v * N, Values[v]);
			}
		}
		for (; i < Count; i += N)
		{
			FFloat Value[1] = {};
			bNumbers &= SumVectors<NumTaps, 1>(Taps, TapWeights, i, Count, Value);
			if (i + N <= Count)
			{
				Store(i, Value[0]);
			}
			else
			{
				StoreRaw(Sums, Value[0]);
			}
		}
		return bNumbers;
	}

	bool StoreRowOf(const float* const* Taps, int32_t Width, uint8_t* Place) const
	{
		switch (Source.NumTaps)
		{
		case 1:
			return StoreRow<1>(Taps, Width, Place);
		case 4:
			return StoreRow<4>(Taps, Width, Place);
		case 5:
			return StoreRow<5>(Taps, Width, Place);
		case 8:
			return StoreRow<8>(Taps, Width, Place);
		default:
			return StoreRow<0>(Taps, Width, Place);
		}
	}

	/** Sums of a row of the tile to the target at Place. */
	template<int NumTaps>
	__attribute__((noinline)) bool StoreRow(const float* const* Taps, int32_t Width, uint8_t* Place) const
	{
		constexpr int32_t Step = N / C;
		const int32_t Rest = Width % (Step < 1 ? 1 : Step);
		const int32_t Whole = Width - Rest;
		const ETexelStorage Storage = Target.Storage;
		const bool bWide = C == 4 && Target.bSaturateStore == 0;
		bool bNumbers = true;
		const auto Direct = [&](auto Format, auto bStreamed)
		{
			using FFormat = decltype(Format);
			bNumbers = SumRow<NumTaps>(Taps, Width * C,
				[&](int32_t Lane, FFloat Value)
				{
					uint8_t* const P = Place + Lane / 4 * FFormat::Bytes;
					if constexpr (decltype(bStreamed)::value)
					{
						StreamTexels<N, FFormat>(P, Value);
					}
					else
					{
						FFormat::template Store<N>(P, Value);
					}
				});
			EncodeStrip<N, C>(Target, Sums, Rest, Place + Whole * FFormat::Bytes);
		};
		const bool bStreamed = IsStreamed(Target, Place);
		if (bWide && Storage == ETexelStorage::RGBA32_FLOAT)
		{
			bStreamed ? Direct(FRgba32Format{}, std::true_type{}) : Direct(FRgba32Format{}, std::false_type{});
		}
		else if (bWide && Storage == ETexelStorage::RGBA16_FLOAT)
		{
			bStreamed ? Direct(FRgba16Format{}, std::true_type{}) : Direct(FRgba16Format{}, std::false_type{});
		}
		else
		{
			float* const Row = Sums + N;
			bNumbers =
				SumRow<NumTaps>(Taps, Width * C, [&](int32_t Lane, FFloat Value) { StoreRaw(Row + Lane, Value); });
			__builtin_memcpy(Row + Whole * C, Sums, size_t(Rest) * C * sizeof(float));
			EncodeStrip<N, C>(Target, Row, Width, Place);
		}
		return bNumbers;
	}

	const FTapSum& Sum;
	const FSourcePlan& Plan;
	const FLinePlan& Lines;
	const FTapSource& Source;
	const FKernelTexture& Target;
	const FKernelTile& Tile;
	const int32_t TexelFloats;
	const int32_t LineFloats;
	bool bInPlace = false;
	float* Strips = nullptr;
	int32_t* StripRows = nullptr;
	float* Mixed = nullptr;
	int32_t MixedPlace = NoRow;
	float* LineTexels = nullptr;
	float* DriftingWeights = nullptr; // of the lines of columns, a LineFloats apart
	float* Sums = nullptr;
	/** The line that a slot of LineTexels holds, and the last row of the tile that used it. */
	struct FLine
	{
		int32_t Columns = -1;
		int32_t Place = 0;
		int32_t Row = -1;
	};
	FLine Kept[GMostLineTaps];
	alignas(64) float Weights[GMostLineTaps][N];
	bool bWeightless = true;
	const bool bFactor = Sum.Factor != 1.0f;
	const bool bFromZero = Source.bFromZero;
	const bool bNoNegatives = Sum.bNoNegatives;
};

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
