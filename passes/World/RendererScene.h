// The renderer's own scene: it holds nothing here but its world. Plugins include ScenePrivate.h. Source: engine file
// ScenePrivate.h.
#pragma once

#include "SceneInterface.h"

class DRYDOCK_API FScene : public FSceneInterface
{
public:
	using FSceneInterface::FSceneInterface;
	using FSceneInterface::World;

	FScene* GetRenderScene() override { return this; }
};
