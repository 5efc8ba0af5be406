// A scene file in a folder of its own, for tests that run small frames.
#pragma once

#include "Picture/Picture.h"

#include <filesystem>
#include <string>
#include <vector>

namespace Stability
{

/** Makes a folder among the temporary files and writes `scene.exr` into it, with a camera of the picture's size. The
 * folder goes with the object. With DRYDOCK_RANDOM_KEEP it stays, and its path is printed. */
class FSceneFolder
{
public:
	/** Picture: linear values, one for each of Channels, by pixel. Throws where the folder cannot be written. */
	FSceneFolder(const Drydock::FImage& Picture, const std::vector<std::string>& Channels);
	~FSceneFolder();
	FSceneFolder(const FSceneFolder&) = delete;
	FSceneFolder& operator=(const FSceneFolder&) = delete;

	const std::filesystem::path Path;
};

} // namespace Stability
