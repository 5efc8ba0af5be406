// Forwards under the engine's whole path. Source: engine file PixelShaderUtils.h.
#pragma once

#include <PixelShaderUtils.h>
