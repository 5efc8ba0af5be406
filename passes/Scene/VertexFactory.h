// There are no meshes: what code takes from it are vertex buffers and declarations. Source: engine file
// VertexFactory.h.
#pragma once

#include "RenderResource.h"
