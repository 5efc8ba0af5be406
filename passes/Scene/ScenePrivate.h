// The renderer's own scene: it holds nothing here but its world. Source: engine file ScenePrivate.h.
#pragma once

#include "PostProcess/PostProcessing.h"
#include "SceneInterface.h"
#include "SceneRendering.h"
#include "SceneViewState.h"

class DRYDOCK_API FScene : public FSceneInterface
{
public:
	using FSceneInterface::FSceneInterface;
	using FSceneInterface::World;

	FScene* GetRenderScene() override { return this; }
};
