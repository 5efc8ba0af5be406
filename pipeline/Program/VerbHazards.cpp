// `drydock hazards`: a pass of a run under the hazards of the stability table.
#include "Hazards/HazardCapture.h"
#include "Picture/Preview.h"
#include "Program/FindingsOption.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Run/Run.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"

#include <array>
#include <cmath>
#include <memory>

namespace Drydock
{

namespace
{

struct FHazardsVerbOptions
{
	FRunOptions Run;
	FHazardRequest Request;
	std::string Folder; // of pictures; empty: none
	FFindingsOptions Findings;
	bool bJson = false;
};

const FOutputNames HazardNames = {
	.Name = "hazards", .Files = {"hazards.json"}, .Last = "hazards.json", .Folders = {"hazards"}, .Unsteady = {}};

/** Red, green and blue; NaN magenta, infinity yellow, minus infinity cyan. */
FImage MakeVisible(const FImage& Image)
{
	FImage Visible{Image.Width, Image.Height, 3, {}};
	for (int Y = 0; Y < Image.Height; ++Y)
	{
		for (int X = 0; X < Image.Width; ++X)
		{
			std::array<double, 3> Color = {Image.Get(X, Y, 0), Image.Get(X, Y, 1), Image.Get(X, Y, 2)};
			for (const double Value : std::array<double, 3>(Color))
			{
				if (!std::isfinite(Value))
				{
					Color = std::isnan(Value) ? std::array<double, 3>{1, 0, 1}
							: Value > 0       ? std::array<double, 3>{1, 1, 0}
											  : std::array<double, 3>{0, 1, 1};
				}
			}
			Visible.Values.insert(Visible.Values.end(), Color.begin(), Color.end());
		}
	}
	return Visible;
}

void WritePictures(const std::vector<FHazardRow>& Rows, const std::string& Folder)
{
	FOutputFolder Output(Folder, HazardNames);
	std::filesystem::create_directories(Output.GetAside() / "hazards");
	for (size_t Index = 0; Index < Rows.size(); ++Index)
	{
		const std::string Prefix = Rows.size() > 1 ? std::to_string(Index + 1) + "." : "";
		for (const FHazardFinding& Finding : Rows[Index].Findings)
		{
			const std::string Name = Prefix + Finding.File + ".png";
			WritePreviewPng((Output.GetAside() / "hazards" / Name).string(), MakeVisible(Finding.Result));
		}
	}
	WriteWholeFile((Output.GetAside() / "hazards.json").string(), MakeHazardJson(Rows));
	Output.PutInPlace();
}

/** A case for each hazard of each pass. A finite picture that becomes NaN is a warning. */
void AddCases(const std::vector<FHazardRow>& Rows, FJUnitSuite& Suite)
{
	for (size_t Index = 0; Index < Rows.size(); ++Index)
	{
		const FHazardRow& Row = Rows[Index];
		const std::string Of = (Rows.size() > 1 ? std::to_string(Index + 1) + ". " : "") + Row.Pass;
		for (const FHazardFinding& Finding : Row.Findings)
		{
			FJUnitCase Case{.Name = Of + ": " + Finding.Hazard, .Output = DescribeFinding(Finding)};
			if (MakesNaNOfFinite(Finding))
			{
				Case.Outcome = EJUnitOutcome::Failed;
				Case.Message = Finding.Hazard + " in place of " + Row.Input + ": " + Case.Output;
				Suite.Findings.push_back({{.Severity = ESeverity::Warning,
											  .Message = Case.Message,
											  .Where = "pass " + Row.Pass + ", " + Row.Shader},
					"hazard"});
			}
			Suite.Cases.push_back(std::move(Case));
		}
	}
}

int RunHazards(FHazardsVerbOptions Options, FJUnitSuite& Suite)
{
	FHazardCapture Capture(Options.Request);
	Options.Run.Variables.push_back("r.Drydock.NativeKernels=0"); // a shader's constants can be others, a kernel's not
	{
		const FScopedDispatchObserver Scope(Capture);
		PrintDiagnostics(RunConfig(Options.Run).Diagnostics);
	}
	const std::vector<FHazardRow>& Rows = Capture.GetRows();
	AddCases(Rows, Suite);
	if (!Options.Folder.empty())
	{
		WritePictures(Rows, Options.Folder);
	}
	std::string Text = Options.bJson ? MakeHazardJson(Rows) : "";
	for (const FHazardRow& Row : Rows)
	{
		Text += Options.bJson ? "" : (Text.empty() ? "" : "\n") + MakeHazardText(Row, GetOutputWidth());
	}
	PrintResult(Text, Options.bJson);
	return ExitDone;
}

} // namespace

FVerbCall AddHazardsOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FHazardsVerbOptions>();
	AddConfig(Verb, Options->Run);
	AddThreads(Verb, Options->Run, "Number of threads for the passes; 0: all cores");
	Verb.Add("--pass", Options->Request.Pass,
			"Choose the pass by its name or its shader's class; with * and ?; all passes of plugins by default")
		.SetType("PATTERN");
	Verb.Add("--input", Options->Request.Input,
			"Replace this texture, named as in the shader; the first with three channels by "
			"default")
		.SetType("NAME");
	Verb.Add("--out", Options->Folder, "Write the pass's output for each hazard as PNG files into this folder")
		.SetType("DIR");
	AddFindings(Verb, Options->Findings, "a case for each hazard; a finite picture that becomes NaN fails");
	Verb.AddFlag("--json", Options->bJson, "Print JSON");
	return [Options]
	{
		return CallWithFindings(Options->Findings, "hazards", Options->Run.ConfigFile,
			[&Options](FJUnitSuite& Suite) { return RunHazards(*Options, Suite); });
	};
}

} // namespace Drydock
