// Forwards under the engine's whole path. Source: engine file RenderGraphUtils.h.
#pragma once

#include <RenderGraphUtils.h>
