// `drydock flicker`: measures how the light of a sequence and of its effects jumps from frame to frame.
#include "Flicker/FlickerReport.h"
#include "Program/ProgramOutput.h"
#include "Program/ProgressBar.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Text/ConfigErrors.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"

#include "PrintText.h"

#include <cstdio>
#include <filesystem>
#include <memory>

namespace Drydock
{

namespace
{

struct FFlickerVerbOptions
{
	FFlickerOptions Flicker;
	std::vector<std::string> Against;
	std::string OutputFolder;
	bool bJson = false;
};

const FOutputNames FlickerNames = {
	.Name = "flicker", .Files = {"flicker.json", "flicker.svg"}, .Last = "flicker.json", .Folders = {}, .Unsteady = {}};

void WriteOutputs(const FFlickerResult& Result, const FFlickerVerbOptions& Options)
{
	FOutputFolder Output(Options.OutputFolder, FlickerNames);
	const std::filesystem::path& Aside = Output.GetAside();
	WriteFlickerPictures(Result, Aside.string());
	const std::string Title = "Flicker of " + std::filesystem::path(Options.Flicker.Run.ConfigFile).stem().string();
	WriteWholeFile((Aside / "flicker.svg").string(), MakeFlickerChart(Result, Title));
	WriteWholeFile((Aside / "flicker.json").string(), MakeFlickerJson(Result));
	Output.PutInPlace();
}

int PrintFlicker(const FFlickerVerbOptions& Options)
{
	if (Options.Flicker.Run.Frame)
	{
		throw BadArgument("flicker compares frames: name them with --frames LIST", "--frame");
	}
	FFlickerOptions Flicker = Options.Flicker;
	Flicker.Variants = {{"as it is", {}}};
	for (const std::string& Variable : Options.Against)
	{
		Flicker.Variants.push_back({Variable, {Variable}});
	}
	FProgressBar Bar;
	Flicker.Progress = [&Bar](int Done, int Total, const std::string& What)
	{
		Bar.Show(Done, Total, What);
	};
	const FFlickerResult Result = MeasureFlicker(Flicker);
	Bar.Clear();
	PrintDiagnostics(Result.Diagnostics);
	if (!Options.OutputFolder.empty())
	{
		WriteOutputs(Result, Options);
	}
	PrintText(stdout, Options.bJson ? MakeFlickerJson(Result) : MakeFlickerTable(Result, GetOutputWidth()));
	return ExitDone;
}

} // namespace

FVerbCall AddFlickerOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FFlickerVerbOptions>();
	AddConfig(Verb, Options->Flicker.Run);
	AddArithmetic(Verb, Options->Flicker.Run);
	Verb.Add("--frames", Options->Flicker.Frames, "Frames: 1-8, 1-9x2, 1,3,5-8 or all; the config's by default")
		.SetType("LIST");
	Verb.Add("--truth", Options->Flicker.Truth,
			"Frames without aliasing, whose change is the scene's own; NAME.truth.####.exr beside the scene by default")
		.SetType("NAME.####.exr");
	Verb.AddRepeated("--against", "r.NAME=VALUE", Options->Against,
		"Measure a run with this variable, too, such as r.AntiAliasingMethod=0; repeats");
	Verb.Add("--out", Options->OutputFolder, "Write flicker.json, flicker.svg and pictures of where into this folder")
		.SetType("DIR");
	Verb.AddFlag("--json", Options->bJson, "Print JSON: the figures of each frame");
	return CallWith(Options, PrintFlicker);
}

} // namespace Drydock
