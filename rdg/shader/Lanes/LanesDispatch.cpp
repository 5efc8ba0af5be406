// Tells which lane widths there are: those that this build has code for and this CPU runs.
#include "LanesDispatch.h"

#include "CpuLanes.h"
#include "Diagnostics.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

// DRYDOCK_BUILT_LANES: 4, 8, 16, or with DRYDOCK_INSTRUCTION_SETS=native those of the CPU that built.
constexpr int32_t BuiltLanes[] = {DRYDOCK_BUILT_LANES};

} // namespace

int32_t GetWidestLanes(bool bDouble)
{
	int32_t FloatLanes = 4;
	for (const int32_t Lanes : BuiltLanes)
	{
		FloatLanes = Lanes <= GetCpuLanes() ? std::max(FloatLanes, Lanes) : FloatLanes;
	}
	return bDouble ? FloatLanes / 2 : FloatLanes;
}

bool AreLanesSupported(bool bDouble, int32_t Lanes)
{
	const int32_t FloatLanes = bDouble ? 2 * Lanes : Lanes;
	return FloatLanes <= GetCpuLanes() &&
		   std::find(std::begin(BuiltLanes), std::end(BuiltLanes), FloatLanes) != std::end(BuiltLanes);
}

std::string GetBuiltLanes()
{
	return JoinText(BuiltLanes, ", ", [](int32_t Lanes) { return std::to_string(Lanes); });
}

FLaneConfig ResolveLanes(FLaneConfig Lanes)
{
	if (Lanes.Lanes == 0)
	{
		Lanes.Lanes = GetWidestLanes(Lanes.bDouble);
	}
	if (!AreLanesSupported(Lanes.bDouble, Lanes.Lanes))
	{
		throw FError(
			{ESeverity::Error, 6003,
				"shaders cannot run with " + std::to_string(Lanes.Lanes) + (Lanes.bDouble ? " double" : " float") +
					" lanes here; this CPU has up to " + std::to_string(GetCpuLanes() / (Lanes.bDouble ? 2 : 1)) +
					", and this build has code for " + GetBuiltLanes() + " float lanes (DRYDOCK_INSTRUCTION_SETS)",
				{}, 0, 0, {}},
			ExitUsage);
	}
	if (Lanes.WaveSize < 4 || Lanes.WaveSize > 64 || (Lanes.WaveSize & (Lanes.WaveSize - 1)))
	{
		throw FError({ESeverity::Error, 6003,
						 "waves cannot have " + std::to_string(Lanes.WaveSize) +
							 " threads (r.Drydock.WaveSize); they have 4, 8, 16, 32 or 64",
						 {}, 0, 0, {}},
			ExitUsage);
	}
	return Lanes;
}

} // namespace Drydock
