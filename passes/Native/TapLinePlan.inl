// Which taps of a sum are the same line of samples, shifted by whole pixels, and what texels the lines read. Included
// by TapLines.inl only.
#pragma once

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
	/** Not null: the places, whose texels are in step while their weights are not: a picture of odd size is halved. */
	const int32_t* Drifting;
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
	int32_t Step = 0; // places from position to position
	int32_t NumPositions = 0;
	int32_t FirstTexel = 0;
	int32_t NumTexels = 0;
};

constexpr int32_t GDriftingStep = 512;

/** How many pixels from First on, at most Most, have texels in step for every tap, whatever their weights; not of a
 * source whose places are in step. */
inline int32_t CountDrifting(const FSourcePlan& Source, int32_t First, int32_t Most)
{
	int32_t Count = Most;
	for (int32_t Index = 0; Index < Source.Source->NumTaps; ++Index)
	{
		const int32_t* const Places = Source.Taps[Index].Columns + First;
		const int32_t Begin = TexelBelow(Places[0]);
		int32_t Pixel = 1;
		while (Pixel < Count && TexelBelow(Places[Pixel]) == Begin + GDriftingStep / 256 * Pixel)
		{
			++Pixel;
		}
		Count = Pixel;
	}
	return Count;
}

/** The same for drifting taps: each axis is a line of its own. */
inline bool PlanDriftingLines(const FSourcePlan& Source, int32_t First, int32_t Width, FLinePlan& Out)
{
	Out.Step = GDriftingStep;
	Out.NumPositions = Width;
	int32_t Last = -(1 << 30);
	Out.FirstTexel = 1 << 30;
	for (int32_t Index = 0; Index < Source.Source->NumTaps; ++Index)
	{
		const int32_t* const Places = Source.Taps[Index].Columns + First;
		int32_t Known = 0;
		while (Known < Out.NumColumns && Out.Columns[Known].Drifting != Places)
		{
			++Known;
		}
		if (Known == Out.NumColumns)
		{
			Out.Columns[Out.NumColumns++] = {Places[0], 0, Width, Places};
		}
		Out.Taps[Index] = {Known, 0};
		const int32_t Lowest = TexelBelow(Places[0]);
		const int32_t End = TexelBelow(Places[Width - 1]) + 1;
		Out.FirstTexel = Lowest < Out.FirstTexel ? Lowest : Out.FirstTexel;
		Last = End > Last ? End : Last;
	}
	Out.NumTexels = Last + 1 - Out.FirstTexel;
	return true;
}

/** For Width pixels of the tile from column First on. False where lines do not stand for the taps. */
inline bool PlanLines(const FSourcePlan& Source, int32_t First, int32_t Width, FLinePlan& Out)
{
	const FTapSource& Taps = *Source.Source;
	if (Taps.NumTaps > GMostLineTaps || Taps.Beyond != EBeyondRect::Clamp)
	{
		return false;
	}
	if (Source.Step == 0)
	{
		return PlanDriftingLines(Source, First, Width, Out);
	}
	const int32_t Step = Source.Step;
	Out.Step = Step;
	int32_t MostShift = 0;
	for (int32_t Index = 0; Index < Taps.NumTaps; ++Index)
	{
		const int32_t Place = Source.Taps[Index].First + Step * First;
		int32_t Known = 0;
		while (Known < Out.NumColumns && (Place - Out.Columns[Known].Place) % Step != 0)
		{
			++Known;
		}
		if (Known == Out.NumColumns)
		{
			Out.Columns[Out.NumColumns++] = {Place, 0, 0, nullptr};
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
		Tap.Shift = (Source.Taps[Index].First + Step * First - Out.Columns[Tap.Columns].Place) / Step;
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
		const int32_t Lowest = TexelBelow(Columns.Place);
		const int32_t End = TexelBelow(Columns.Place + Step * (Out.NumPositions - 1)) + 1;
		Out.FirstTexel = Lowest < Out.FirstTexel ? Lowest : Out.FirstTexel;
		Last = End > Last ? End : Last;
	}
	Out.NumTexels = Last + 1 - Out.FirstTexel;
	return MostShift <= WidestShift;
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
