// Acts while a run's graph is built and executed: loads the scene, keeps dumped textures, records the cost of passes.
#pragma once

#include "RenderGraphObserver.h"
#include "Run/RunResult.h"
#include "Run/UnwrittenWatch.h"
#include "SceneFile/SceneFile.h"

#include <map>

namespace Drydock
{

struct FRunOptions;
struct FRunSetup;

/** The context of a config's scene textures. ViewRect: of all views. */
FScenePackContext MakePackContext(const FConfig& Config, const FIntRect& ViewRect);

/** Loads what the compiled graph needs, keeps what is dumped, and notes what each pass cost. All outlive it. */
class FRunObserver final : public IRDGObserver
{
public:
	FRunObserver(const FRunOptions& InOptions, const FRunSetup& InSetup, FSceneFile& InScene, FRunResult& InResult);

	void OnGraphCompiled(const FRDGCompiledGraph& Graph) override;
	bool WantsPlannedExternals() const override;
	void OnPassPlanned(int32_t PassIndex, const FRDGPass& Pass) override;
	bool WantsZeroedTextures() const override;
	bool OnTextureMade(FRHITexture& Texture) override;
	bool ShowsWarnings() const override { return true; } // they are among the run's
	void OnExternalsPlanned(const std::vector<FRDGExternalLoad>& Loads) override;
	void OnLoadExternals(const std::vector<FRDGExternalLoad>& Loads) override;
	void OnPassExecuted(int32_t PassIndex, const FRDGPass& Pass, double Milliseconds, const FPassCounters& Counters,
		const std::vector<FRDGTexture*>& WrittenTextures) override;

	/** Keeps the render targets of the config's "assets" as they are after the frame; notes those that nothing drew. */
	void KeepAssets();

	const std::vector<FDiagnostic>& GetUnwrittenReads() const { return Unwritten.GetDiagnostics(); }

private:
	/** Finds the needed textures; without skipping, every texture that the file can fill. */
	std::vector<FNeededSceneTexture> FindNeeded(const std::vector<FRDGExternalLoad>& Loads) const;
	/** Warns of shaders that read custom depth or stencil of a scene that has none. */
	void ReportAbsent(const std::vector<FRDGExternalLoad>& Loads);
	/** Adds what the pass drew of each texture to what is known of it. */
	void NoteDrawn(
		const FRDGPass& Pass, const FPassCounters& Counters, const std::vector<FRDGTexture*>& WrittenTextures);
	/** Remarks on a pass that did nothing. */
	void NoteSilence(
		const FRDGPass& Pass, const FPassCounters& Counters, const std::vector<FRDGTexture*>& WrittenTextures);
	/** Gives a pass's writes to the caller that asked for them (FRunOptions::OnPassExecuted). */
	void TellWrites(int PassIndex, const FRDGPass& Pass, const std::vector<FRDGTexture*>& WrittenTextures);
	void KeepTexture(int PassIndex, const std::string& Pass, const std::string& Resource, FRHITexture& Texture,
		const std::vector<FIntRect>& Windows);
	void ReportProgress() const;

	const FRunOptions& Options;
	const FRunSetup& Setup;
	FSceneFile& Scene;
	FRunResult& Result;
	/** The smallest rect around what passes drew, for each texture that they have written, by mip. */
	std::map<const FRDGTexture*, std::vector<FIntRect>> Drawn;
	/** Indices of the graph's passes that are not left out; empty while a graph runs in immediate mode. */
	std::vector<size_t> ToExecute;
	FUnwrittenWatch Unwritten;
	const FScopedDispatchObserver UnwrittenScope{Unwritten};
};

} // namespace Drydock
