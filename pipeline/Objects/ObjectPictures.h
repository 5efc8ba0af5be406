// Gives a plugin's texture properties their pictures: a text of the config's "objects" names a file, relative to the
// config.
#pragma once

#include "Config/Config.h"
#include "UObject/Reflection.h"

namespace Drydock
{

/** Turns, in a value of that type, the names of picture files into textures. PNG and other pictures of 8 bits are sRGB
 * (UTexture::SRGB), others linear half floats. False, with the reason, where a file cannot be read. Textures live to
 * the end of the program; a file is read again when it was written. */
bool LoadPictures(
	const FConfig& Config, const FPropertyType& Type, FPropertyValue& Value, FPropertyProblem& OutProblem);

} // namespace Drydock
