// Lists the encodings of depth, normals and motion in a layer's numbers.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** The origin of a file's layers, whose conventions hold for them. */
enum class EImportOrigin
{
	Plain, // metres, world space with Z up, pixels
	Unreal,
	Blender,
	Drydock,
};

enum class EImportDepth
{
	Distance, // along the camera's axis, in units
	Ray,      // from the camera's place, in units
	Inverse,  // one by the distance
	Device,   // the engine's reversed device depth: near plane 10 cm by the distance
	Mist,     // 0..1 from a start over a range, as Blender's mist with linear falloff
};

enum class EImportNormalSpace
{
	Unreal, // left-handed, Z up
	World,  // right-handed, Z up: a scene's
	YUp,    // right-handed, Y up
	Camera, // right-handed, x right, y up, z towards the viewer
};

enum class EImportVelocity
{
	Pixels,   // movement since the last frame, y down: a scene's
	PixelsUp, // the same, y up
	Ndc,      // the same in the engine's screen position, -2..2 across, y up
	Unreal,   // a quarter of that, 0.5 where nothing moves
	Blender,  // pixels to where the point was, y up
};

enum class EImportAlpha
{
	Premultiplied,
	Straight,
	Opaque, // whatever the layer says
};

/** The metres of a unit of depth: "m", "cm", "mm", "km". */
inline double GetMetres(const std::string& Unit)
{
	return Unit == "cm" ? 0.01 : Unit == "mm" ? 0.001 : Unit == "km" ? 1000.0 : 1.0;
}

/** The inputs of Blender's mist, metres. */
struct FImportMist
{
	double Start = 0.0;
	double Depth = 25.0;
};

/** Encoding of one row; members that do not concern its channels have no effect. */
struct FImportEncoding
{
	std::string Unit = "m";
	EImportDepth Depth = EImportDepth::Distance;
	FImportMist Mist;
	EImportNormalSpace NormalSpace = EImportNormalSpace::World;
	bool bHalved = false; // normals stored as half of themselves and a half, 0..1
	EImportVelocity Velocity = EImportVelocity::Pixels;
	bool bFlipVelocity = false;
	EImportAlpha Alpha = EImportAlpha::Premultiplied;
};

/** Values that options give in place of guesses. */
struct FImportAsked
{
	std::vector<std::string> Maps; // LAYER=CHANNEL
	std::optional<EImportOrigin> Origin;
	std::optional<std::string> Unit;
	std::optional<EImportDepth> Depth;
	std::optional<FImportMist> Mist;
	std::optional<bool> bHalved;
	std::optional<EImportNormalSpace> NormalSpace;
	std::optional<EImportVelocity> Velocity;
	bool bFlipVelocity = false;
	std::optional<EImportAlpha> Alpha;
	std::vector<std::string> Toon;                 // patterns of objects' names, or stencil values
	std::vector<std::string> Stencil;              // PATTERN=VALUE
	std::optional<double> Fov;                     // horizontal, degrees
	std::optional<std::array<double, 3>> Location; // cm
	std::optional<std::array<double, 3>> Rotation; // pitch, yaw, roll, degrees
};

} // namespace Drydock
