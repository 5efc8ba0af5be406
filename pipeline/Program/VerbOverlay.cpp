// `drydock overlay`: makes an engine overlay to edit, and prints its changes for the engine.
#include "Config/ReadConfig.h"
#include "Overlay/OverlayFiles.h"
#include "Patch/PatchErrors.h"
#include "Patch/PatchName.h"
#include "PrintText.h"
#include "Program/ArgumentParser.h"
#include "Program/ProgramOutput.h"
#include "Program/Verbs.h"
#include "RangeTools.h"
#include "Text/JsonWriter.h"
#include "TextTools.h"

#include <cstdio>
#include <filesystem>
#include <memory>

namespace Drydock
{

namespace
{

struct FOverlayNewOptions
{
	std::string Name;
	std::string Pass;
	std::string Folder; // that the overlay's folder is made in; empty: here
};

struct FOverlayDiffOptions
{
	std::string Folder;
	std::string Engine;
	bool bJson = false;
};

int MakeOverlay(const FOverlayNewOptions& Options)
{
	if (const std::string Why = ExplainBadPatchName(Options.Name, {}); !Why.empty())
	{
		throw FError(
			{.Code = ErrorPatchName, .Message = "\"" + Options.Name + "\" cannot be an overlay's name: " + Why},
			ExitUsage);
	}
	const std::string Folder = (std::filesystem::path(Options.Folder) / Options.Name).string();
	const std::vector<FPatchFile> Made = MakeOverlayFiles(Options.Name, Options.Pass);
	WritePatch(Folder, Made);
	const std::string Text = Folder + ": an overlay of " + std::to_string(Made.size()) + " files\n" +
							 ListLines(ToVector<std::string>(Made, &FPatchFile::Path));
	PrintText(stdout, Text + "edit the files below Engine, then run it:\n  drydock run " + Folder + "/" + Options.Name +
						  ".json\n  drydock overlay diff " + Folder + "\n");
	return ExitDone;
}

std::string MakeDifferenceText(
	const FOverlayFolder& Folder, const FOverlayDifference& Difference, const std::string& Engine)
{
	const std::string Target = Engine.empty() ? "the engine" : "engine " + Engine;
	std::string Text = "# " + Folder.Name + ", for " + Target +
					   ". Carry each hunk over by hand: drydock's text of these files is not the engine's.\n";
	Text += FormatHunks(Difference.Hunks);
	for (const std::string& New : Difference.NewFiles)
	{
		Text +=
			"# " + New + ": drydock has no text of this file to compare it with, and all of its lines are printed\n";
	}
	return Text + (Difference.Hunks.empty() ? "# no line has changed\n" : "");
}

std::string MakeDifferenceJson(const FOverlayFolder& Folder, const FOverlayDifference& Difference)
{
	FJsonWriter Writer('{');
	Writer.Member("overlay", Folder.Name);
	Writer.Array("hunks", Difference.Hunks,
		[&](const FOverlayHunk& Hunk)
		{
			Writer.Object(
				{{"file", Hunk.File}, {"function", Hunk.Function}, {"lines", Hunk.Lines}, {"drydocksOwn", Hunk.bOwn}});
		});
	Writer.Member("notCompared", Difference.NewFiles);
	return Writer.GetText();
}

int CompareOverlays(const FOverlayDiffOptions& Options)
{
	std::vector<FDiagnostic> Diagnostics;
	if (!Options.Engine.empty())
	{
		FConfig OfEngine;
		SetEngineArgument(OfEngine, Options.Engine, Diagnostics);
	}
	const FOverlayFolder Folder = ReadOverlayFolder(Options.Folder, Diagnostics);
	if (HasErrors(Diagnostics))
	{
		throw FError(Diagnostics, ExitUsage);
	}
	const FOverlayDifference Difference = CompareOverlay(Folder);
	PrintText(stdout, Options.bJson ? MakeDifferenceJson(Folder, Difference)
									: MakeDifferenceText(Folder, Difference, Options.Engine));
	return ExitDone;
}

} // namespace

FVerbCall AddOverlayNewOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FOverlayNewOptions>();
	Verb.Add("NAME", Options->Name, "Name of the overlay, such as MyPatch").Require();
	Verb.Add("--pass", Options->Pass, "Pass whose files are to be edited: " + JoinText(ListOverlayPasses()))
		.SetType("PASS")
		.Require();
	Verb.Add("--dir", Options->Folder, "Make the folder NAME in this folder; in the current one by default")
		.SetType("DIR");
	return CallWith(Options, MakeOverlay);
}

FVerbCall AddOverlayDiffOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FOverlayDiffOptions>();
	Verb.Add("DIR", Options->Folder, "Folder of an overlay").Require();
	Verb.Add("--engine", Options->Engine, "Engine version that the changes are meant for").SetType("VERSION");
	Verb.AddFlag("--json", Options->bJson, "Print JSON: the hunks, and the files that were not compared");
	return CallWith(Options, CompareOverlays);
}

} // namespace Drydock
