// The scene textures' uniform buffer under the engine's other name for it. Source: engine file
// SceneRenderTargetParameters.h.
#pragma once

#include "SceneTextureParameters.h"
