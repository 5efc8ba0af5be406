// Forwards under the engine's whole path. Source: engine file RenderGraphBuilder.h.
#pragma once

#include <RenderGraphBuilder.h>
