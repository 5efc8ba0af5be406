// Writes and reads the records of a sequence: frame.json of one frame, sequence.json of all. Nothing in them changes
// from one run to the next of the same inputs.
#pragma once

#include "Run/Run.h"
#include "Sequence/SequenceFolder.h"
#include "Run/RunInputs.h"

#include <string>
#include <vector>

namespace Drydock
{

/** The frame of a sequence, and the fingerprints by which its pictures are recognised. */
struct FFrameRecord
{
	int Frame = 0;
	int After = -1;              // the frame before it; -1: none
	std::string File;            // of the scene, as run.json names it
	std::string FileFingerprint; // of its contents
	std::string Picture;         // fingerprint of final and scene-linear picture, and of the dumps
	std::string Seen;            // fingerprint of what the frame before it left; empty: nothing
	std::string State;           // fingerprint of what lives on

	bool operator==(const FFrameRecord&) const = default;
};

/** Record of a frame that has run, without its predecessors. Must be called while its session lives: weights depend on
 * console variables. */
DRYDOCK_API FFrameRecord MakeFrameRecord(const FRunResult& Result, const std::string& FileFingerprint);

/** {frame, after?, file, fileFingerprint, location, fov?, exposure, passes, volumes: {name: weight}, picture, seen?,
 * state}. */
DRYDOCK_API std::string MakeFrameJson(const FRunResult& Result, const FFrameRecord& Record);

/** File names the text in messages. Throws FError (exit code 3) when the text is not a frame.json. */
DRYDOCK_API FFrameRecord ReadFrameRecord(const std::string& FrameJson, const std::string& File);

/** The sequence.json before the first frame: {version, config, scene, complete: false, inputs}. */
DRYDOCK_API std::string MakeSequenceHead(const FConfig& Config, const FRunInputs& Inputs);

/** Merges the files of all frames: the head, complete, and frames, each with the settings that vary. */
DRYDOCK_API std::string MakeSequenceJson(
	const FConfig& Config, const FRunInputs& Inputs, const FSequenceFolder& Folder, const std::vector<int>& Frames);

/** Whether it is that of exactly these frames, all of them there. Throws FError (exit code 3) when it is none. */
DRYDOCK_API bool IsSequenceComplete(
	const std::string& SequenceJson, const std::string& File, const std::vector<int>& Frames);

/** The inputs that a sequence.json was made from. Throws FError (exit code 3) when the text is not a sequence.json. */
DRYDOCK_API FRunInputs ReadSequenceInputs(const std::string& SequenceJson, const std::string& File);

} // namespace Drydock
