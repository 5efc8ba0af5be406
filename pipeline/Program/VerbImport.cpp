// `drydock import`: makes a scene and a config of a frame that another program rendered.
#include <CLI/CLI.hpp>

#include "Import/Import.h"
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
void AddWords(CLI::App& Verb, const char* Name, std::optional<TEnum>& Value, const std::vector<std::string>& Words,
	const char* Type, const char* Doc)
{
	RequireOneOf(Verb.add_option_function<std::string>(
					 Name,
					 [&Value, &Words](const std::string& Word)
					 { Value = static_cast<TEnum>(std::find(Words.begin(), Words.end(), Word) - Words.begin()); },
					 Doc),
		Words)
		->type_name(Type);
}

void AddTriple(CLI::App& Verb, const char* Name, std::optional<std::array<double, 3>>& Value, const char* Type,
	const char* Expected, const char* Doc)
{
	Verb.add_option_function<std::string>(
			Name,
			[Name, &Value, Expected](const std::string& Text)
			{
				const std::vector<double> Numbers = ParseNumbers(Name, Text, 3, 3, Expected);
				Value = {Numbers[0], Numbers[1], Numbers[2]};
			},
			Doc)
		->type_name(Type);
}

void AddEncodings(CLI::App& Verb, FImportAsked& Asked)
{
	AddWords(Verb, "--from", Asked.Origin, GetImportOriginWords(), "unreal|blender|drydock|plain",
		"Whose conventions hold, in place of what headers and names say");
	RequireOneOf(Verb.add_option_function<std::string>(
					 "--unit", [&Asked](const std::string& Unit) { Asked.Unit = Unit; }, "Unit of depth"),
		GetImportUnitWords())
		->type_name("m|cm|mm|km");
	AddWords(Verb, "--depth", Asked.Depth, GetImportDepthWords(), "distance|ray|inverse|device|mist",
		"Along the camera's axis, from its place, one by it, the engine's device depth, or mist");
	Verb.add_option_function<std::string>(
			"--mist",
			[&Asked](const std::string& Text)
			{
				const std::vector<double> Numbers =
					ParseNumbers("--mist", Text, 2, 2, "START,DEPTH in metres, as the world's mist settings have them");
				Asked.Mist = {Numbers[0], Numbers[1]};
			},
			"Take depth from a mist pass of linear falloff, which begins at START and ends DEPTH behind it")
		->type_name("START,DEPTH");
	RequireOneOf(Verb.add_option_function<std::string>(
					 "--normals", [&Asked](const std::string& Word) { Asked.bHalved = Word == "encoded"; },
					 "Stored as -1..1, or as half of themselves and a half"),
		{"signed", "encoded"});
	AddWords(Verb, "--normal-space", Asked.NormalSpace, GetImportNormalSpaceWords(), "unreal|world|y-up|camera",
		"Axes of the normals: Unreal's, right-handed with Z or with Y up, or the camera's");
	AddWords(Verb, "--velocity", Asked.Velocity, GetImportVelocityWords(), "pixels|pixels-up|ndc|unreal|blender",
		"How movement is stored: pixels with y down or up, screen position, Unreal's or Blender's pass");
	Verb.add_flag("--flip-velocity", Asked.bFlipVelocity, "Movement points the other way");
	AddWords(Verb, "--alpha", Asked.Alpha, GetImportAlphaWords(), "premultiplied|straight|opaque",
		"Colour is multiplied by alpha already (default), is to be, or alpha counts for nothing");
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
	std::printf("\n%s%s\n", Result.Scenes.front().c_str(),
		Result.Scenes.size() == 1 ? "" : (" and " + std::to_string(Result.Scenes.size() - 1) + " frames more").c_str());
	if (!Result.Config.empty())
	{
		std::printf("%s: drydock run %s\n", Result.Config.c_str(), Result.Config.c_str());
	}
	return ExitDone;
}

FVerbCall AddOptions(CLI::App& Verb)
{
	const auto Options = std::make_shared<FImportOptions>();
	FImportAsked& Asked = Options->Asked;
	Verb.add_option("FRAME", Options->Inputs,
			"Files of one frame: multi-layer EXR, or one file to a pass; NAME.####.exr is a sequence")
		->required();
	Verb.add_option("--out", Options->OutputFile, "The scene to write; its config goes beside it")
		->type_name("SCENE.exr");
	AddRepeated(Verb, "--map", "LAYER=CHANNEL", Asked.Maps,
		"What a layer, channel or file becomes, in place of the guess: depth, normal, R ...; none leaves it out; "
		"repeats");
	AddRepeated(Verb, "--toon", "OBJECT", Asked.Toon,
		"Objects that are toon-shaded, by name (with * and ?) or stencil value; repeats");
	AddRepeated(Verb, "--stencil", "OBJECT=VALUE", Asked.Stencil,
		"Custom stencil of objects, by name; repeats, and later ones win");
	AddEncodings(Verb, Asked);
	Verb.add_option_function<double>(
			"--fov", [&Asked](const double& Degrees) { Asked.Fov = Degrees; }, "Horizontal field of view of the camera")
		->check(CLI::Range(1.0, 170.0).description(""))
		->type_name("DEGREES");
	AddTriple(Verb, "--location", Asked.Location, "X,Y,Z", "X,Y,Z in cm", "Camera's place in Unreal's axes, cm");
	AddTriple(Verb, "--rotation", Asked.Rotation, "PITCH,YAW,ROLL", "PITCH,YAW,ROLL in degrees",
		"Camera's rotation in Unreal's axes, degrees");
	Verb.add_flag("--dry-run", Options->bDryRun, "Print what would become what, and write nothing");
	Verb.add_flag("--force", Options->bForce, "Replace a scene that import did not write, and the config");
	Verb.add_flag("--json", Options->bJson, "Print the table as JSON");
	return [Options]
	{
		Options->Width = GetOutputWidth();
		return Import(*Options);
	};
}

const FVerbRegistration GRegistration({
	.Name = "import",
	.Place = 105,
	.Group = EVerbGroup::Run,
	.Doc = "Make a scene and a config of a frame of Unreal or Blender",
	.AddOptions = AddOptions,
});

} // namespace

} // namespace Drydock
