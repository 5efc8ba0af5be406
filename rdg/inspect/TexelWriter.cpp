// Watches the stores of threads.
#include "TexelWriter.h"

#include "ThreadRuns.h"

#include <algorithm>
#include <deque>

namespace Drydock
{

using namespace Spirv;

namespace
{

class FStoreWatcher final : public IThreadWatcher
{
public:
	FStoreWatcher(const FSpirvProgram& InProgram, const std::string& InTexture, const std::array<int32_t, 3>& InTexel)
		: Program(InProgram)
		, Texture(InTexture)
		, Texel(InTexel)
	{
	}

	void OnStep(const FSpirvThreadView& Thread, const FSpirvStep& Step) override
	{
		const uint32_t Variable = Thread.GetBits(Program.Args[Step.FirstArg]);
		bool bThere = Program.Module.Variables.at(Variable).Name == Texture;
		for (uint32_t i = 0; i < 3 && i < Program.ArgSizes[Step.FirstArg + 1]; ++i)
		{
			bThere = bThere && int32_t(Thread.GetBits(Program.Args[Step.FirstArg + 1] + i)) == Texel[i];
		}
		if (bThere)
		{
			const int32_t* const At = Thread.GetPosition();
			Last = {At[0], At[1], At[2]};
		}
	}

	std::optional<std::array<int32_t, 3>> Last;

private:
	const FSpirvProgram& Program;
	const std::string& Texture;
	const std::array<int32_t, 3>& Texel;
};

} // namespace

std::optional<FTexelWriter> FindTexelWriter(FInspectedShader& Shader, const FBoundShader& Bound,
	const FKernelArgs& Args, const FKernelTile& Whole, const std::string& Texture, const std::array<int32_t, 3>& Texel)
{
	for (FSpirvStep& Step : Shader.GetProgram().Steps)
	{
		Step.bHook = Step.I->Op == OpImageWrite;
	}
	const std::array<int32_t, 3> Mirrored = {Texel[1], Texel[0], Texel[2]};
	for (const std::array<int32_t, 3>* const Guess : {&Texel, &Mirrored, static_cast<decltype(&Texel)>(nullptr)})
	{
		const bool bInside =
			!Guess || ((*Guess)[0] < Whole.MaxX && (*Guess)[1] < Whole.MaxY && (*Guess)[2] < Whole.MaxZ);
		if (!bInside)
		{
			continue;
		}
		const FThreadRuns Runs(
			Shader, Bound, Args, Guess ? std::vector<std::array<int32_t, 3>>{*Guess} : ListThreads(Whole));
		std::deque<FStoreWatcher> Watchers;
		for (size_t Piece = 0; Piece < Runs.GetNumPieces(); ++Piece)
		{
			Watchers.emplace_back(Shader.GetProgram(), Texture, Texel);
		}
		Runs.Run([&](size_t Piece) -> IThreadWatcher& { return Watchers[Piece]; });
		for (auto Watcher = Watchers.rbegin(); Watcher != Watchers.rend(); ++Watcher)
		{
			if (Watcher->Last)
			{
				return FTexelWriter{Texture, Texel, *Watcher->Last};
			}
		}
	}
	return std::nullopt;
}

} // namespace Drydock
