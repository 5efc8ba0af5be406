// `drydock run` of a sequence of frames.
#pragma once

#include "Budget/RunOptions.h"

#include <string>

namespace Drydock
{

struct FFramesOptions
{
	FRunOptions Run;
	std::string OutputFolder; // empty: GetDefaultOutputFolder
	std::string Frames;       // a list of frames (FrameList.h); empty: the config's, or one frame
	bool bRestart = false;    // render frames again that are there
	int Lead = 0;             // frames before the first that are rendered for their history
	std::string Video;        // file of a video of the frames; empty: none
	bool bJson = false;
	std::string Report; // "off", "on", "full"; empty: the config's word, or by WantsReport
};

/** Runs the frames of a sequence and writes each into its folder, sequence.json, and a video where one is asked for.
 * Returns the exit code; throws FError. */
int RunFrames(const FFramesOptions& Options);

} // namespace Drydock
