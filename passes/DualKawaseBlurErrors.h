// The numbered remarks of the dual Kawase blur. Docs: docs/errors.md. Source: drydock.
#pragma once

namespace Drydock
{

enum EDualKawaseNote : int
{
	DualKawaseNoteLevels = 2080,      // fewer levels than wanted: the picture is too small
	DualKawaseNotePrintedLoss = 2081, // rows and columns that the article's form loses
	DualKawaseNoteBlocky = 2082,      // an offset that shows as blocks
	DualKawaseNoteWidth = 2083,       // a standard deviation that no levels and offset give
};

} // namespace Drydock
