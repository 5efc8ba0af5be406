// Runs threads of groups, and pixels of quads, once more one by one. Each group is run as a whole first, and the values
// that its threads read from each other are kept.
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

/** Sorts threads by their groups: by z, y and x. */
DRYDOCK_API std::vector<FGroupOfThreads> SortByGroups(
	const FInspectedShader& Shader, const std::vector<std::array<int32_t, 3>>& Threads);

/** SV_GroupIndex of a thread. */
DRYDOCK_API uint32_t GetIndexInGroup(const FInspectedShader& Shader, const std::array<int32_t, 3>& Position);

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

	/** Runs the group with its stores; of a quad, only those of the pixels that are drawn: bit i for the i-th. */
	void Run(const FKernelArgs& Args, const std::array<int32_t, 3>& GroupId, uint64_t MaxSteps, uint32_t Drawn = ~0u)
	{
		const int32_t Id[3] = {GroupId[0], GroupId[1], GroupId[2]};
		Group.SetHelpers(~Drawn);
		Logs = Group.Record(Args, Id, MaxSteps);
	}

	/** Runs the group of one thread, of a quad for this pixel alone, and prepares it. Shared, if not
	 * null, gets who wrote the groupshared memory that the thread reads. */
	void RunFor(TSpirvThread<Real>& Thread, const FKernelArgs& Args, const std::array<int32_t, 3>& Position,
		uint64_t MaxSteps, std::vector<FSharedRead>* Shared = nullptr)
	{
		FRaceFinder Finder;
		Finder.Follow(GetIndexInGroup(Shader, Position));
		SetRaceFinder(Shared ? &Finder : nullptr);
		const FGroupOfThreads Own = SortByGroups(Shader, {Position}).front();
		Run(Args, Own.GroupId, MaxSteps, 1u << (GetIndexInGroup(Shader, Position) & 31));
		Prepare(Thread, Position);
		SetRaceFinder(nullptr);
		if (Shared)
		{
			*Shared = Finder.GetFollowed();
		}
	}

	/** Thread, when it is run now, sees what the thread at that place saw in the group that ran last; it stores
	 * nothing. */
	void Prepare(TSpirvThread<Real>& Thread, const std::array<int32_t, 3>& Position)
	{
		const uint32_t Index = GetIndexInGroup(Shader, Position);
		Thread.SetPlace(Index, Shader.GetWaveSize());
		Thread.SetLog(&Logs[Index], true);
	}

private:
	const FInspectedShader& Shader;
	TSpirvGroup<Real> Group;
	std::vector<typename TSpirvGroup<Real>::FLog> Logs;
};

} // namespace Drydock
