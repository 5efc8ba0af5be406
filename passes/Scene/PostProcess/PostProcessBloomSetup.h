// Forwards under the engine's path. Source: engine file PostProcess/PostProcessBloomSetup.h.
#pragma once

#include <Bloom/PostProcessBloomSetup.h>
