// Pictures to a video, by ffmpeg where that is installed.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** PNG files of one size, each a frame, to a file whose name says what kind it is (.mp4: H.264). It appears when it is
 * complete. Returns why there is none, in a sentence without a full stop; empty: there is one. */
DRYDOCK_API std::string MakeVideo(
	const std::vector<std::string>& Pictures, double FramesPerSecond, const std::string& File);

} // namespace Drydock
