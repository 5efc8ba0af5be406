// Runs the frames of a sequence, beside those of its truth, and measures how the picture and the effects flicker.
#pragma once

#include "Budget/RunOptions.h"
#include "Diagnostics.h"
#include "Flicker/FlickerFigures.h"

#include <functional>
#include <string>
#include <vector>

namespace Drydock
{

/** "picture": the final picture, whose luminances are codes of 0 to 255. Else an effect's name: what its last pass
 * wrote, times the exposure, so that 1 is white paper as displayed. */
struct FFlickerRow
{
	std::string Name;
	FFlickerFigures Figures;
};

/** One way to run the sequence. */
struct FFlickerVariant
{
	std::string Name;                   // "as the config is", or its variables
	std::vector<std::string> Variables; // "r.Name=Value"
	std::vector<FFlickerRow> Rows = {}; // the result: the picture, and the effects in the order of their passes
};

struct FFlickerOptions
{
	FRunOptions Run;    // Frame is not looked at
	std::string Frames; // a list (FrameList.h); empty: the config's scene.frames
	/** Pattern of the frames without aliasing, relative to the config; empty: NAME.truth.####.exr beside NAME.####.exr
	 * where it exists. */
	std::string Truth;
	std::vector<FFlickerVariant> Variants; // one at least
	std::function<void(int Done, int Total, const std::string& What)> Progress;
};

struct FFlickerResult
{
	std::vector<int> Frames;
	std::string Truth; // pattern; empty: there is none
	std::vector<FFlickerVariant> Variants;
	std::vector<std::string> Unmeasured;  // effects that ran and that the truth's run does not have
	std::vector<FDiagnostic> Diagnostics; // of the variants' runs, each once
};

/** Throws FError: as RunConfig; the scene is not a sequence, or has fewer frames than a figure needs (exit code 2); a
 * frame of the truth is missing (3). */
DRYDOCK_API FFlickerResult MeasureFlicker(const FFlickerOptions& Options);

} // namespace Drydock
