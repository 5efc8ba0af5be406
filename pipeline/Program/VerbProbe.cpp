// `drydock probe`: a pixel's value through all passes of a run.
#include "Inspect/ProbeRun.h"
#include "Program/NumberList.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"

#include <memory>

namespace Drydock
{

namespace
{

struct FProbeVerbOptions
{
	FRunOptions Run;
	FProbeRequest Request;
	std::vector<int> Pixel;
	std::vector<int> Region;
	std::string Against; // a config, or settings and variables
	bool bJson = false;
};

/** The run's own options, with another config or another value. */
FRunOptions MakeAgainst(const FProbeVerbOptions& Options)
{
	FRunOptions Other = Options.Run;
	const size_t Equals = Options.Against.find('=');
	if (Equals == std::string::npos)
	{
		Other.ConfigFile = Options.Against;
	}
	else if (Options.Against.substr(0, Equals).find('.') != std::string::npos)
	{
		Other.Variables.push_back(Options.Against);
	}
	else
	{
		Other.Settings.push_back(Options.Against);
	}
	return Other;
}

std::vector<FProbePass> ProbeAndTell(const FRunOptions& Run, FProbeRequest& Request)
{
	FProbedRun Probed = ProbeRun(Run, Request);
	PrintDiagnostics(Probed.Diagnostics);
	return std::move(Probed.Passes);
}

int Probe(FProbeVerbOptions Options)
{
	Options.Request.X = Options.Pixel.at(0);
	Options.Request.Y = Options.Pixel.at(1);
	Options.Request.Width = Options.Region.empty() ? 1 : Options.Region.at(0);
	Options.Request.Height = Options.Region.empty() ? 1 : Options.Region.at(1);
	const std::vector<FProbePass> Passes = ProbeAndTell(Options.Run, Options.Request);
	FProbeRequest Other = Options.Request; // its frame may be of another size
	const std::vector<FProbePass> Against =
		Options.Against.empty() ? std::vector<FProbePass>() : ProbeAndTell(MakeAgainst(Options), Other);
	const std::string Text = Options.bJson ? MakeProbeJson(Passes, Against, Options.Request)
										   : MakeProbeText(Passes, Against, Options.Request);
	PrintResult(Text, Options.bJson);
	return ExitDone;
}

} // namespace

FVerbCall AddProbeOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FProbeVerbOptions>();
	AddConfig(Verb, Options->Run);
	AddThreads(Verb, Options->Run, "Number of threads for the passes; 0: all cores (default)");
	Verb.Add("pixel", Options->Pixel, "Pixel of the final frame").SplitAtCommas(2).SetType("X,Y").Require();
	Verb.Add("--region", Options->Region, "Size of a region that begins at X,Y; 1,1 by default")
		.SplitAtCommas(2)
		.SetType("W,H");
	Verb.Add("--pass", Options->Request.Passes, "Print only these passes, by name or shader class; with * and ?")
		.SetType("PATTERN");
	Verb.Add("--against", Options->Against,
			"Run again with another config, setting (BloomIntensity=1) or variable (r.Name=1), and show where the two "
			"runs differ")
		.SetType("WHAT");
	Verb.AddFlag("--json", Options->bJson, "Print JSON, with all texels read");
	return CallWith(Options, Probe);
}

} // namespace Drydock
