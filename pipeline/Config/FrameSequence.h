// Scene files that are a frame each: "scenes/walk.####.exr" stands for walk.0001.exr, walk.0002.exr and so on, as far
// as they exist. The notation is the usual one of renderers.
#pragma once

#include "Config/Config.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

struct FSequenceFrame
{
	int Number = 0;
	std::string Path;

	bool operator==(const FSequenceFrame&) const = default;
};

/** Whether the file's name has a row of #. */
DRYDOCK_API bool IsFrameSequence(const std::string& Path);

/** The frames that exist, by number. The last row of # in the file's name stands for a number with that many digits,
 * filled with zeros, or with more digits. */
DRYDOCK_API std::vector<FSequenceFrame> FindSequenceFrames(const std::string& Pattern);

/** Replaces a scene that is a sequence by the file of that frame; the default is the first of scene.frames, else the
 * lowest. The pattern remains in Scene.Sequence, the number in Scene.Frame. Throws FError (exit code 3) when there is
 * no such frame. */
DRYDOCK_API void ChooseSceneFrame(FConfig& Config, std::optional<int> Frame);

/** The frames of a config that has chosen one already, as a list names them (FrameList.h); Place: where the list
 * stands, for messages. Throws FError: the scene is not a sequence, or the list is not a list (exit code 2); a frame
 * does not exist (3).
 * */
DRYDOCK_API std::vector<FSequenceFrame> ChooseSequenceFrames(
	const FConfig& Config, const std::string& List, const FConfigPlace& Place);

/** The frames of the config's scene before the first of Frames, at the distance of the first two; ascending. */
DRYDOCK_API std::vector<FSequenceFrame> FindFramesBefore(
	const FConfig& Config, const std::vector<FSequenceFrame>& Frames);

} // namespace Drydock
