// The numbered remarks of the dual Kawase blur. Docs: docs/errors.md.
#pragma once

namespace Drydock
{

enum EDualKawaseNote : int
{
	DualKawaseNoteLevels = 2090,      // fewer levels than wanted: the picture is too small
	DualKawaseNotePrintedLoss = 2091, // rows and columns that the article's form loses
	DualKawaseNoteBlocky = 2092,      // an offset that shows as blocks
	DualKawaseNoteWidth = 2093,       // a standard deviation that no levels and offset give
	DualKawaseNoteDirect = 2094,      // a direct Gaussian of so many taps that it takes minutes
};

} // namespace Drydock
