// Forwards under the engine's path. Source: engine file PostProcess/PostProcessEyeAdaptation.h.
#pragma once

#include <Exposure/PostProcessEyeAdaptation.h>
