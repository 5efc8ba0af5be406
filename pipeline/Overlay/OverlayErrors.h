// The numbers of the messages about engine overlays. docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum EOverlayError
{
	ErrorOverlayFolder = 1130,  // a folder that does not exist, or has nothing of an overlay in it
	ErrorOverlayPlace = 1131,   // a PostProcessing.cpp without a block that a place of the chain takes, or with two
	ErrorOverlaySetting = 1132, // a setting of Scene.h that cannot be added
	ErrorOverlaysClash = 1133,  // two overlays fill the same place, and neither stands over the other
	ErrorOverlayRefused = 1134, // one with C++ in a run without plugins
	NoteOverlayUnused = 1135,   // files of an overlay that nothing here reads
	NoteOverlay = 1136,         // what an overlay replaces
	NoteOverlayNotUsed = 1137,  // what of that a frame had no use for, and why
};

} // namespace Drydock
