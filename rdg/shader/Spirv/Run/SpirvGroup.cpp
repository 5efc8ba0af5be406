// Lets the threads of a group wait for each other. Threads of a wave that part meet again where their ways do: of those
// that wait at different places, the one that is furthest behind goes on first. Source of the rule: Khronos,
// VK_KHR_shader_maximal_reconvergence.
#include "SpirvGroup.h"

#include "SpirvQuads.h"
#include "RangeTools.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

std::array<int32_t, 3> GetThreadPosition(
	const FSpirvModule& Module, const std::array<int32_t, 3>& GroupId, uint32_t Index)
{
	const uint32_t* const Size = Module.LocalSize;
	const uint32_t Local[3] = {Index % Size[0], Index / Size[0] % Size[1], Index / Size[0] / Size[1]};
	std::array<int32_t, 3> Position;
	for (size_t Axis = 0; Axis < 3; ++Axis)
	{
		Position[Axis] = GroupId[Axis] * int32_t(Size[Axis]) + int32_t(Local[Axis]);
	}
	return Position;
}

template<typename Real>
TSpirvGroup<Real>::TSpirvGroup(
	const FSpirvProgram& InProgram, const FSpirvOrder& Order, const FSpirvSlotTable& Slots, uint32_t InWaveSize)
	: Program(InProgram)
	, WaveSize(InWaveSize)
	, Groupshared(InProgram.Groupshared.Size)
{
	const uint32_t* const Size = Program.Module.LocalSize;
	Waits.resize(Size[0] * Size[1] * Size[2]);
	for (size_t i = 0; i < Waits.size(); ++i)
	{
		Threads.push_back(std::make_unique<TSpirvThread<Real>>(Program, Slots));
		Threads.back()->SetGroupshared(Groupshared.data());
		Threads.back()->SetOrder(&Order);
		Threads.back()->SetPlace(uint32_t(i), WaveSize);
	}
}

template<typename Real>
void TSpirvGroup<Real>::SetRaceFinder(FRaceFinder* InRaces)
{
	Races = InRaces;
	for (const auto& Thread : Threads)
	{
		Thread->SetRaceFinder(Races);
	}
}

template<typename Real>
void TSpirvGroup<Real>::Run(const FKernelArgs& Args, const int32_t (&GroupId)[3], uint64_t MaxSteps)
{
	for (const auto& Thread : Threads)
	{
		Thread->SetLog(nullptr, false);
	}
	RunAll(Args, GroupId, MaxSteps);
}

template<typename Real>
std::vector<typename TSpirvGroup<Real>::FLog> TSpirvGroup<Real>::Record(
	const FKernelArgs& Args, const int32_t (&GroupId)[3], uint64_t MaxSteps)
{
	std::vector<FLog> Logs(Threads.size());
	for (size_t i = 0; i < Threads.size(); ++i)
	{
		Threads[i]->SetLog(&Logs[i], false);
	}
	RunAll(Args, GroupId, MaxSteps);
	return Logs;
}

template<typename Real>
void TSpirvGroup<Real>::RunAll(const FKernelArgs& Args, const int32_t (&GroupId)[3], uint64_t MaxSteps)
{
	const uint32_t NumThreads = GetNumThreads();
	if (Races)
	{
		Races->Begin(Groupshared.size());
	}
	std::fill(Groupshared.begin(), Groupshared.end(), FWord(0));
	for (uint32_t i = 0; i < NumThreads; ++i)
	{
		const std::array<int32_t, 3> At = GetThreadPosition(Program.Module, {GroupId[0], GroupId[1], GroupId[2]}, i);
		Threads[i]->Start(Args, {At[0], At[1], At[2]});
		Threads[i]->SetHelper(Program.Module.bQuads && (Helpers >> i & 1));
		Waits[i] = Threads[i]->Advance(MaxSteps);
	}
	while (std::find(Waits.begin(), Waits.end(), true) != Waits.end())
	{
		for (uint32_t First = 0; First < NumThreads; First += WaveSize)
		{
			RunWave(First, std::min(First + WaveSize, NumThreads), MaxSteps);
		}
		if (Races)
		{
			Races->PassBarrier();
		}
		for (const uint32_t i : FindLast(0, NumThreads, true))
		{
			Threads[i]->ExecuteWaiting();
			Threads[i]->StepOver();
			Waits[i] = Threads[i]->Advance(MaxSteps);
		}
	}
}

template<typename Real>
void TSpirvGroup<Real>::RunWave(uint32_t First, uint32_t Last, uint64_t MaxSteps)
{
	for (;;)
	{
		const std::vector<uint32_t> Together = FindLast(First, Last, false);
		if (Together.empty())
		{
			return;
		}
		const FSpirvInstruction& I = *Threads[Together.front()]->GetWaiting().I;
		if (IsSpirvWave(I.Op) || (Program.Module.bQuads && IsQuadStep(I)))
		{
			auto Taking = ToVector<TSpirvThread<Real>*>(Together, [&](const uint32_t i) { return Threads[i].get(); });
			TSpirvThread<Real>::ExecuteTogether(Taking);
		}
		else
		{
			for (const uint32_t i : Together)
			{
				Threads[i]->ExecuteWaiting();
			}
		}
		for (const uint32_t i : Together)
		{
			Threads[i]->StepOver();
			Waits[i] = Threads[i]->Advance(MaxSteps);
		}
	}
}

template<typename Real>
std::vector<uint32_t> TSpirvGroup<Real>::FindLast(uint32_t First, uint32_t Last, bool bAtBarriers) const
{
	std::vector<uint32_t> Found;
	std::vector<uint32_t> Least;
	for (uint32_t i = First; i < Last; ++i)
	{
		if (!Waits[i] || (Threads[i]->GetWaiting().I->Op == OpControlBarrier) != bAtBarriers)
		{
			continue;
		}
		std::vector<uint32_t> Where = Threads[i]->GetWhereInOrder();
		if (Found.empty() || Where < Least)
		{
			Found.clear();
			Least = std::move(Where);
			Found.push_back(i);
		}
		else if (Where == Least)
		{
			Found.push_back(i);
		}
	}
	return Found;
}

template class TSpirvGroup<float>;
template class TSpirvGroup<double>;

} // namespace Drydock
