// Cuts a tile into stretches of columns whose taps are lines of samples (TapLines.inl). Included by TapSumLanes.inl
// only.
#pragma once

#include "Native/TapLines.inl"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Stores the tile's sums; false, with anything stored, where it does not know them. */
template<int N>
inline bool SumTapLines(const FTapSum& Sum, const FSourcePlan& Plan, const FKernelTexture& Target,
	const FKernelTile& Tile, int32_t ToTargetX, int32_t ToTargetY)
{
	// All that a row of pixels reads and keeps stays in the first cache.
	constexpr int32_t MostTexels = 256;
	const int32_t Width = Tile.MaxX - Tile.MinX;
	const int32_t Chunk = Plan.Step == 512 || Plan.Step == 0 ? MostTexels / 2 : Width;
	const auto GetEnd = [&](int32_t First)
	{
		const int32_t Most = Width - First < Chunk ? Width - First : Chunk;
		return First + (Plan.Step == 0 ? CountDrifting(Plan, First, Most) : Most);
	};
	if (Plan.Step == 0)
	{
		// A stretch costs what its first rows cost.
		constexpr int32_t MostShort = 4;
		int32_t NumStretches = 0;
		for (int32_t First = 0; First < Width; First = GetEnd(First))
		{
			if (++NumStretches > Width / Chunk + MostShort)
			{
				return false;
			}
		}
	}
	bool bDone = true;
	for (int32_t First = 0; First < Width && bDone; First = GetEnd(First))
	{
		FKernelTile Columns = Tile;
		Columns.MinX = Tile.MinX + First;
		Columns.MaxX = Tile.MinX + GetEnd(First);
		FLinePlan Lines;
		bDone = PlanLines(Plan, First, Columns.MaxX - Columns.MinX, Lines);
		VisitStripChannels(GetStripChannels(Target.Storage), [&](auto Channels)
			{ bDone = bDone && TTapLines<N, Channels>(Sum, Plan, Lines, Target, Columns).Run(ToTargetX, ToTargetY); });
	}
	return bDone;
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
