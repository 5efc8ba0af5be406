// Source: engine GlobalRenderResources.h. What code takes from it, the plain textures, lies in RenderResource.h.
#pragma once

#include "RenderResource.h"
