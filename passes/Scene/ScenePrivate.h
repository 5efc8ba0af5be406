// The renderer's own scene: it holds nothing here. Source: engine file ScenePrivate.h.
#pragma once

#include "PostProcess/PostProcessing.h"
#include "SceneInterface.h"
#include "SceneRendering.h"

class FScene : public FSceneInterface
{
public:
	using FSceneInterface::FSceneInterface;
};
