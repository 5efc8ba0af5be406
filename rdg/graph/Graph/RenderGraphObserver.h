// Lets the frame's host watch a graph: what was compiled, which external textures have to be filled, what each pass
// cost and wrote.
#pragma once

#include "PassCounters.h"
#include "RenderGraphCompiled.h"
#include "RenderGraphFwd.h"

#include <vector>

namespace Drydock
{

/** A registered texture that a graph is about to use. */
struct FRDGExternalLoad
{
	FRDGTexture* Texture = nullptr;
	const FRDGPass* Pass = nullptr; // the first that uses it
	/** False if only a uniform buffer names the texture and the pass has not named its shader: the texture may go
	 * unread. */
	bool bIsRead = true;
};

/** All calls come from Execute (in immediate mode from AddPass, for a discarded graph from Discard), on its thread. */
class DRYDOCK_API IRDGObserver
{
public:
	virtual ~IRDGObserver();

	/** Called before anything is executed; in immediate mode at the end, when all passes are known. The compiled data
	 * of an executed graph stay until its builder goes. */
	virtual void OnGraphCompiled(const FRDGCompiledGraph&) {}

	/** Registered textures that surviving passes use, before the first of these passes. Their RHI textures have no
	 * memory unless somebody touched them: this is the moment to fill them. Textures that a pass's uniform buffers name
	 * but its shader does not read are left out. One that was announced with bIsRead false may come once more with
	 * true. */
	virtual void OnLoadExternals(const std::vector<FRDGExternalLoad>&) {}

	/** Gives observers that want it the list that OnLoadExternals would have received, for a graph that is discarded.
	 * The list depends on shaders, so they are compiled. */
	virtual bool WantsPlannedExternals() const { return false; }
	virtual void OnExternalsPlanned(const std::vector<FRDGExternalLoad>&) {}

	/** Each pass of a graph that is discarded, in their order: its parameters may be read. */
	virtual void OnPassPlanned(int32_t /*PassIndex*/, const FRDGPass&) {}

	/** Whether texels that no pass has written yet are 0 in every texture that the graph makes, instead of the memory's
	 * old contents: for observers that show textures beyond what passes wrote. Always the same answer. */
	virtual bool WantsZeroedTextures() const { return false; }

	/** A texture of the graph's own has got memory, which holds anything. True: zero it before it is used. */
	virtual bool OnTextureMade(FRHITexture&) { return false; }

	/** Whether the observer shows the warnings that OnGraphCompiled brings, so that the graph prints none itself. */
	virtual bool ShowsWarnings() const { return false; }

	/** Called after each pass. PassIndex is its position in FRDGCompiledGraph::Passes; WrittenTextures may be read
	 * through FRDGTexture::GetRHI during the call. */
	virtual void OnPassExecuted(int32_t /*PassIndex*/, const FRDGPass&, double /*Milliseconds*/, const FPassCounters&,
		const std::vector<FRDGTexture*>& /*WrittenTextures*/)
	{
	}
};

} // namespace Drydock
