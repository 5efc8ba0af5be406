// UTextureCube under its engine header. Source: engine Engine/TextureCube.h.
#pragma once

#include "Engine/Texture.h"
