// Forwards under the engine's whole path. Source: engine file SceneViewExtension.h.
#pragma once

#include <SceneViewExtension.h>
