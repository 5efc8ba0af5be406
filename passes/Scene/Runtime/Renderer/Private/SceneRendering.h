// Forwards under the engine's whole path. Source: engine file SceneRendering.h.
#pragma once

#include <SceneRendering.h>
