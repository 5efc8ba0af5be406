// Forwards under the engine's path. Source: engine file PostProcess/PostProcessFFTBloom.h.
#pragma once

#include <Bloom/PostProcessFFTBloom.h>
