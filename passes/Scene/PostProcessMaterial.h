// Forwards for those who include it without its folder. Source: engine file PostProcess/PostProcessMaterial.h.
#pragma once

#include "PostProcess/PostProcessMaterial.h"
