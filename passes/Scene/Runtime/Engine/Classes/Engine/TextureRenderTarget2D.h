// Forwards under the engine's whole path. Source: engine file Engine/TextureRenderTarget2D.h.
#pragma once

#include "Engine/TextureRenderTarget2D.h"
