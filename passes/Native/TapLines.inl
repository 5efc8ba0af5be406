// Few bilinear taps whose samples neighbouring pixels share: each sample is mixed once, into a line of samples one to a
// pixel, and a tap is that line, shifted by whole pixels. Dual Kawase, the pyramid, halving. Included by
// TapSumLanes.inl only.
#pragma once

#include "Native/StripStores.inl"
#include "Native/TapSumPlan.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Samples of a row at Place + Step * p for the positions p of a line. */
struct FLineColumns
{
	int32_t Place;
	int32_t Begin; // positions before it and from End on are held at the edge texel
	int32_t End;
};

/** A tap: the line of its columns at its row, Shift positions further on. */
struct FLineTap
{
	int32_t Columns;
	int32_t Shift;
};

constexpr int32_t GMostLineTaps = 8;

/** How the taps of a source become lines. */
struct FLinePlan
{
	FLineColumns Columns[GMostLineTaps];
	int32_t NumColumns = 0;
	FLineTap Taps[GMostLineTaps];
	int32_t NumPositions = 0;
	int32_t FirstTexel = 0;
	int32_t NumTexels = 0;
};

/** False where lines do not stand for the taps. */
inline bool PlanLines(const FSourcePlan& Source, int32_t Width, FLinePlan& Out)
{
	const FTapSource& Taps = *Source.Source;
	if (Taps.NumTaps > GMostLineTaps || Taps.Beyond != EBeyondRect::Clamp || Source.Step == 0)
	{
		return false;
	}
	const int32_t Step = Source.Step;
	int32_t MostShift = 0;
	for (int32_t Index = 0; Index < Taps.NumTaps; ++Index)
	{
		const int32_t Place = Source.Taps[Index].First;
		int32_t Known = 0;
		while (Known < Out.NumColumns && (Place - Out.Columns[Known].Place) % Step != 0)
		{
			++Known;
		}
		if (Known == Out.NumColumns)
		{
			Out.Columns[Out.NumColumns++] = {Place, 0, 0};
		}
		else if (Place < Out.Columns[Known].Place)
		{
			Out.Columns[Known].Place = Place;
		}
		Out.Taps[Index].Columns = Known;
	}
	for (int32_t Index = 0; Index < Taps.NumTaps; ++Index)
	{
		FLineTap& Tap = Out.Taps[Index];
		Tap.Shift = (Source.Taps[Index].First - Out.Columns[Tap.Columns].Place) / Step;
		MostShift = Tap.Shift > MostShift ? Tap.Shift : MostShift;
	}
	constexpr int32_t WidestShift = 64;
	Out.NumPositions = Width + MostShift;
	const FEdges Edges = GetEdges(Taps, 0);
	int32_t Last = -(1 << 30);
	Out.FirstTexel = 1 << 30;
	for (int32_t Index = 0; Index < Out.NumColumns; ++Index)
	{
		FLineColumns& Columns = Out.Columns[Index];
		Columns.End = Out.NumPositions;
		while (Columns.Begin < Columns.End && Columns.Place + Step * Columns.Begin < Edges.Low)
		{
			++Columns.Begin;
		}
		while (Columns.End > Columns.Begin && Columns.Place + Step * (Columns.End - 1) > Edges.High)
		{
			--Columns.End;
		}
		const int32_t First = TexelBelow(Columns.Place);
		const int32_t End = TexelBelow(Columns.Place + Step * (Out.NumPositions - 1)) + 1;
		Out.FirstTexel = First < Out.FirstTexel ? First : Out.FirstTexel;
		Last = End > Last ? End : Last;
	}
	Out.NumTexels = Last + 1 - Out.FirstTexel;
	return MostShift <= WidestShift;
}

/** Every second texel of A and B side by side, from First, 0 or 1, on. */
template<int N, int C>
DRYDOCK_LANES_INLINE TRaw<float, N> PickTexels(TRaw<float, N> A, TRaw<float, N> B, int32_t First)
{
	const TRaw<int32_t, N> Lane = LaneIndex<N>().V;
	return __builtin_shuffle(A, B, (Lane / C * 2 + First) * C + Lane % C);
}

/** Texels of A and B in turn: the first N lanes of them, or the next. */
template<int N, int C>
DRYDOCK_LANES_INLINE TRaw<float, N> AlternateTexels(TRaw<float, N> A, TRaw<float, N> B, int32_t Part)
{
	const TRaw<int32_t, N> Lane = LaneIndex<N>().V;
	const TRaw<int32_t, N> Texel = (Lane + Part * N) / C;
	return __builtin_shuffle(A, B, (Texel & 1) * N + (Texel >> 1) * C + Lane % C);
}

/** The sums of a tile of one source whose taps are lines. C: floats of a texel. */
template<int N, int C>
class TTapLines
{
	using FFloat = TRaw<float, N>;

	/** Lines that are kept, and how far back one is looked for: a line found stays until its row of pixels is done. */
	static constexpr int32_t NumLines = 2 * GMostLineTaps;
	static constexpr int32_t LookBack = GMostLineTaps;
	/** What whole vectors read and write beyond a row. */
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
			GetTapMemory(ResampledMemory, size_t(NumLines + 1) * size_t(LineFloats) * sizeof(float)));
		Sums = LineTexels + size_t(NumLines) * size_t(LineFloats);
		for (int32_t Index = 0; Index < Source.NumTaps; ++Index)
		{
			bWeightless[Index] = true;
			for (int32_t Lane = 0; Lane < N; ++Lane)
			{
				Weights[Index][Lane] = Source.Taps[Index].Weight[Lane % C];
				// A product with 1 is left out, for it would make a tiny number 0.
				bWeightless[Index] = bWeightless[Index] && Weights[Index][Lane] == 1.0f;
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
		for (int32_t Row = 0; Row < Tile.MaxY - Tile.MinY; ++Row)
		{
			const float* Taps[GMostLineTaps];
			for (int32_t Index = 0; Index < Source.NumTaps; ++Index)
			{
				const FLineTap& Tap = Lines.Taps[Index];
				Taps[Index] = GetLine(Tap.Columns, Plan.Taps[Index].Rows[Row]) + Tap.Shift * C;
			}
			if (!SumLines(Taps, Width * C))
			{
				return false;
			}
			StoreStrip<N, C>(Target, Sums, Tile.MinX + ToTargetX, Tile.MinY + Row + ToTargetY, Width);
		}
		return true;
	}

private:
	static DRYDOCK_LANES_INLINE FFloat Mix(FFloat A, FFloat B, FFloat Weight) { return A + Weight * (B - A); }

	/** Texels of a row, of the rect, from the first one on. */
	const float* GetRow(int32_t Row)
	{
		const FKernelMip& Mip = Source.Texture->Mips[0];
		const ETexelStorage Storage = Source.Texture->Storage;
		const int32_t Bytes = GetTexelStorageInfo(Storage).BytesPerTexel;
		const int32_t Last = Source.RectMax[1] - 1;
		const int32_t Y = Row < Source.RectMin[1] ? Source.RectMin[1] : Row > Last ? Last : Row;
		const uint8_t* const Texels = Mip.Data + int64_t(Y) * Mip.RowPitch;
		constexpr int32_t Ahead = 2;
		const int32_t Slot = (Y - Source.RectMin[1]) % Plan.LiveRows;
		float* const Strip = Strips + size_t(Slot) * size_t(TexelFloats);
		if (StripRows[Slot] != Y)
		{
			StripRows[Slot] = Y;
			PrefetchTexels(Mip, Bytes, Y + Ahead < Last ? Y + Ahead : Last, Lines.FirstTexel, Lines.NumTexels);
			if (!bInPlace)
			{
				DecodeHeldStrip<N, C>(
					Storage, Texels, Source.RectMin[0], Source.RectMax[0], Lines.FirstTexel, Lines.NumTexels, Strip);
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
			for (int32_t i = 0; i < Lines.NumTexels * C; i += N)
			{
				StoreRaw(Mixed + i, Mix(LoadRaw<FFloat>(A + i), LoadRaw<FFloat>(B + i), Weight));
			}
		}
		return Mixed;
	}

	const float* GetLine(int32_t Columns, int32_t Place)
	{
		for (int32_t Index = LinesMade - 1; Index >= 0 && Index >= LinesMade - LookBack; --Index)
		{
			const int32_t Slot = Index % NumLines;
			if (LinePlaces[Slot] == Place && LineColumns[Slot] == Columns)
			{
				return LineTexels + size_t(Slot) * size_t(LineFloats);
			}
		}
		const int32_t Slot = LinesMade++ % NumLines;
		LinePlaces[Slot] = Place;
		LineColumns[Slot] = Columns;
		float* const Line = LineTexels + size_t(Slot) * size_t(LineFloats);
		MakeLine(Lines.Columns[Columns], MixRows(Place), Line);
		return Line;
	}

	/** Row: texels from the first one on. */
	void MakeLine(const FLineColumns& Columns, const float* Row, float* Line) const
	{
		const float* const Texels = Row + (TexelBelow(Columns.Place) - Lines.FirstTexel) * C;
		const float Weight = WeightOfNext(Columns.Place);
		if (Plan.Step == 512)
		{
			Weight == 0 ? HalveTexels<false>(Texels, Weight, Line) : HalveTexels<true>(Texels, Weight, Line);
		}
		else if (Plan.Step == 256)
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
			const int32_t Texel = TexelBelow(Columns.Place + Plan.Step * i) - Lines.FirstTexel;
			__builtin_memcpy(Line + i * C, Row + Texel * C, C * sizeof(float));
		}
	}

	template<bool bMixed>
	DRYDOCK_LANES_INLINE void HalveTexels(const float* Texels, float Weight, float* Line) const
	{
		const FFloat Weights = Broadcast<float, N>(Weight);
		for (int32_t i = 0; i < Lines.NumPositions * C; i += N)
		{
			const FFloat Low = LoadRaw<FFloat>(Texels + 2 * i);
			const FFloat High = LoadRaw<FFloat>(Texels + 2 * i + N);
			FFloat Value = PickTexels<N, C>(Low, High, 0);
			if constexpr (bMixed)
			{
				Value = Mix(Value, PickTexels<N, C>(Low, High, 1), Weights);
			}
			StoreRaw(Line + i, Value);
		}
	}

	template<bool bMixed>
	DRYDOCK_LANES_INLINE void MoveTexels(const float* Texels, float Weight, float* Line) const
	{
		const FFloat Weights = Broadcast<float, N>(Weight);
		for (int32_t i = 0; i < Lines.NumPositions * C; i += N)
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
		const int32_t Odd = Place + Plan.Step;
		const float* const EvenTexels = Row + (TexelBelow(Place) - Lines.FirstTexel) * C;
		const float* const OddTexels = Row + (TexelBelow(Odd) - Lines.FirstTexel) * C;
		const FFloat EvenWeight = Broadcast<float, N>(WeightOfNext(Place));
		const FFloat OddWeight = Broadcast<float, N>(WeightOfNext(Odd));
		const bool bEvenAlone = WeightOfNext(Place) == 0;
		const bool bOddAlone = WeightOfNext(Odd) == 0;
		for (int32_t i = 0; i < Lines.NumPositions * C; i += 2 * N)
		{
			FFloat A = LoadRaw<FFloat>(EvenTexels + i / 2);
			FFloat B = LoadRaw<FFloat>(OddTexels + i / 2);
			A = bEvenAlone ? A : Mix(A, LoadRaw<FFloat>(EvenTexels + i / 2 + C), EvenWeight);
			B = bOddAlone ? B : Mix(B, LoadRaw<FFloat>(OddTexels + i / 2 + C), OddWeight);
			StoreRaw(Line + i, AlternateTexels<N, C>(A, B, 0));
			StoreRaw(Line + i + N, AlternateTexels<N, C>(A, B, 1));
		}
	}

	/** Count floats; false when one is NaN. */
	bool SumLines(const float* const* Taps, int32_t Count)
	{
		const TRaw<int32_t, N> Lane = LaneIndex<N>().V;
		const FFloat Factor = Broadcast<float, N>(Sum.Factor);
		bool bNan = false;
		for (int32_t i = 0; i < Count; i += Group * N)
		{
			FFloat Values[Group] = {};
			for (int32_t Index = 0; Index < Source.NumTaps; ++Index)
			{
				const float* const Texels = Taps[Index] + i;
				const FFloat Weight = LoadRaw<FFloat>(Weights[Index]);
				const bool bAlone = bWeightless[Index];
#pragma GCC unroll 4
				for (int v = 0; v < Group; ++v)
				{
					FFloat Value = LoadRaw<FFloat>(Texels + v * N);
					Value = bAlone ? Value : Value * Weight;
					Values[v] = Index == 0 ? (Source.bFromZero ? Value + 0.0f : Value) : Values[v] + Value;
				}
			}
#pragma GCC unroll 4
			for (int v = 0; v < Group; ++v)
			{
				const TRaw<int32_t, N> Inside = Lane + (i + v * N) < Count;
				bNan |= AnyLane(TMask<N>((Values[v] != Values[v]) & Inside));
				FFloat Value = Sum.Factor == 1.0f ? Values[v] : Values[v] * Factor;
				if (Sum.bNoNegatives)
				{
					const FFloat Held = Max(TReal<float, N>(Value), TReal<float, N>(0.0f)).V;
					Value = Lane % C == 3 ? Value : Held;
				}
				StoreRaw(Sums + i + v * N, Value);
			}
		}
		return !bNan;
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
	float* Sums = nullptr;
	int32_t LinePlaces[NumLines] = {};
	int32_t LineColumns[NumLines] = {};
	int32_t LinesMade = 0;
	alignas(64) float Weights[GMostLineTaps][N];
	bool bWeightless[GMostLineTaps];
};

/** Stores the tile's sums; false, with anything stored, where it does not know them. */
template<int N>
inline bool SumTapLines(const FTapSum& Sum, const FSourcePlan& Plan, const FKernelTexture& Target,
	const FKernelTile& Tile, int32_t ToTargetX, int32_t ToTargetY)
{
	FLinePlan Lines;
	if (!PlanLines(Plan, Tile.MaxX - Tile.MinX, Lines))
	{
		return false;
	}
	bool bDone = false;
	VisitStripChannels(GetStripChannels(Target.Storage),
		[&](auto Channels)
		{
			TTapLines<N, Channels> TapLines(Sum, Plan, Lines, Target, Tile);
			bDone = TapLines.Run(ToTargetX, ToTargetY);
		});
	return bDone;
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
