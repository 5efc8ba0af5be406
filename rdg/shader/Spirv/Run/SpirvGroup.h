// Runs all threads of a compute shader's group, or of a quad of pixels, in turn, from one waiting place to the next.
#pragma once

#include "SpirvThread.h"

#include <array>
#include <memory>

namespace Drydock
{

/** Dispatch id of the thread of SV_GroupIndex Index in the group of SV_GroupID. */
DRYDOCK_API std::array<int32_t, 3> GetThreadPosition(
	const FSpirvModule& Module, const std::array<int32_t, 3>& GroupId, uint32_t Index);

template<typename Real>
class DRYDOCK_API TSpirvGroup
{
public:
	using FWord = TSpirvWord<Real>;
	/** The values that a thread read from others, to run it again alone: TSpirvThread::SetLog. */
	using FLog = std::vector<FWord>;

	/** Program and Order must outlive it. */
	TSpirvGroup(
		const FSpirvProgram& InProgram, const FSpirvOrder& InOrder, const FSpirvSlotTable& Slots, uint32_t InWaveSize);

	/** Runs the group of SV_GroupID; throws FSpirvError after MaxSteps instructions of a thread. */
	void Run(const FKernelArgs& Args, const int32_t (&GroupId)[3], uint64_t MaxSteps);
	/** The same, and what each thread saw, by SV_GroupIndex. */
	std::vector<FLog> Record(const FKernelArgs& Args, const int32_t (&GroupId)[3], uint64_t MaxSteps);

	/** Pixels of a quad that are not drawn, from now on: bit i is the thread of index i. */
	void SetHelpers(uint32_t InHelpers) { Helpers = InHelpers; }

	/** Sets the finder that sees every group that runs from now on; null: none. */
	void SetRaceFinder(FRaceFinder* InRaces);

	uint32_t GetNumThreads() const { return uint32_t(Threads.size()); }
	/** As it was when the group had run. */
	const TSpirvThread<Real>& GetThread(uint32_t Index) const { return *Threads.at(Index); }
	/** The thread, to be observed from now on. */
	TSpirvThread<Real>& GetThread(uint32_t Index) { return *Threads.at(Index); }

private:
	void RunAll(const FKernelArgs& Args, const int32_t (&GroupId)[3], uint64_t MaxSteps);
	/** Threads of [First, Last) go on until each has ended or waits at a barrier. */
	void RunWave(uint32_t First, uint32_t Last, uint64_t MaxSteps);
	/** Those of the waiting threads in [First, Last) that are furthest behind, and at the same place. */
	std::vector<uint32_t> FindLast(uint32_t First, uint32_t Last, bool bAtBarriers) const;

	const FSpirvProgram& Program;
	const uint32_t WaveSize;
	std::vector<std::unique_ptr<TSpirvThread<Real>>> Threads;
	std::vector<bool> Waits; // by thread; false: it has ended
	std::vector<FWord> Groupshared;
	FRaceFinder* Races = nullptr;
	uint32_t Helpers = 0;
};

extern template class DRYDOCK_API TSpirvGroup<float>;
extern template class DRYDOCK_API TSpirvGroup<double>;

} // namespace Drydock
