// `drydock graph`: prints the compiled graph of a config without running it.
#include "ChildProcess.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "RenderGraphDump.h"
#include "Run/GraphJson.h"
#include "Run/Run.h"
#include "TemporaryFolder.h"
#include "Text/ConfigErrors.h"
#include "Text/TextFile.h"

#include <memory>

namespace Drydock
{

namespace
{

struct FGraphOptions
{
	FRunOptions Run;
	std::string Format = "text"; // or dot, svg, json
	bool bJson = false;          // the same as json
};

/** Layout by Graphviz's dot, where it is installed. */
std::string MakeSvg(const std::string& Dot)
{
	constexpr int TimeLimitSeconds = 60;
	const FTemporaryFolder Folder;
	const std::string Input = Folder.WriteFile("graph.dot", Dot);
	const std::string Output = Folder.Reserve("graph.svg");
	const FChildResult Child = RunChild({"dot", "-Tsvg", Input, "-o", Output}, TimeLimitSeconds);
	if (!Child.Succeeded())
	{
		const std::string Why = Child.bStarted ? Child.Describe(TimeLimitSeconds) : "is not installed";
		throw FError({.Code = ErrorFileNotWritten,
						 .Message = "the SVG needs Graphviz: the program dot " + Why + "; --format dot needs nothing"},
			ExitFiles);
	}
	return ReadTextFile(Output, "cannot be read", MaxBinaryBytes);
}

int PrintGraph(const FGraphOptions& Options)
{
	FRunOptions RunOptions = Options.Run;
	RunOptions.bExecute = false;
	RunOptions.bPassValues = true;
	const FRunResult Result = RunConfig(RunOptions);
	PrintDiagnostics(Result.Diagnostics);
	const std::string Format = Options.bJson ? "json" : Options.Format;
	std::map<int, std::string> Values;
	for (const auto& [Index, OfPass] : Result.PassValues)
	{
		Values[Index] = FormatPassValues(OfPass);
	}
	const std::string Text = Format == "json"  ? MakeGraphJson(Result.Graph, Result.PassValues)
							 : Format == "dot" ? DumpDot(Result.Graph)
							 : Format == "svg" ? MakeSvg(DumpDot(Result.Graph))
											   : DumpText(Result.Graph, Values);
	PrintResult(Text, Format != "text");
	PrintClosingLines(Result.Effects);
	return ExitDone;
}

} // namespace

FVerbCall AddGraphOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FGraphOptions>();
	AddConfig(Verb, Options->Run);
	AddArithmetic(Verb, Options->Run);
	Verb.Add("--format", Options->Format, "Format of the graph; text by default; svg needs Graphviz")
		.RequireOneOf({"text", "dot", "svg", "json"});
	Verb.AddFlag("--json", Options->bJson, "Print JSON, as --format json does");
	return CallWith(Options, PrintGraph);
}

} // namespace Drydock
