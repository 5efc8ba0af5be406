// The numbers of the messages about sequences of frames; docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum ESequenceError
{
	ErrorSequenceChanged = 1070,       // the folder holds a sequence made of other inputs
	ErrorSequenceNotRepeatable = 1071, // a frame computed again is not the one that was written
	WarnNoVideo = 1072,                // frames are there, but no video could be made of them
	WarnFrameDamaged = 1073,           // a finished frame is not as it was written, and is rendered again
	NoteNoHistory = 1074,              // the first frame lacks what the frames before it would leave

	ErrorStateBroken = 5020,    // what lives on from a frame cannot be read
	ErrorSequenceBroken = 5022, // sequence.json of the folder cannot be read
};

} // namespace Drydock
