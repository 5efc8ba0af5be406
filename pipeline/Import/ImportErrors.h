// The numbers of the messages of `drydock import`. docs/errors.md explains each one.
#pragma once

namespace Drydock
{

enum EImportError
{
	ErrorImportOption = 1090,     // an option that names no layer, channel or object of these files, or no such value
	WarnImportAmbiguous = 1091,   // several layers could be one channel: which is taken
	WarnImportMissing = 1093,     // a channel that effects read, and no layer for it
	WarnImportImplausible = 1094, // values that a frame in these units hardly has
	ErrorImportNoColor = 1095,    // no layer is the frame's colour
	ErrorImportSizes = 1096,      // layers of different pictures
	NoteImportConfigKept = 1097,  // a config of that name is there already and stays
	NoteImportChanged = 1098,     // what was changed besides units: cropped, filled, not finite

	ErrorImportInTheWay = 5030, // what stands where the scene goes is none that import wrote
	ErrorImportFrames = 5031,   // frames of a sequence that lack a file, or have other layers than the first
};

} // namespace Drydock
