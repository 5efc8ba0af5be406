// Pictures to a video, by ffmpeg where that is installed.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** PNG files of one size, each a frame, to a file whose name gives the format (.mp4: H.264). The file appears when it
 * is complete. Returns the problem, in a sentence without a full stop; empty on success. */
DRYDOCK_API std::string MakeVideo(
	const std::vector<std::string>& Pictures, double FramesPerSecond, const std::string& File);

} // namespace Drydock
