// The renderer's private header as plugins include it: the scene, and the view that shows it. Source: engine file
// ScenePrivate.h.
#pragma once

#include "PostProcess/PostProcessing.h"
#include "RendererScene.h"
#include "SceneRendering.h"
#include "SceneViewState.h"
