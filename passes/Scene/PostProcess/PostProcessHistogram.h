// Forwards under the engine's path. Source: engine file PostProcess/PostProcessHistogram.h.
#pragma once

#include <Exposure/PostProcessHistogram.h>
