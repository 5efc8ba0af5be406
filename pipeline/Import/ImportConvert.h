// Converts a layer's numbers to a scene's: the formulas, one per kind of channel, and the scene that a plan gives.
#pragma once

#include "Diagnostics.h"
#include "Import/ImportCamera.h"
#include "Import/ImportObjects.h"
#include "Import/ImportPlanes.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** Metres that mean "no surface" in depth.Z: the greatest half. */
constexpr float NoSurfaceDepth = 65504.0f;

struct FImportPixel
{
	int X = 0;
	int Y = 0;
	int Width = 0;
	int Height = 0;
};

/** Metres along the camera's axis; none where there is no surface (not finite, not above 0, 65504 as it stands or in
 * metres). FocalLength: pixels, for rays. */
DRYDOCK_API std::optional<float> ConvertDepth(
	float Value, const FImportEncoding& Encoding, const FImportPixel& Pixel, double FocalLength);

/** Unit length, right-handed, Z up; 0 where there is no surface. Rotation: of the camera. */
DRYDOCK_API std::array<float, 3> ConvertNormal(
	const std::array<float, 3>& Value, const FImportEncoding& Encoding, const std::array<double, 3>& Rotation);

/** Pixels since the last frame, y down. */
DRYDOCK_API std::array<float, 2> ConvertVelocity(
	const std::array<float, 2>& Value, const FImportEncoding& Encoding, int Width, int Height);

/** A channel of the scene. */
struct FImportChannelPlane
{
	std::string Name;
	std::vector<float> Values;
};

struct FImportScene
{
	int Width = 0;
	int Height = 0;
	std::vector<FImportChannelPlane> Channels;
	std::string CameraJson;

	/** Null where it has none. */
	DRYDOCK_API const std::vector<float>* Find(const std::string& Name) const;
};

/** Decides by the numbers what names cannot show of encodings: whether normals are halved, whether velocities are
 * around 0.5. Values in Asked take precedence. */
DRYDOCK_API void LookAtValues(
	FImportPlan& Plan, const FImportPlanes& Planes, const FImportAsked& Asked, std::vector<FDiagnostic>& Diagnostics);

/** Converts all channels. Changes that were necessary are appended to Diagnostics. Throws FError (exit code 2) where
 * rays are asked for and the field of view is not known. */
DRYDOCK_API FImportScene ConvertImport(const FImportLayers& Layers, const FImportPlan& Plan,
	const FImportPlanes& Planes, const FImportChoices& Choices, const FImportCamera& Camera,
	std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
