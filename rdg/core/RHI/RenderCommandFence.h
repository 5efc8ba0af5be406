// FRenderCommandFence: render commands run where they are enqueued, so none is ever waited for. Source: engine
// RenderCommandFence.h.
#pragma once

#include "CoreTypes.h"

class FRenderCommandFence
{
public:
	void BeginFence(bool = false) {}
	void Wait(bool = false) const {}
	/** True: whatever was enqueued has run. */
	bool IsFenceComplete() const { return true; }
};
