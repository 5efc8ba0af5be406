// UTexture2D under its engine header. Source: engine Engine/Texture2D.h.
#pragma once

#include "Engine/Texture.h"
#include "TextureResource.h"
