// How the frame's host watches a graph: what was compiled, which external textures have to be filled, what each pass
// cost and wrote. Source: drydock.
#pragma once

#include "PassCounters.h"
#include "RenderGraphCompiled.h"
#include "RenderGraphFwd.h"

#include <vector>

namespace Drydock
{

/** All calls come from Execute (in immediate mode: from AddPass), on its thread. */
class DRYDOCK_API IRDGObserver
{
public:
	virtual ~IRDGObserver();

	/** Before anything is executed. Immediate mode: at the end, when all passes are known. */
	virtual void OnGraphCompiled(const FRDGCompiledGraph&) {}

	/** Registered textures that surviving passes touch, before the first of these passes. Their RHI textures have no
	 * memory unless somebody touched them: this is the moment to fill them. */
	virtual void OnLoadExternals(const std::vector<FRDGTexture*>&) {}

	/** After each pass. PassIndex is its position in FRDGCompiledGraph::Passes; WrittenTextures may be read through
	 *  FRDGTexture::GetRHI during the call. */
	virtual void OnPassExecuted(int32_t /*PassIndex*/, const FRDGPass&, double /*Milliseconds*/, const FPassCounters&,
		const std::vector<FRDGTexture*>& /*WrittenTextures*/)
	{
	}
};

} // namespace Drydock
