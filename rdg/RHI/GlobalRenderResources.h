// Stands under the engine's name for RenderResource.h, which has what code takes from it: the plain textures. Source:
// engine GlobalRenderResources.h.
#pragma once

#include "RenderResource.h"
