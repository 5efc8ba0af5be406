// Counts lines by the blocks that threads went through.
#include "LineCoverage.h"

#include "AuthorsNames.h"

#include <deque>
#include <set>

namespace Drydock
{

using namespace Spirv;

namespace
{

/** False for the instruction by which a block goes on: it has the line of the one before and does no work of its
 * own. */
bool IsOfLine(const FSpirvInstruction& I)
{
	return I.Line && I.Op != OpBranch && I.Op != OpReturn;
}

/** Lines of a module, numbered, and those of each block. */
struct FBlockLines
{
	explicit FBlockLines(const FInspectedShader& Shader)
	{
		const FSpirvProgram& Program = Shader.GetProgram();
		std::map<std::pair<uint32_t, int>, uint32_t> Known;
		const std::vector<bool> bAuthors = FindAuthorsBlocks(Shader.GetModule());
		for (const FSpirvProgramBlock& Block : Program.Blocks)
		{
			std::set<uint32_t> OfBlock;
			const bool bCounts = bAuthors[Blocks.size()];
			for (uint32_t Index = Block.FirstStep; bCounts && Index < Block.FirstStep + Block.NumSteps; ++Index)
			{
				const FSpirvInstruction& I = *Program.Steps[Index].I;
				if (IsOfLine(I))
				{
					const auto [Entry, bNew] = Known.try_emplace({I.File, I.Line}, uint32_t(Lines.size()));
					if (bNew)
					{
						Lines.emplace_back(I.File, I.Line);
					}
					OfBlock.insert(Entry->second);
				}
			}
			Blocks.emplace_back(OfBlock.begin(), OfBlock.end());
		}
	}

	std::vector<std::pair<uint32_t, int>> Lines;
	std::vector<std::vector<uint32_t>> Blocks;
};

class FCoverageWatcher final : public IThreadWatcher
{
public:
	explicit FCoverageWatcher(const FBlockLines& InLines)
		: Lines(InLines)
		, Counts(InLines.Lines.size())
		, LastThread(InLines.Lines.size())
	{
	}

	void BeginThread(size_t, TSpirvThread<float>& Thread) override
	{
		Thread.BlockRuns.assign(Thread.BlockRuns.size(), 0);
	}

	void EndThread(size_t Index, TSpirvThread<float>& Thread) override
	{
		for (size_t Block = 0; Block < Thread.BlockRuns.size(); ++Block)
		{
			for (size_t i = 0; Thread.BlockRuns[Block] && i < Lines.Blocks[Block].size(); ++i)
			{
				const uint32_t Line = Lines.Blocks[Block][i];
				Counts[Line] += LastThread[Line] != Index + 1;
				LastThread[Line] = Index + 1;
			}
		}
	}

	const std::vector<uint64_t>& GetCounts() const { return Counts; }

private:
	const FBlockLines& Lines;
	std::vector<uint64_t> Counts;
	std::vector<size_t> LastThread; // 1 + the thread that counted last
};

} // namespace

FLineCoverage CollectLineCoverage(
	FInspectedShader& Shader, const FBoundShader& Bound, const FKernelArgs& Args, const FKernelTile& Whole)
{
	for (FSpirvStep& Step : Shader.GetProgram().Steps)
	{
		Step.bHook = false;
	}
	const FBlockLines Lines(Shader);
	const FThreadRuns Runs(Shader, Bound, Args, ListThreads(Whole));
	std::deque<FCoverageWatcher> Watchers;
	for (size_t Piece = 0; Piece < Runs.GetNumPieces(); ++Piece)
	{
		Watchers.emplace_back(Lines);
	}
	Runs.Run([&](size_t Piece) -> IThreadWatcher& { return Watchers[Piece]; });

	FLineCoverage Coverage;
	Coverage.Threads = Runs.GetThreads().size();
	for (size_t Index = 0; Index < Lines.Lines.size(); ++Index)
	{
		const auto [File, Line] = Lines.Lines[Index];
		const std::string& Path = Shader.GetModule().Files.at(File);
		FLineCount& Count = Coverage.Files[Path][Line];
		Count.Source = Shader.GetTrimmedLine(Path, Line);
		for (const FCoverageWatcher& Watcher : Watchers)
		{
			Count.Threads += Watcher.GetCounts()[Index];
		}
	}
	return Coverage;
}

void AddCoverage(FLineCoverage& Sum, const FLineCoverage& Other)
{
	Sum.Threads += Other.Threads;
	for (const auto& [File, Lines] : Other.Files)
	{
		for (const auto& [Line, Count] : Lines)
		{
			FLineCount& Known = Sum.Files[File][Line];
			Known.Source = Count.Source;
			Known.Threads += Count.Threads;
		}
	}
}

} // namespace Drydock
