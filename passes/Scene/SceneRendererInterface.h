// What code takes from it lies in SceneView.h. Source: engine file SceneRendererInterface.h.
#pragma once

#include "SceneView.h"
