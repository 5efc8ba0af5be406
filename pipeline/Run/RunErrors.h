// The numbers of the messages about the passes of a run and the shaders of its plugins. A number never changes its
// meaning; docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum ERunError
{
	NoteSilentPass = 4004,    // a pass wrote again what it read
	WarnUnwrittenRead = 4006, // a pass depends on texels that nothing wrote

	NoteShaderNotLookedAt = 6013, // permutations of a plugin's class, or a pass that does not tell its shader
	WarnShader = 6024,            // the front end's own warnings about a shader that drydock does not ship
};

} // namespace Drydock
