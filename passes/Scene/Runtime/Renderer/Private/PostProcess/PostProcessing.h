// Forwards under the engine's whole path. Source: engine file PostProcess/PostProcessing.h.
#pragma once

#include "PostProcess/PostProcessing.h"
