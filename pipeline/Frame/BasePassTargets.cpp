// Binds the scene textures as the base pass of the engine does.
#include "Frame/BasePassTargets.h"

#include <iterator>

namespace Drydock
{

FRenderTargetBindingSlots GetBasePassTargets(const FSceneTextures& SceneTextures)
{
	FRenderTargetBindingSlots Targets;
	const FRDGTextureRef Textures[] = {SceneTextures.Color, SceneTextures.GBufferA, SceneTextures.GBufferB,
		SceneTextures.GBufferC, SceneTextures.GBufferD, SceneTextures.GBufferE};
	for (uint32 Slot = 0; Slot < std::size(Textures); ++Slot)
	{
		if (Textures[Slot] != nullptr)
		{
			Targets[Slot] = FRenderTargetBinding(Textures[Slot], ERenderTargetLoadAction::ELoad);
		}
	}
	if (const FRDGTextureRef Depth = SceneTextures.Depth)
	{
		Targets.DepthStencil = FDepthStencilBinding(Depth, ERenderTargetLoadAction::ELoad,
			ERenderTargetLoadAction::ELoad, FExclusiveDepthStencil::DepthWrite_StencilWrite);
	}
	return Targets;
}

} // namespace Drydock
