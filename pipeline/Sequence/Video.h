// Pictures to a video, by ffmpeg where that is installed.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Makes a video from PNG files of one size, each a frame; the file's extension chooses its kind (.mp4: H.264). The
 * file appears when it is complete. Returns the reason of a failure, in a sentence without a full stop; empty: the file
 * was made. */
DRYDOCK_API std::string MakeVideo(
	const std::vector<std::string>& Pictures, double FramesPerSecond, const std::string& File);

} // namespace Drydock
