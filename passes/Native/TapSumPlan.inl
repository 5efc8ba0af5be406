// Finds the places of a sum's taps for the pixels of a tile: in step with them along a row, or each pixel by itself.
// Included by TapSumLanes.inl only.
#pragma once

#include "LanesSamplingGeneral.inl"
#include "Native/TapSum.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** The thread's memories, by their contents. */
enum ETapMemory : int32_t
{
	PlacesMemory,
	TapPlansMemory,
	TexelRowsMemory,
	MixedRowsMemory,
	ResampledMemory,
	TapRowsMemory,
	SumsMemory,
	FlagsMemory,
	TableMemory,
	TexelRowsMemories, // and the next two: of what is open besides the first rows
	FlagsMemories = TexelRowsMemories + 2,
	ColumnsMemory = FlagsMemories + 2,
	ColorTableMemory, // kept from tile to tile
};

/** The texel below a place and the weight of the next one. */
DRYDOCK_LANES_INLINE int32_t TexelBelow(int32_t Place)
{
	return (Place - 128) >> 8;
}
DRYDOCK_LANES_INLINE float WeightOfNext(int32_t Place)
{
	return float((Place - 128) & 255) * (1.0f / 256);
}

/** One tap of a tile. Places are positions in the texture in 1/256 texels. */
struct FTapPlan
{
	int32_t First; // place of the first pixel, beyond the rect where that lies outside
	int32_t Step;  // places from pixel to pixel; 0: by Columns alone
	int32_t Begin; // pixels before it and from End on are held at the edge texel
	int32_t End;
	const int32_t* Columns; // places of the tile's columns as the sampler gets them
	const int32_t* Rows;    // of its rows
	int32_t FirstRow;       // place of the first row, beyond the rect where that lies outside
	bool bRowsInStep;       // each row lies a texel further, held at the edge texels
};

struct FSourcePlan
{
	const FTapSource* Source;
	FTapPlan* Taps;
	int32_t Step; // of all taps
	int32_t FirstRow;
	int32_t NumRows;
	int32_t LiveRows;       // that one row of pixels reads, the ones between included
	bool bInBlocks = false; // rows of pixels are summed together (TapSumColumns.inl)
};

DRYDOCK_LANES_INLINE int32_t RoundUpTo(int32_t X, int32_t Multiple)
{
	return (X + Multiple - 1) / Multiple * Multiple;
}

/** Places of Count pixels from First on: Wanted as the sampler gets them, Free as if nothing held them in the rect.
 *  Writes whole packs. False where one is out of an integer's reach. */
template<int N>
inline bool FindPlaces(const FTapAxis& Axis, int32_t First, int32_t Count, int32_t Size, int32_t* Wanted, int32_t* Free)
{
	using FLanes = TReal<float, N>;
	using FInt = TRaw<int32_t, N>;
	using FOps = TLaneOps<N>;
	constexpr int32_t Far = 1 << 29;
	const FLanes ToPlace(float(Size) * 256.0f);
	FInt Outside = {};
	for (int32_t i = 0; i < Count; i += N)
	{
		const FLanes Pixel = ToReal<float>(TInt<N>(First + i) + LaneIndex<N>());
		FLanes V = (Pixel + FLanes(0.5f) - FLanes(Axis.Origin)) * FLanes(Axis.Scale) * FLanes(Axis.Extent) +
				   FLanes(Axis.First);
		FInt Place;
		if (Axis.Steps != 0)
		{
			V = Floor(V * FLanes(Axis.Steps) + FLanes(0.5f)) / FLanes(Axis.Steps);
			Place = FOps::FloorToInt(((V + FLanes(Axis.Second)) * FLanes(256.0f)).V); // exact
		}
		else
		{
			Place = FOps::FloorToInt(((V + FLanes(Axis.Second)) * FLanes(Axis.ToUV) * ToPlace + FLanes(0.5f)).V);
		}
		const FLanes Inside = Min(Max(V, FLanes(Axis.Min)), FLanes(Axis.Max));
		const FLanes UV = (Inside + FLanes(Axis.Second)) * FLanes(Axis.ToUV);
		const FLanes Held = Min(Max(UV, FLanes(Axis.MinUV)), FLanes(Axis.MaxUV));
		const FInt HeldPlace = FOps::FloorToInt((Held * ToPlace + FLanes(0.5f)).V);
		Outside |= (Place > Far) | (Place < -Far) | (HeldPlace > Far) | (HeldPlace < -Far);
		StoreRaw(Free + i, Place);
		StoreRaw(Wanted + i, HeldPlace);
	}
	return !AnyLane(TMask<N>(Outside));
}

/** The edge texels' centres on one axis. */
struct FEdges
{
	int32_t Low;
	int32_t High;
};

DRYDOCK_LANES_INLINE FEdges GetEdges(const FTapSource& Source, int Axis)
{
	return {Source.RectMin[Axis] * 256 + 128, Source.RectMax[Axis] * 256 - 128};
}

/** The free places move in step with the pixels, and the wanted ones are those, held between the edges. */
template<int N>
inline bool MovesInStep(
	const int32_t* Wanted, const int32_t* Free, int32_t Count, int32_t Step, bool bHeld, FEdges Edges)
{
	using FInt = TRaw<int32_t, N>;
	FInt Wrong = {};
	for (int32_t i = 0; i < Count; i += N)
	{
		const FInt Lane = LaneIndex<N>().V + i;
		const FInt Place = LoadRaw<FInt>(Free + i);
		const TInt<N> Held = Max(Min(TInt<N>(Place), TInt<N>(Edges.High)), TInt<N>(Edges.Low));
		const FInt Expected = bHeld ? Held.V : Place;
		Wrong |= ((Place != Free[0] + Lane * Step) | (LoadRaw<FInt>(Wanted + i) != Expected)) & (Lane < Count);
	}
	return !AnyLane(TMask<N>(Wrong));
}

template<int N>
inline bool PlanColumns(const FTapSource& Source, const FTapAxis& Axis, const FKernelTile& Tile, int32_t* Wanted,
	int32_t* Free, FTapPlan& Out)
{
	const int32_t Count = Tile.MaxX - Tile.MinX;
	const FEdges Edges = GetEdges(Source, 0);
	if (!FindPlaces<N>(Axis, Tile.MinX, Count, Source.Texture->Mips[0].SizeX, Wanted, Free))
	{
		return false;
	}
	const int32_t Step = Count > 1 ? Free[1] - Free[0] : 256;
	const bool bHeld = Source.Beyond != EBeyondRect::Sampler;
	const bool bInStep =
		(Step == 128 || Step == 256 || Step == 512) && MovesInStep<N>(Wanted, Free, Count, Step, bHeld, Edges);
	Out.First = Free[0];
	Out.Step = bInStep ? Step : 0;
	Out.Columns = Wanted;
	Out.Begin = 0;
	Out.End = Count;
	if (Source.Beyond == EBeyondRect::Clamp)
	{
		while (Out.Begin < Count && Free[Out.Begin] < Edges.Low)
		{
			++Out.Begin;
		}
		while (Out.End > Out.Begin && Free[Out.End - 1] > Edges.High)
		{
			--Out.End;
		}
	}
	return true;
}

template<int N>
inline bool PlanRows(const FTapSource& Source, const FTapAxis& Axis, const FKernelTile& Tile, int32_t* Wanted,
	int32_t* Free, FTapPlan& Out)
{
	const int32_t Count = Tile.MaxY - Tile.MinY;
	const FEdges Edges = GetEdges(Source, 1);
	if (!FindPlaces<N>(Axis, Tile.MinY, Count, Source.Texture->Mips[0].SizeY, Wanted, Free))
	{
		return false;
	}
	Out.Rows = Wanted;
	Out.FirstRow = Free[0];
	Out.bRowsInStep = MovesInStep<N>(Wanted, Free, Count, 256, Source.Beyond != EBeyondRect::Sampler, Edges);
	if (Source.Beyond == EBeyondRect::Black)
	{
		Out.Rows = Free;
		for (int32_t i = 0; i < Count; ++i)
		{
			const int32_t Held = Free[i] < Edges.Low ? Edges.Low : Free[i] > Edges.High ? Edges.High : Free[i];
			if (Wanted[i] != Held)
			{
				return false;
			}
		}
	}
	return true;
}

/** The rows that a row of pixels reads: the most of any, the ones between included. */
inline int32_t CountLiveRows(const FTapPlan* Taps, int32_t NumTaps, int32_t Height)
{
	int32_t Live = 0;
	for (int32_t Row = 0; Row < Height; ++Row)
	{
		int32_t Lowest = 1 << 30;
		int32_t Highest = -(1 << 30);
		for (int32_t Index = 0; Index < NumTaps; ++Index)
		{
			const int32_t Below = TexelBelow(Taps[Index].Rows[Row]);
			Lowest = Below < Lowest ? Below : Lowest;
			Highest = Below > Highest ? Below : Highest;
		}
		Live = Highest + 2 - Lowest > Live ? Highest + 2 - Lowest : Live;
	}
	return Live;
}

/** Ints: 2 * (width + height) for each tap, whole packs. False where the shader has to do it. */
template<int N>
inline bool PlanSource(
	const FTapSource& Source, const FKernelTile& Tile, int32_t* Ints, FTapPlan* Taps, FSourcePlan& Out)
{
	// Taps share few axes: those of a blur's direction are all different, those across it all the same.
	constexpr int32_t LookBack = 8;
	const int32_t PaddedX = RoundUpTo(Tile.MaxX - Tile.MinX, N);
	const int32_t PaddedY = RoundUpTo(Tile.MaxY - Tile.MinY, N);
	int32_t Lowest = 1 << 30;
	int32_t Highest = -(1 << 30);
	for (int32_t Index = 0; Index < Source.NumTaps; ++Index)
	{
		const FTap& Tap = Source.Taps[Index];
		FTapPlan& Plan = Taps[Index];
		const FTapPlan* LikeX = nullptr;
		const FTapPlan* LikeY = nullptr;
		for (int32_t Other = Index - 1; Other >= 0 && Other >= Index - LookBack; --Other)
		{
			LikeX = !LikeX && !__builtin_memcmp(&Source.Taps[Other].X, &Tap.X, sizeof(FTapAxis)) ? Taps + Other : LikeX;
			LikeY = !LikeY && !__builtin_memcmp(&Source.Taps[Other].Y, &Tap.Y, sizeof(FTapAxis)) ? Taps + Other : LikeY;
		}
		if (LikeX)
		{
			Plan = *LikeX;
		}
		else if (!PlanColumns<N>(Source, Tap.X, Tile, Ints, Ints + PaddedX, Plan))
		{
			return false;
		}
		Ints += 2 * PaddedX;
		if (LikeY)
		{
			Plan.Rows = LikeY->Rows;
			Plan.FirstRow = LikeY->FirstRow;
			Plan.bRowsInStep = LikeY->bRowsInStep;
		}
		else if (!PlanRows<N>(Source, Tap.Y, Tile, Ints, Ints + PaddedY, Plan))
		{
			return false;
		}
		Ints += 2 * PaddedY;
		for (int32_t Row = 0; Row < Tile.MaxY - Tile.MinY; ++Row)
		{
			const int32_t Below = TexelBelow(Plan.Rows[Row]);
			Lowest = Below < Lowest ? Below : Lowest;
			Highest = Below > Highest ? Below : Highest;
		}
	}
	const int32_t LiveRows = CountLiveRows(Taps, Source.NumTaps, Tile.MaxY - Tile.MinY);
	Out = {&Source, Taps, Taps[0].Step, Lowest, Highest + 2 - Lowest, LiveRows};
	for (int32_t Index = 0; Index < Source.NumTaps; ++Index)
	{
		Out.Step = Taps[Index].Step == Out.Step ? Out.Step : 0;
	}
	constexpr int32_t MostRows = 4096;
	return Out.NumRows <= MostRows && (Out.Step != 0 || Source.Beyond != EBeyondRect::Black);
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
