// `drydock trace`: what a shader did for one pixel, line by line.
#include "Inspect/TraceCapture.h"
#include "PrintText.h"
#include "Program/NumberList.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Run/Run.h"
#include "Text/ConfigErrors.h"
#include "TextTools.h"

#include <cstdio>
#include <memory>

namespace Drydock
{

namespace
{

struct FTraceVerbOptions
{
	FRunOptions Run;
	FTraceRequest Request;
	std::string Pixel;
	std::string Thread;
	bool bJson = false;
};

/** "X,Y" or "X,Y,Z" */
std::array<int32_t, 3> ParsePixel(const std::string& Text, bool bThread)
{
	const std::vector<int32_t> Numbers = ParseList<int32_t>(Text);
	if (Numbers.size() < 2 || Numbers.size() > 3)
	{
		throw BadArgument(
			"'" + Text + "' is not a " + (bThread ? "thread" : "pixel") + "; expected X,Y as in 100,50, or X,Y,Z",
			bThread ? "--thread" : "--pixel");
	}
	return {Numbers[0], Numbers[1], Numbers.size() > 2 ? Numbers[2] : 0};
}

int Trace(FTraceVerbOptions Options)
{
	Options.Request.bThread = !Options.Thread.empty();
	if (Options.Request.bThread != Options.Pixel.empty())
	{
		throw BadArgument("expected one of --pixel, a texel that the pass writes, and --thread, a compute thread's id",
			Options.Request.bThread ? "--thread" : "--pixel");
	}
	Options.Request.At = ParsePixel(Options.Request.bThread ? Options.Thread : Options.Pixel, Options.Request.bThread);
	FTraceCapture Capture(Options.Request);
	{
		const FScopedDispatchObserver Scope(Capture);
		PrintDiagnostics(RunConfig(Options.Run).Diagnostics);
	}
	const std::vector<FCapturedTrace>& Traces = Capture.GetTraces();
	if (Options.bJson)
	{
		PrintText(stdout, MakeTraceJson(Traces, Options.Request));
		return ExitDone;
	}
	for (const FCapturedTrace& Captured : Traces)
	{
		PrintResult((&Captured == &Traces.front() ? "" : "\n") + MakeTraceText(Captured, Options.Request));
	}
	return ExitDone;
}

} // namespace

FVerbCall AddTraceOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FTraceVerbOptions>();
	AddConfig(Verb, Options->Run);
	AddThreads(Verb, Options->Run, "Number of threads for the passes before; 0: all cores");
	Verb.Add("--pass", Options->Request.Pass, "Choose the pass by its name or its shader's class; with * and ?")
		.SetType("PATTERN")
		.Require();
	Verb.Add("--pixel", Options->Pixel, "Texel that the pass writes; of a compute pass, the thread that stored to it")
		.SetType("X,Y");
	Verb.Add("--thread", Options->Thread, "Compute thread, by its dispatch id, in place of --pixel").SetType("X,Y,Z");
	Verb.Add("--bound", Options->Request.Bound,
			"Mark lines where float and double differ by more than this, relative to the value or to 1; 0.001 by "
			"default")
		.RequireNonNegative()
		.SetType("X");
	Verb.AddFlag("--json", Options->bJson, "Print JSON, with every iteration of every loop");
	return CallWith(Options, Trace);
}

} // namespace Drydock
