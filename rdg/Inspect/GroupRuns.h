// Threads of groups, run once more one by one: each group is run as a whole first, and what its threads saw of each
// other is kept.
#pragma once

#include "InspectedShader.h"
#include "SpirvGroup.h"

#include <array>

namespace Drydock
{

/** Index of each thread of one group in a list of them, and the group's SV_GroupID. */
struct FGroupOfThreads
{
	std::array<int32_t, 3> GroupId = {};
	std::vector<size_t> Threads;
};

/** By z, y and x. */
DRYDOCK_API std::vector<FGroupOfThreads> SortByGroups(
	const FInspectedShader& Shader, const std::vector<std::array<int32_t, 3>>& Threads);

/** Runs groups and hands out their threads. */
template<typename Real>
class TGroupRuns
{
public:
	explicit TGroupRuns(const FInspectedShader& InShader)
		: Shader(InShader)
		, Group(Shader.GetProgram(), Shader.GetOrder(), Shader.GetSlots(), Shader.GetWaveSize())
	{
	}

	void SetRaceFinder(FRaceFinder* Races) { Group.SetRaceFinder(Races); }

	/** What the group's stores do is done. */
	void Run(const FKernelArgs& Args, const std::array<int32_t, 3>& GroupId, uint64_t MaxSteps)
	{
		const int32_t Id[3] = {GroupId[0], GroupId[1], GroupId[2]};
		Logs = Group.Record(Args, Id, MaxSteps);
	}

	/** Thread, when it is run now, sees what the thread at that place saw in the group that ran last; it stores
	 * nothing. */
	void Prepare(TSpirvThread<Real>& Thread, const std::array<int32_t, 3>& Position)
	{
		const uint32_t* const Size = Shader.GetModule().LocalSize;
		const auto Local = [&](int Axis)
		{
			return uint32_t(Position[size_t(Axis)]) % Size[Axis];
		};
		const uint32_t Index = (Local(2) * Size[1] + Local(1)) * Size[0] + Local(0);
		Thread.SetPlace(Index, Shader.GetWaveSize());
		Thread.SetLog(&Logs[Index], true);
	}

private:
	const FInspectedShader& Shader;
	TSpirvGroup<Real> Group;
	std::vector<typename TSpirvGroup<Real>::FLog> Logs;
};

} // namespace Drydock
