// Makes the objects that stand for a project's assets: pictures, and the render targets of the config's "assets".
#pragma once

#include "Config/Config.h"

#include <string>
#include <vector>

class UTextureRenderTarget2D;

namespace Drydock
{

/** From now on a text finds what Config.Assets has under that name or path, and else the picture file of that name,
 * relative to the config. Reports mistakes of "assets". PNG and other pictures of 8 bits are sRGB (UTexture::SRGB),
 * others linear half floats. Objects live to the end of the program: a target that an earlier run has made is cleared,
 * others are made when code asks for them; a picture is read again when it was written. */
void BeginAssets(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics);

struct FAssetTarget
{
	std::string Name;                         // as the config has it
	UTextureRenderTarget2D* Target = nullptr; // null: nothing has asked for it
};

/** The render targets of the config's "assets", in its order. */
std::vector<FAssetTarget> GetAssetTargets(const FConfig& Config);

} // namespace Drydock
