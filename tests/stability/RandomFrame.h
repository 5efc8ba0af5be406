// Random frames from a seed: a scene picture and a config, for tests that run one frame in several ways.
#pragma once

#include "Picture/Picture.h"
#include "Run/Run.h"
#include "SceneFolder.h"

#include <string>
#include <vector>

namespace Stability
{

/** A frame as data. Colour is linear, depth in metres, velocity in pixels; pixels count from the picture's top left. */
struct FRandomFrame
{
	Drydock::FImage Picture;
	std::vector<std::string> Channels; // of Picture
	std::string Config;                // JSON; its scene is "scene.exr"
};

/** Effects, settings in their range, inserted passes, sizes from 1 to 1200, rects, padding, engine profiles, articles'
 * printed forms and pre-exposure, all by chance. The same seed gives the same frame. */
FRandomFrame MakeRandomChain(uint32_t Seed);

/** A scene that is made to fool the gates by content: a single toon texel at the border, a mask of one texel, light
 * that meets the threshold exactly, -0, denormal weights, light in the padding, light that overflows what is stored. */
FRandomFrame MakeFoolingFrame(uint32_t Seed);

/** Holds a frame's scene file in a folder of its own. */
class FRandomScene
{
public:
	explicit FRandomScene(FRandomFrame InFrame);

	/** Variables: "r.Name=Value". Throws FError as RunConfig does. */
	Drydock::FRunResult Run(const std::vector<std::string>& Variables, bool bNoSkip) const;

	const FRandomFrame Frame;

private:
	const FSceneFolder Folder;
};

} // namespace Stability
