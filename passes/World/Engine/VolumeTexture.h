// A texture with three dimensions, as settings name it. Source: engine file Engine/VolumeTexture.h.
#pragma once

#include "Engine/Texture.h"

class DRYDOCK_API UVolumeTexture : public UTexture
{
};
