// Asks the CPU which lane widths it runs.
#include "LanesDispatch.h"

namespace Drydock
{

int32_t GetWidestLanes(bool bDouble)
{
	int32_t FloatLanes = 4;
	if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
		__builtin_cpu_supports("avx512vl"))
	{
		FloatLanes = 16;
	}
	else if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
	{
		FloatLanes = 8;
	}
	return bDouble ? FloatLanes / 2 : FloatLanes;
}

bool AreLanesSupported(bool bDouble, int32_t Lanes)
{
	const int32_t FloatLanes = bDouble ? 2 * Lanes : Lanes;
	return (FloatLanes == 4 || FloatLanes == 8 || FloatLanes == 16) && Lanes <= GetWidestLanes(bDouble);
}

} // namespace Drydock
