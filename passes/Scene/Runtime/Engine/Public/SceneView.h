// Forwards under the engine's whole path. Source: engine file SceneView.h.
#pragma once

#include <SceneView.h>
