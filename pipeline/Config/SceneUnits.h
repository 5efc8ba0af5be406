// Units of a scene file's channels. See configs/scenes/README.md.
#pragma once

namespace Drydock
{

struct FSceneUnits
{
	bool bDepthInCentimetres = false; // else metres
	bool bVelocityIsNdc = false;      // screen position -2..2, y up; else pixels per frame, y down
	bool bNormalIsLeftHanded = false; // the engine's axes; else Y points the other way
};

} // namespace Drydock
