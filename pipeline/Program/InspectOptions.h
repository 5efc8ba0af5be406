// The options of `drydock run` that look inside shaders.
#pragma once

#include "Budget/RunOptions.h"
#include "Inspect/RunInspection.h"

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace Drydock
{

struct FInspectVerbOptions : FInspectOptions
{
	std::string DebugPixel; // for a debugger; empty: nobody debugs

	bool IsAsked() const { return !IsEmpty() || !DebugPixel.empty(); }
};

/** Frames: the option of sequences, which are not looked into. */
void AddInspection(CLI::App& Verb, FInspectVerbOptions& Options, CLI::Option& Frames);

/** With what a debugger is to see, for which the run is planned once: its size is what the pixel counts in. Throws
 * FError (DD1020) where that is no pixel of it. */
FInspectOptions MakeInspectOptions(const FInspectVerbOptions& Options, const FRunOptions& Run);

} // namespace Drydock
