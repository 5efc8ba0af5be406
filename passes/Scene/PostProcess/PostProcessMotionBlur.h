// Forwards under the engine's path. Source: engine file PostProcess/PostProcessMotionBlur.h.
#pragma once

#include <Lens/PostProcessMotionBlur.h>
