// Forwards under the engine's path. Source: engine file PostProcess/PostProcessDownsample.h.
#pragma once

#include <Screen/PostProcessDownsample.h>
