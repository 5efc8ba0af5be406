// Textures of a graph as pictures: what a dump, a report and a measurement look at.
#pragma once

#include "Picture/ImageFile.h"
#include "RHITexture.h"

#include <string>
#include <vector>

namespace Drydock
{

/** The values of one mip as stored, channels that the format has. */
DRYDOCK_API FImage ReadTexture(FRHITexture& Texture, int Mip = 0);

/** One channel (0 red to 3 alpha) inside a rect, in the precision that shaders read. */
DRYDOCK_API FImage ReadChannel(FRHITexture& Texture, const FIntRect& Rect, int Channel);

/** "R", "RG", ... for a number of channels. */
DRYDOCK_API std::vector<std::string> GetChannelNames(int NumChannels);

} // namespace Drydock
