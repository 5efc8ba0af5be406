// `drydock import`: makes a scene and a config of a frame that another program rendered.
#include "Import/Import.h"
#include "PrintText.h"
#include "Program/NumberList.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"

#include <algorithm>
#include <cstdio>
#include <memory>

namespace Drydock
{

namespace
{

/** An option whose words are those of an enum, in its order. */
template<typename TEnum>
FVerbOption AddWords(FVerbOptions& Verb, const char* Name, std::optional<TEnum>& Value,
	const std::vector<std::string>& Words, const char* Doc)
{
	const std::function<void(const std::string&)> Take = [&Value, Words](const std::string& Word)
	{
		Value = static_cast<TEnum>(std::ranges::find(Words, Word) - Words.begin());
	};
	return Verb.Add(Name, Take, Doc).RequireOneOf(Words);
}

void AddTriple(FVerbOptions& Verb, const char* Name, std::optional<std::array<double, 3>>& Value, const char* Type,
	const char* Expected, const char* Doc)
{
	Verb.Add(
			Name,
			[Name, &Value, Expected](const std::string& Text)
			{
				const std::vector<double> Numbers = ParseNumbers(Name, Text, 3, 3, Expected);
				Value = {Numbers[0], Numbers[1], Numbers[2]};
			},
			Doc)
		.SetType(Type);
}

void AddEncodings(FVerbOptions& Verb, FImportAsked& Asked)
{
	AddWords(Verb, "--from", Asked.Origin, {"plain", "unreal", "blender", "drydock"},
		"Use these conventions instead of those that headers and names indicate")
		.SetType("unreal|blender|drydock|plain");
	Verb.Add("--unit", Asked.Unit, "Unit of depth").RequireOneOf({"m", "cm", "mm", "km"});
	AddWords(Verb, "--depth", Asked.Depth, {"distance", "ray", "inverse", "device", "mist"},
		"Depth holds the distance along the camera's axis, the distance from the camera, an inverse, device depth, or "
		"mist");
	Verb.Add(
			"--mist",
			[&Asked](const std::string& Text)
			{
				const std::vector<double> Numbers =
					ParseNumbers("--mist", Text, 2, 2, "START,DEPTH in metres, as the world's mist settings have them");
				Asked.Mist = {Numbers[0], Numbers[1]};
			},
			"Read depth from a linear mist pass, which begins at START and ends DEPTH behind it")
		.SetType("START,DEPTH");
	Verb.Add(
			"--normals", [&Asked](const std::string& Word) { Asked.bHalved = Word == "encoded"; },
			"Normals are stored as -1..1, or encoded in 0..1")
		.RequireOneOf({"signed", "encoded"});
	AddWords(Verb, "--normal-space", Asked.NormalSpace, {"unreal", "world", "y-up", "camera"},
		"Axes of the normals: Unreal's, right-handed with Z or with Y up, or the camera's");
	AddWords(Verb, "--velocity", Asked.Velocity, {"pixels", "pixels-up", "ndc", "unreal", "blender"},
		"Storage of movement: pixels with y down or up, screen position, Unreal's or Blender's pass");
	Verb.AddFlag("--flip-velocity", Asked.bFlipVelocity, "Reverse the direction of movement");
	AddWords(Verb, "--alpha", Asked.Alpha, {"premultiplied", "straight", "opaque"},
		"Colour is already multiplied by alpha (default), must be multiplied, or alpha is ignored");
}

int Import(const FImportOptions& Options)
{
	const FImportResult Result = ImportFrame(Options);
	PrintDiagnostics(Result.Diagnostics);
	PrintResult(Result.Report, Options.bJson);
	if (Options.bJson || Options.bDryRun)
	{
		return ExitDone;
	}
	const size_t NumMore = Result.Scenes.size() - 1;
	PrintText(stdout,
		"\n" + Result.Scenes.front() + (NumMore == 0 ? "" : " and " + std::to_string(NumMore) + " frames more") + "\n");
	if (!Result.Config.empty())
	{
		PrintText(stdout, Result.Config + ": drydock run " + Result.Config + "\n");
	}
	return ExitDone;
}

} // namespace

FVerbCall AddImportOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FImportOptions>();
	FImportAsked& Asked = Options->Asked;
	Verb.Add("FRAME", Options->Inputs,
			"Files of one frame: multi-layer EXR, or one file for each pass; NAME.####.exr is a sequence")
		.Require();
	Verb.Add("--out", Options->OutputFile, "Write the scene to this file, and its config beside it")
		.SetType("SCENE.exr");
	Verb.AddRepeated("--map", "LAYER=CHANNEL", Asked.Maps,
		"Import a layer, channel or file as this, instead of the guess: depth, normal, R ...; none leaves it out; "
		"repeats");
	Verb.AddRepeated("--toon", "OBJECT", Asked.Toon,
		"Mark objects as toon-shaded, by name (with * and ?) or stencil value; repeats");
	Verb.AddRepeated("--stencil", "OBJECT=VALUE", Asked.Stencil,
		"Set the custom stencil of objects, by name; repeats; later values win");
	AddEncodings(Verb, Asked);
	Verb.Add("--fov", Asked.Fov, "Horizontal field of view of the camera").RequireRange(1.0, 170.0).SetType("DEGREES");
	AddTriple(Verb, "--location", Asked.Location, "X,Y,Z", "X,Y,Z in cm", "Camera's location in Unreal's axes, cm");
	AddTriple(Verb, "--rotation", Asked.Rotation, "PITCH,YAW,ROLL", "PITCH,YAW,ROLL in degrees",
		"Camera's rotation in Unreal's axes, degrees");
	Verb.AddFlag("--dry-run", Options->bDryRun, "Print the table of layers and channels, and write nothing");
	Verb.AddFlag("--force", Options->bForce, "Replace a scene that import did not write, and the config");
	Verb.AddFlag("--json", Options->bJson, "Print the table as JSON");
	return [Options]
	{
		Options->Width = GetOutputWidth();
		return Import(*Options);
	};
}

} // namespace Drydock
