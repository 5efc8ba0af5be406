// Runs the threads of a draw or dispatch once more by the interpreter, for a watcher.
#pragma once

#include "GroupRuns.h"
#include "InspectedShader.h"
#include "Sandbox.h"
#include "TileExecutor.h"

#include <array>

namespace Drydock
{

/** An observer that watches threads one after the other. */
class DRYDOCK_API IThreadWatcher : public ISpirvObserver
{
public:
	~IThreadWatcher() override;
	/** Index counts the threads of all pieces. */
	virtual void BeginThread(size_t /*Index*/, TSpirvThread<float>&) {}
	virtual void EndThread(size_t /*Index*/, TSpirvThread<float>&) {}
	/** The finder that sees accesses to groupshared memory while a group runs, before its threads are shown. EndGroup
	 * is called when the group is over. */
	virtual FRaceFinder* GetRaceFinder() { return nullptr; }
	virtual void EndGroup(const std::array<int32_t, 3>& /*GroupId*/) {}
};

/** x first, then y, then z. */
DRYDOCK_API std::vector<std::array<int32_t, 3>> ListThreads(const FKernelTile& Whole);

/** At most about Most of them, in whole blocks of GroupSize (of pixels, 8 x 8) that are spread evenly, the first and
 * the last block among them; empty: there are no more than that. */
DRYDOCK_API std::vector<std::array<int32_t, 3>> SampleThreads(
	const FKernelTile& Whole, const FShaderReflection& Shader, size_t Most);

/** Threads in pieces that may run side by side. If threads see the stores of others, there is one piece, in order. */
class DRYDOCK_API FThreadRuns
{
public:
	/** All but Threads outlive it. */
	FThreadRuns(FInspectedShader& InShader, const FBoundShader& InBound, const FKernelArgs& InArgs,
		std::vector<std::array<int32_t, 3>> InThreads);

	size_t GetNumPieces() const { return NumPieces; }
	const std::vector<std::array<int32_t, 3>>& GetThreads() const { return Threads; }

	/** Runs all, on copies of what the shader writes, under the denormal mode of kernels; each piece is watched by its
	 * own watcher. The watchers' hooks choose the steps that are shown. Throws FSpirvError where a thread does not end.
	 */
	void Run(TFunctionRef<IThreadWatcher&(size_t Piece)> GetWatcher, bool bTrackUndefined = false) const;

private:
	void RunGroups(TFunctionRef<IThreadWatcher&(size_t Piece)> GetWatcher, bool bTrackUndefined) const;

	FInspectedShader& Shader;
	const FKernelArgs& Args;
	const FSandbox Sandbox;
	std::vector<std::array<int32_t, 3>> Threads;
	std::vector<FGroupOfThreads> Groups; // where threads work together: then pieces are made of these
	int32_t PerPiece = 0;                // threads, or groups
	size_t NumPieces = 0;
};

} // namespace Drydock
