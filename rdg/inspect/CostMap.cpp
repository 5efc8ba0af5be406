// Counts what threads did by the blocks that they went through.
#include "CostMap.h"

#include <deque>

namespace Drydock
{

using namespace Spirv;

namespace
{

/** Numbers that a step makes by computing. Moving values and control flow do not count. */
uint64_t CountOperations(const FSpirvModule& Module, const FSpirvInstruction& I)
{
	const bool bComputes =
		I.Op == OpExtInst || (I.Op >= OpConvertFToU && I.Op <= OpBitcast) || (I.Op >= OpSNegate && I.Op < OpPhi);
	return bComputes && I.Type ? Module.GetType(I.Type).NumScalars : 0;
}

class FCostWatcher final : public IThreadWatcher
{
public:
	FCostWatcher(const std::vector<uint64_t>& InOperations, FCostMap& InMap)
		: Operations(InOperations)
		, Map(InMap)
	{
	}

	void BeginThread(size_t, TSpirvThread<float>& Thread) override
	{
		Thread.BlockRuns.assign(Thread.BlockRuns.size(), 0);
	}

	void EndThread(size_t Index, TSpirvThread<float>& Thread) override
	{
		Map.Taps[Index] = Thread.Taps;
		for (size_t Block = 0; Block < Operations.size(); ++Block)
		{
			Map.Operations[Index] += Thread.BlockRuns[Block] * Operations[Block];
		}
	}

private:
	const std::vector<uint64_t>& Operations; // by block
	FCostMap& Map;                           // each watcher writes its own threads
};

} // namespace

FCostMap MakeCostMap(
	FInspectedShader& Shader, const FBoundShader& Bound, const FKernelArgs& Args, const FKernelTile& Whole)
{
	FSpirvProgram& Program = Shader.GetProgram();
	std::vector<uint64_t> Operations;
	for (const FSpirvProgramBlock& Block : Program.Blocks)
	{
		uint64_t& Sum = Operations.emplace_back();
		for (uint32_t Index = Block.FirstStep; Index < Block.FirstStep + Block.NumSteps; ++Index)
		{
			Program.Steps[Index].bHook = false;
			Sum += CountOperations(Shader.GetModule(), *Program.Steps[Index].I);
		}
	}
	FCostMap Map;
	Map.Width = Whole.MaxX - Whole.MinX;
	Map.Height = (Whole.MaxY - Whole.MinY) * (Whole.MaxZ - Whole.MinZ);
	const FThreadRuns Runs(Shader, Bound, Args, ListThreads(Whole));
	Map.Taps.resize(Runs.GetThreads().size());
	Map.Operations.resize(Runs.GetThreads().size());
	std::deque<FCostWatcher> Watchers;
	for (size_t Piece = 0; Piece < Runs.GetNumPieces(); ++Piece)
	{
		Watchers.emplace_back(Operations, Map);
	}
	Runs.Run([&](size_t Piece) -> IThreadWatcher& { return Watchers[Piece]; });
	return Map;
}

} // namespace Drydock
