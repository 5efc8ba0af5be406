// `drydock explain`. Source: drydock.
#include "Program/ProgressBar.h"
#include "Program/Verbs.h"
#include "Run/Explain.h"

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace Drydock
{

namespace
{

/** Runs of each kind, interleaved, after one that warms up. */
constexpr int NumMeasurements = 7;

FRunResult CompileFrame(FRunOptions Options, bool bNoSkip)
{
	Options.bExecute = false;
	Options.bPlanLoads = true;
	Options.bNoSkip = bNoSkip;
	return RunConfig(Options);
}

/** Milliseconds of one pass in several runs. */
using FSamples = std::vector<std::pair<int, std::vector<double>>>;

void AddSamples(const FRunResult& Result, FSamples& Samples)
{
	for (const FRunPass& Pass : Result.Passes)
	{
		auto Known = std::find_if(
			Samples.begin(), Samples.end(), [&](const auto& Sample) { return Sample.first == Pass.Index; });
		if (Known == Samples.end())
		{
			Known = Samples.insert(Samples.end(), {Pass.Index, {}});
		}
		Known->second.push_back(Pass.Milliseconds);
	}
}

FMeasuredPasses TakeMedians(FSamples Samples)
{
	FMeasuredPasses Medians;
	for (auto& [Index, Values] : Samples)
	{
		std::sort(Values.begin(), Values.end());
		Medians.push_back({Index, Values[Values.size() / 2]});
	}
	return Medians;
}

FExplainReport MeasureFrame(const FVerbOptions& Options, FCostModel& Model)
{
	FProgressBar Bar;
	FSamples Samples[2];
	FRunResult Last[2];
	for (int Repetition = 0; Repetition <= NumMeasurements; ++Repetition)
	{
		for (const bool bNoSkip : {false, true})
		{
			Bar.Show(2 * Repetition + bNoSkip, 2 * NumMeasurements + 2, bNoSkip ? "with --no-skip" : "as it is");
			FRunOptions RunOptions = Options.Run;
			RunOptions.bNoSkip = bNoSkip;
			Last[bNoSkip] = RunConfig(RunOptions);
			if (Repetition > 0) // the first run warms up
			{
				AddSamples(Last[bNoSkip], Samples[bNoSkip]);
			}
		}
	}
	Bar.Clear();
	Model.Learn(Last[0]);
	Model.Learn(Last[1]);
	Model.Save();
	const FMeasuredPasses Frame = TakeMedians(std::move(Samples[0]));
	const FMeasuredPasses NoSkip = TakeMedians(std::move(Samples[1]));
	PrintDiagnostics(Last[0].Diagnostics);
	return MakeExplainReport(Last[0], Last[1], Model, &Frame, &NoSkip);
}

FExplainReport EstimateFrame(const FVerbOptions& Options, const FCostModel& Model)
{
	const FRunResult Frame = CompileFrame(Options.Run, false);
	PrintDiagnostics(Frame.Diagnostics);
	return MakeExplainReport(Frame, CompileFrame(Options.Run, true), Model);
}

} // namespace

int ExplainVerb(const FVerbOptions& Options)
{
	FCostModel Model = FCostModel::Load();
	const FExplainReport Report = Options.bMeasure ? MeasureFrame(Options, Model) : EstimateFrame(Options, Model);
	std::string Text;
	if (Options.bJson)
	{
		Text = MakeExplainJson(Report);
	}
	else if (!Options.Pass.empty())
	{
		Text = MakePassText(Report, Options.Pass);
	}
	else if (!Options.Effect.empty())
	{
		Text = MakeEffectText(Report, Options.Effect);
	}
	else
	{
		Text = MakeExplainText(Report, IsColorful(STDOUT_FILENO));
	}
	std::fputs(Text.c_str(), stdout);
	return ExitDone;
}

} // namespace Drydock
