// Source: engine TextureResource.h. What code takes from it, FTexture and its kin, lies in RenderResource.h.
#pragma once

#include "RenderResource.h"
