// Forwards under the engine's whole path. Source: engine file PostProcess/PostProcessMaterial.h.
#pragma once

#include "PostProcess/PostProcessMaterial.h"
