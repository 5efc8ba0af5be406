// Numbers the messages about the contents of a scene. docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum ESceneError
{
	NoteDisplayWindow = 5033, // an EXR's data window is not its display window, which is the picture
	WarnRawRender = 5034,     // a scene of several layers, none of which has a name that drydock knows
	WarnNoCustomDepth = 5032, // a pass reads custom depth or stencil, and the scene has none
};

} // namespace Drydock
