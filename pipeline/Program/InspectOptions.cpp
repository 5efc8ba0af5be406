// Names them.
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

void AddInspection(FVerbOptions& Verb, FInspectVerbOptions& Options, const FVerbOption& Frames)
{
	const auto Group = [&Frames](const FVerbOption& Option)
	{
		return Option.SetGroup("Looking inside shaders (slow: they are interpreted)").Exclude(Frames);
	};
	const FVerbOption Check =
		Group(Verb.Add("--check", Options.Checks, "Report the shader lines that do something wrong")
				  .SplitAtCommas()
				  .SetType(ListChecks()));
	Group(Verb.AddRepeated("--show", "X.usf:LINE[:NAME]", Options.Show,
		"Write the value that the line computes, or a variable there, as a picture of the whole frame; repeats"));
	Group(Verb.AddFlag("--coverage", Options.bCoverage, "Count how many pixels ran each line"));
	Group(Verb.AddFlag("--cost", Options.bCost, "Write taps and operations of each pixel as pictures"));
	Group(Verb.AddFlag(
		"--ranges", Options.bRanges, "Print the smallest and the largest value of every variable by line"));
	Group(Verb.AddFlag("--check-all-threads", Options.bAllThreads,
		"Let --check and --ranges look at every thread, not at a sample of each pass"));
	const FVerbOption Print = Group(
		Verb.AddFlag("--print", Options.bPrint, "Print the values that shaders pass to DrydockPrint and ShaderPrint"));
	Group(Verb.Add("--at", Options.PrintAt, "Print only for this pixel").SplitAtCommas(2).SetType("X,Y").Need(Print));
	Group(Verb.Add("--debug-shaders", Options.DebugPixel,
				  "Run the shaders again for this pixel of the frame, or this compute thread, so that gdb can stop in "
				  "them (docs/see-inside.md)")
			  .SetType("X,Y[,Z]")
			  .Exclude(Check));
	Group(Verb.Add("--pass", Options.Passes, "Look only at these passes, by name or shader class; with * and ?")
			  .SetType("PATTERN"));
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
