// Asks the CPU for its widest float lanes. The build asks the same, to compile for this CPU alone.
#pragma once

namespace Drydock
{

/** 16 with AVX-512, 8 with AVX2, else 4. */
inline int GetCpuLanes()
{
	if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
		__builtin_cpu_supports("avx512vl"))
	{
		return 16;
	}
	return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? 8 : 4;
}

} // namespace Drydock
