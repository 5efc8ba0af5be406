// Forwards under the engine's path. Source: engine file PostProcess/PostProcessWeightedSampleSum.h.
#pragma once

#include <Blur/PostProcessWeightedSampleSum.h>
