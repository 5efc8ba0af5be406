// Runs the frames of a sequence one after another, each in a folder of its own, and hands on the state between them. A
// run that was stopped, whenever it was, is taken up again where it stood: the finished frames stay as they are, those
// that are not as they were written are rendered again, and the rest is bit for bit what an undisturbed run writes.
#pragma once

#include "Budget/RunOptions.h"
#include "Diagnostics.h"

#include <functional>
#include <string>
#include <vector>

namespace Drydock
{

struct FSequenceResult
{
	std::vector<int> Frames;
	int NumRendered = 0; // the others were there already
	/** Frames that had to run again for the history they leave: nothing of them was written. */
	int NumRepeated = 0;
	double Seconds = 0.0;              // of the frames rendered or repeated, writing included
	double FramesPerSecond = 0.0;      // of the scene, in its own time
	std::vector<std::string> Pictures; // final.png of each frame
	std::string SequenceJson;
};

struct FSequenceOptions
{
	FRunOptions Run;       // Frame is not looked at
	std::string Frames;    // a list (FrameList.h); empty: the config's scene.frames
	int Lead = 0;          // so many frames before the first are rendered for their history, and not written
	std::string Folder;    // of the sequence (SequenceFolder.h)
	bool bRestart = false; // render all frames again, whatever the folder holds
	/** Called before each pass and after each frame. Done and Total count frames; the text is "frame 3: Tonemap". */
	std::function<void(int Done, int Total, const std::string& What)> Progress;
	/** Called with what each frame that is rendered reports, with why frames are rendered again (DD1073), and with what
	 * the first frame lacks of its history (DD1074). */
	std::function<void(const std::vector<FDiagnostic>&)> Report;
	/** The text of sequence.html, called when all frames are there; none: it is not written. */
	std::function<std::string(const FSequenceResult& Result)> MakePage;
};

/** Throws FError: as RunConfig; the scene is not a sequence or a frame does not exist; the folder holds a sequence of
 * other inputs (DD1070, exit code 2), is in use or cannot be written (3); a repeated frame is not what it was (DD1071,
 * 2). */
DRYDOCK_API FSequenceResult RunSequence(const FSequenceOptions& Options);

} // namespace Drydock
