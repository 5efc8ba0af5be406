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

/** Makes the options, with the pixel that a debugger is to see. For this the run is planned once, because the pixel
 * counts in the run's size. Throws FError (DD1020) if the run has no such pixel. */
FInspectOptions MakeInspectOptions(const FInspectVerbOptions& Options, const FRunOptions& Run);

} // namespace Drydock
