// The scene textures under the name of engine 4. Source: engine file PostProcess/SceneRenderTargets.h.
#pragma once

#include "SceneTextureParameters.h"
