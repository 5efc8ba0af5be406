// The options of `drydock run` that look inside shaders.
#pragma once

#include "Budget/RunOptions.h"
#include "Inspect/RunInspection.h"

namespace Drydock
{

class FVerbOption;
class FVerbOptions;

struct FInspectVerbOptions : FInspectOptions
{
	std::string DebugPixel; // for a debugger; empty: nobody debugs

	bool IsAsked() const { return !IsEmpty() || !DebugPixel.empty(); }
};

/** Frames: the option of sequences, which are not looked into. */
void AddInspection(FVerbOptions& Verb, FInspectVerbOptions& Options, const FVerbOption& Frames);

/** With what a debugger is to see, for which the run is planned once: its size is what the pixel counts in. Throws
 * FError (DD1020) if the pixel is outside the frame. */
FInspectOptions MakeInspectOptions(const FInspectVerbOptions& Options, const FRunOptions& Run);

} // namespace Drydock
