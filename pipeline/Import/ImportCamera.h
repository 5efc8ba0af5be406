// The camera of a frame, from the attributes that Unreal's movie renderers write, and as the text that a scene keeps.
#pragma once

#include "DrydockAPI.h"
#include "Import/ImportEncoding.h"

#include <array>
#include <map>
#include <optional>
#include <string>

namespace Drydock
{

/** In Unreal's axes: cm, left-handed; degrees. */
struct FImportCamera
{
	std::optional<std::array<double, 3>> Location;
	std::optional<std::array<double, 3>> Rotation; // pitch, yaw, roll
	std::optional<double> Fov;                     // horizontal, degrees
	std::optional<double> DeltaTime;               // seconds from one frame to the next
	std::string Json;                              // of a drydock scene: all it says
};

/** The camera of the attributes; values of Asked replace theirs. Keys differ between releases: any that begins with
 * "unreal/" and ends as expected is taken. */
DRYDOCK_API FImportCamera ReadImportCamera(
	const std::map<std::string, std::string>& Attributes, const FImportAsked& Asked);

/** The text of drydock:camera_json; empty where nothing is known. */
DRYDOCK_API std::string MakeCameraJson(const FImportCamera& Camera, int Width, int Height, std::optional<int> Frame);

/** Pixels of the focal length; none without a field of view. */
DRYDOCK_API std::optional<double> GetFocalLength(const FImportCamera& Camera, int Width);

/** A vector in the camera's axes (x right, y up, z towards the viewer) in the scene's world: right-handed, Z up. */
DRYDOCK_API std::array<double, 3> CameraToWorld(
	const std::array<double, 3>& Vector, const std::array<double, 3>& Rotation);

} // namespace Drydock
