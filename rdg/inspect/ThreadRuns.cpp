// Cuts threads into pieces and runs them on all cores.
#include "ThreadRuns.h"

#include "SpirvQuads.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

namespace
{

constexpr uint64_t MaxSteps = 100'000'000; // of one thread
constexpr int32_t PieceSize = 1024;
constexpr int32_t GroupsPerPiece = 16;

/** Whether threads see what others stored: then their order counts. */
bool ReadsWhatItWrites(const FInspectedShader& Shader)
{
	const FSpirvProgram& Program = Shader.GetProgram();
	for (const FSpirvStep& Step : Program.Steps)
	{
		const bool bBuffer = Step.I->Op == OpLoad && Step.Place != ~0u && Program.PlaceOf(Step).ElementStride;
		if (Step.I->Op == OpImageRead || bBuffer)
		{
			return true;
		}
	}
	return false;
}

} // namespace

IThreadWatcher::~IThreadWatcher() = default;

std::vector<std::array<int32_t, 3>> ListThreads(const FKernelTile& Whole)
{
	std::vector<std::array<int32_t, 3>> Threads;
	for (int32_t z = Whole.MinZ; z < Whole.MaxZ; ++z)
	{
		for (int32_t y = Whole.MinY; y < Whole.MaxY; ++y)
		{
			for (int32_t x = Whole.MinX; x < Whole.MaxX; ++x)
			{
				Threads.push_back({x, y, z});
			}
		}
	}
	return Threads;
}

std::vector<std::array<int32_t, 3>> SampleThreads(
	const FKernelTile& Whole, const FShaderReflection& Shader, size_t Most)
{
	constexpr int32_t Pixels[3] = {8, 8, 1};
	const int32_t* const Size = Shader.Stage == EShaderStage::Compute ? Shader.GroupSize : Pixels;
	const size_t Total =
		size_t(Whole.MaxX - Whole.MinX) * size_t(Whole.MaxY - Whole.MinY) * size_t(Whole.MaxZ - Whole.MinZ);
	std::vector<std::array<int32_t, 3>> Threads;
	const size_t Every = (Total + Most - 1) / std::max<size_t>(1, Most);
	size_t Row = 0;
	for (int32_t z = Whole.MinZ; Every > 1 && z < Whole.MaxZ; z += Size[2])
	{
		for (int32_t y = Whole.MinY; y < Whole.MaxY; y += Size[1], ++Row)
		{
			size_t Block = Row * (Every / 2 + 1); // rows begin at different places
			for (int32_t x = Whole.MinX; x < Whole.MaxX; x += Size[0], ++Block)
			{
				const FKernelTile Tile = {x, y, z, std::min(x + Size[0], Whole.MaxX), std::min(y + Size[1], Whole.MaxY),
					std::min(z + Size[2], Whole.MaxZ)};
				const bool bLast = Tile.MaxX == Whole.MaxX && Tile.MaxY == Whole.MaxY && Tile.MaxZ == Whole.MaxZ;
				if (Block % Every == 0 || bLast)
				{
					const std::vector<std::array<int32_t, 3>> Inside = ListThreads(Tile);
					Threads.insert(Threads.end(), Inside.begin(), Inside.end());
				}
			}
		}
	}
	return Threads;
}

FThreadRuns::FThreadRuns(FInspectedShader& InShader, const FBoundShader& InBound, const FKernelArgs& InArgs,
	std::vector<std::array<int32_t, 3>> InThreads)
	: Shader(InShader)
	, Args(InArgs)
	, Sandbox(InArgs, InBound.GetReflection())
	, Threads(std::move(InThreads))
{
	size_t Count = Threads.size();
	PerPiece = ReadsWhatItWrites(Shader) ? std::max(1, int32_t(Threads.size())) : PieceSize;
	if (Shader.HasGroups())
	{
		Groups = SortByGroups(Shader, Threads);
		Count = Groups.size();
		const bool bInOrder =
			Shader.GetProgram().Groups.bInOrder || (Shader.GetModule().bQuads && ReadsWhatItWrites(Shader));
		PerPiece = bInOrder                    ? std::max(1, int32_t(Count))
				   : Shader.GetModule().bQuads ? PieceSize / int32_t(GQuadSize)
											   : GroupsPerPiece;
	}
	NumPieces = (Count + size_t(PerPiece) - 1) / size_t(PerPiece);
}

void FThreadRuns::RunGroups(TFunctionRef<IThreadWatcher&(size_t Piece)> GetWatcher, bool bTrackUndefined) const
{
	ForEachTile(
		{0, 0, 0, int32_t(Groups.size()), 1, 1}, FIntPoint(PerPiece, 1),
		[&](const FKernelTile& Tile)
		{
			IThreadWatcher& Watcher = GetWatcher(size_t(Tile.MinX / PerPiece));
			TGroupRuns<float> Runs(Shader);
			Runs.SetRaceFinder(Watcher.GetRaceFinder());
			TSpirvThread<float> Thread(Shader.GetProgram(), Shader.GetSlots());
			Thread.SetObserver(&Watcher, bTrackUndefined);
			for (int32_t i = Tile.MinX; i < Tile.MaxX; ++i)
			{
				const FGroupOfThreads& Group = Groups[size_t(i)];
				uint32_t Drawn = 0;
				for (const size_t Index : Group.Threads)
				{
					Drawn |= 1u << (GetIndexInGroup(Shader, Threads[Index]) & 31);
				}
				Runs.Run(Sandbox.GetArgs(), Group.GroupId, MaxSteps, Drawn);
				Watcher.EndGroup(Group.GroupId);
				for (const size_t Index : Group.Threads)
				{
					const std::array<int32_t, 3>& At = Threads[Index];
					Runs.Prepare(Thread, At);
					Watcher.BeginThread(Index, Thread);
					Thread.Run(Sandbox.GetArgs(), {At[0], At[1], At[2]}, nullptr, MaxSteps);
					Watcher.EndThread(Index, Thread);
				}
			}
		},
		EDenormals::Flush);
}

void FThreadRuns::Run(TFunctionRef<IThreadWatcher&(size_t Piece)> GetWatcher, bool bTrackUndefined) const
{
	if (!Groups.empty())
	{
		RunGroups(GetWatcher, bTrackUndefined);
		return;
	}
	ForEachTile(
		{0, 0, 0, int32_t(Threads.size()), 1, 1}, FIntPoint(PerPiece, 1),
		[&](const FKernelTile& Tile)
		{
			IThreadWatcher& Watcher = GetWatcher(size_t(Tile.MinX / PerPiece));
			TSpirvThread<float> Thread(Shader.GetProgram(), Shader.GetSlots());
			Thread.SetObserver(&Watcher, bTrackUndefined);
			for (int32_t Index = Tile.MinX; Index < Tile.MaxX; ++Index)
			{
				const std::array<int32_t, 3>& At = Threads[size_t(Index)];
				Watcher.BeginThread(size_t(Index), Thread);
				Thread.Run(Sandbox.GetArgs(), {At[0], At[1], At[2]}, nullptr, MaxSteps);
				Watcher.EndThread(size_t(Index), Thread);
			}
		},
		EDenormals::Flush);
}

} // namespace Drydock
