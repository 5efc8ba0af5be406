// Tells which lane widths there are: those that this build has code for and this CPU runs.
#include "LanesDispatch.h"

#include "CpuLanes.h"

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
	std::string Text;
	for (const int32_t Lanes : BuiltLanes)
	{
		Text += (Text.empty() ? "" : ", ") + std::to_string(Lanes);
	}
	return Text;
}

} // namespace Drydock
