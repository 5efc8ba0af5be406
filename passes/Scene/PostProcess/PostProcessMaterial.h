// Forwards under the name of engines up to 5.3. Source: engine file PostProcess/PostProcessMaterial.h.
#pragma once

#include "PostProcess/PostProcessMaterialInputs.h"
#include "ScreenPass.h"
