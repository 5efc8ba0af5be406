// `drydock explain`: prints which effects and passes run, which do not and why, and what leaving out saves.
#include "Program/ProgressBar.h"
#include "Program/ProgramOutput.h"
#include "Program/SettingStory.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Run/Explain.h"

#include <algorithm>
#include <memory>
#include <unistd.h>

namespace Drydock
{

namespace
{

struct FExplainOptions
{
	FRunOptions Run;
	std::string Pass;               // only this one, by name or index; empty: all
	std::string Effect;             // only this one; empty: all
	std::vector<std::string> Names; // settings whose story is told, in place of everything else
	bool bMeasure = false;          // run the frame, with and without skipping
	bool bJson = false;
};

/** Runs of each kind, interleaved, after one that warms up. */
constexpr int NumMeasurements = 7;

FRunResult CompileFrame(FRunOptions Options, bool bNoSkip)
{
	Options.bExecute = false;
	Options.bPlanLoads = true;
	Options.bPassValues = true;
	Options.bNoSkip = bNoSkip;
	return RunConfig(Options);
}

/** Milliseconds of one pass in several runs. */
using FSamples = std::vector<std::pair<int, std::vector<double>>>;

void AddSamples(const FRunResult& Result, FSamples& Samples)
{
	for (const FRunPass& Pass : Result.Passes)
	{
		auto Known = std::ranges::find_if(Samples, [&](const auto& Sample) { return Sample.first == Pass.Index; });
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
		std::ranges::sort(Values);
		Medians.push_back({Index, Values[Values.size() / 2]});
	}
	return Medians;
}

FExplainReport MeasureFrame(const FExplainOptions& Options, FCostModel& Model)
{
	FProgressBar Bar;
	FSamples Samples[2];
	FRunResult Last[2];
	std::vector<double> Savings; // of each pair
	for (int Repetition = 0; Repetition <= NumMeasurements; ++Repetition)
	{
		for (const bool bNoSkip : {false, true})
		{
			Bar.Show(2 * Repetition + bNoSkip, 2 * NumMeasurements + 2, bNoSkip ? "with --no-skip" : "as it is");
			FRunOptions RunOptions = Options.Run;
			RunOptions.bNoSkip = bNoSkip;
			RunOptions.bPassValues = true;
			Last[bNoSkip] = RunConfig(RunOptions);
			if (Repetition > 0) // the first run warms up
			{
				AddSamples(Last[bNoSkip], Samples[bNoSkip]);
			}
		}
		if (Repetition > 0)
		{
			Savings.push_back(Last[1].Times.Execute - Last[0].Times.Execute);
		}
	}
	Bar.Clear();
	Model.Learn(Last[0]);
	Model.Learn(Last[1]);
	Model.Save();
	const FMeasuredPasses Frame = TakeMedians(std::move(Samples[0]));
	const FMeasuredPasses NoSkip = TakeMedians(std::move(Samples[1]));
	PrintDiagnostics(Last[0].Diagnostics);
	FExplainReport Report = MakeExplainReport(Last[0], Last[1], Model, &Frame, &NoSkip);
	Report.Saved = MakeMeasuredSaving(std::move(Savings));
	return Report;
}

FExplainReport EstimateFrame(const FExplainOptions& Options, const FCostModel& Model)
{
	const FRunResult Frame = CompileFrame(Options.Run, false);
	PrintDiagnostics(Frame.Diagnostics);
	return MakeExplainReport(Frame, CompileFrame(Options.Run, true), Model);
}

int Explain(const FExplainOptions& Options)
{
	if (!Options.Names.empty())
	{
		FBlendOptions Blend;
		Blend.Run = Options.Run;
		Blend.Names = Options.Names;
		Blend.bJson = Options.bJson;
		return PrintSettingStory(Blend);
	}
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
		Text = MakeEffectText(Report, Options.Effect, GetOutputWidth());
	}
	else
	{
		Text = MakeExplainText(Report, IsColorful(STDOUT_FILENO), GetOutputWidth());
	}
	PrintResult(Text, Options.bJson);
	return ExitDone;
}

} // namespace

FVerbCall AddExplainOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FExplainOptions>();
	AddConfig(Verb, Options->Run);
	AddArithmetic(Verb, Options->Run);
	const FVerbOption Pass =
		Verb.Add("--pass", Options->Pass,
				"Print only this pass, by name or index: its inputs and outputs, their readers, why it is culled")
			.SetType("PASS");
	const FVerbOption Effect = Verb.Add("--effect", Options->Effect, "Print only this effect, with its passes")
								   .SetType("EFFECT")
								   .Exclude(Pass);
	Verb.AddRepeated(
			"--setting", "SETTING", Options->Names, "Print the origin of this setting, as `drydock blend` does")
		.Exclude(Pass)
		.Exclude(Effect);
	Verb.AddFlag("--measure", Options->bMeasure,
		"Run the frame as it is and with --no-skip, interleaved, and print medians instead of estimates");
	Verb.AddFlag("--json", Options->bJson, "Print effects, passes and costs as JSON");
	return CallWith(Options, Explain);
}

} // namespace Drydock
