// Forwards under the engine's path. Source: engine file PostProcess/PostProcessLocalExposure.h.
#pragma once

#include <Exposure/PostProcessLocalExposure.h>
