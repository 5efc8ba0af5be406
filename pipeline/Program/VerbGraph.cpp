// `drydock graph`. Source: drydock.
#include "ChildProcess.h"
#include "Program/Verbs.h"
#include "RenderGraphDump.h"
#include "Run/GraphJson.h"
#include "Run/Run.h"
#include "Text/ConfigErrors.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <unistd.h>

namespace Drydock
{

namespace
{

/** Removes a file when it goes out of scope. */
struct FTemporaryFile
{
	explicit FTemporaryFile(const std::string& Suffix)
		: Path((std::filesystem::temp_directory_path() / ("drydock." + std::to_string(getpid()) + Suffix)).string())
	{
	}
	~FTemporaryFile()
	{
		std::error_code Ignored;
		std::filesystem::remove(Path, Ignored);
	}

	const std::string Path;
};

/** Layout by Graphviz's dot, where it is installed. */
std::string MakeSvg(const std::string& Dot)
{
	constexpr int TimeLimitSeconds = 60;
	const FTemporaryFile Input(".dot");
	const FTemporaryFile Output(".svg");
	std::ofstream(Input.Path, std::ios::binary) << Dot;
	const FChildResult Child = RunChild({"dot", "-Tsvg", Input.Path, "-o", Output.Path}, TimeLimitSeconds);
	if (!Child.Succeeded())
	{
		FDiagnostic Diagnostic;
		Diagnostic.Code = ErrorFileNotWritten;
		Diagnostic.Message = "the SVG needs Graphviz: the program dot " +
							 (Child.bStarted ? Child.Describe(TimeLimitSeconds) : std::string("is not installed")) +
							 "; --format dot needs nothing";
		throw FError(Diagnostic, ExitFiles);
	}
	std::ifstream Stream(Output.Path, std::ios::binary);
	return std::string(std::istreambuf_iterator<char>(Stream), {});
}

} // namespace

int GraphVerb(const FVerbOptions& Options)
{
	FRunOptions RunOptions = Options.Run;
	RunOptions.bExecute = false;
	const FRunResult Result = RunConfig(RunOptions);
	PrintDiagnostics(Result.Diagnostics);
	const std::string Format = Options.bJson ? "json" : Options.Format;
	const std::string Text = Format == "json"  ? MakeGraphJson(Result.Graph)
							 : Format == "dot" ? DumpDot(Result.Graph)
							 : Format == "svg" ? MakeSvg(DumpDot(Result.Graph))
											   : DumpText(Result.Graph);
	std::fputs(Text.c_str(), stdout);
	for (const std::string& Line : MakeClosingLines(Result.Effects))
	{
		std::fprintf(stderr, "%s\n", Line.c_str());
	}
	return ExitDone;
}

} // namespace Drydock
