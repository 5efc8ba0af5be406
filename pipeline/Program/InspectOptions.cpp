// Names them.
#include <CLI/CLI.hpp>

#include "Program/InspectOptions.h"

#include "KernelCheck.h"
#include "Program/VerbOptions.h"
#include "Run/Run.h"

namespace Drydock
{

namespace
{

/** "nan|overflow|...|all,..." */
std::string ListChecks()
{
	std::string Names;
	for (size_t Index = 0; Index < static_cast<size_t>(ECheck::Count); ++Index)
	{
		Names += std::string(GetCheckName(static_cast<ECheck>(Index))) + "|";
	}
	return Names + "all,...";
}

} // namespace

void AddInspection(CLI::App& Verb, FInspectVerbOptions& Options, CLI::Option& Frames)
{
	const auto Group = [&Frames](CLI::Option* Option)
	{
		return Option->group("Looking inside shaders (slow: they are interpreted)")->excludes(&Frames);
	};
	CLI::Option* const Check = Group(Verb.add_option("--check", Options.Checks, "Say which line does something wrong")
										 ->delimiter(',')
										 ->type_name(ListChecks()));
	Group(AddRepeated(Verb, "--show", "X.usf:LINE[:NAME]", Options.Show,
		"Write what the line computes, or the variable there, as a picture of the whole frame; repeats"));
	Group(Verb.add_flag("--coverage", Options.bCoverage, "Count how many pixels ran each line"));
	Group(Verb.add_flag("--cost", Options.bCost, "Write taps and operations of each pixel as pictures"));
	CLI::Option* const Print =
		Group(Verb.add_flag("--print", Options.bPrint, "Print what shaders say by DrydockPrint and ShaderPrint"));
	Group(Verb.add_option("--at", Options.PrintAt, "Hear only this pixel of each pass")
			  ->delimiter(',')
			  ->type_name("X,Y")
			  ->type_size(2)
			  ->needs(Print));
	Group(
		Verb.add_option("--debug-shaders", Options.DebugPixel,
				"Run the shaders of passes once more for this pixel of the frame, or this compute thread, so that gdb "
				"can stop in their lines (docs/see-inside.md)")
			->type_name("X,Y[,Z]")
			->excludes(Check));
	Group(Verb.add_option(
				  "--passes", Options.Passes, "Look only at these, by name or by their shader's class; with * and ?")
			  ->type_name("PATTERN"));
}

FInspectOptions MakeInspectOptions(const FInspectVerbOptions& Options, const FRunOptions& Run)
{
	FInspectOptions Made = Options;
	if (!Options.DebugPixel.empty())
	{
		FRunOptions Plan = Run;
		Plan.bExecute = false;
		Plan.Progress = nullptr;
		const FIntRect View = RunConfig(Plan).ViewRect;
		Made.Debug = MakeDebugRequest(Options.DebugPixel, Options.Passes, {View.Width(), View.Height()});
	}
	return Made;
}

} // namespace Drydock
