// Forwards under the engine's whole path. Source: engine file PostProcess/PostProcessInputs.h.
#pragma once

#include "PostProcess/PostProcessInputs.h"
