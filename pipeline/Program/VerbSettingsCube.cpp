// `drydock settings cube`: the grade of a config as a .cube file.
#include "Picture/ColorCube.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "RangeTools.h"
#include "Run/Run.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/TextFile.h"

#include <algorithm>
#include <filesystem>
#include <memory>

namespace Drydock
{

namespace
{

struct FCubeOptions
{
	FRunOptions Run;
	std::string Size = "33";
	std::string Input = "log";
	std::string File; // empty: NAME.cube, of the config
};

/** The combined table of the config's frame. Source of the layout: PostProcessCombineLUTs.h. */
FColorCube BakeTable(const FCubeOptions& Options)
{
	FRunOptions Run = Options.Run;
	Run.Dump = {"CombineLUTs"};
	Run.Storage = ERunStorage::Float32;
	Run.bUseBudget = false;
	for (const std::string& Variable :
		{"r.LUT.Size=" + Options.Size, "r.Drydock.LUTInput=" + std::string(Options.Input == "display" ? "1" : "0"),
			std::string("r.Drydock.TonemapLUT=1"), std::string("r.HDR.Display.OutputDevice=0")})
	{
		Run.Variables.push_back(Variable);
	}
	const FRunResult Result = RunConfig(Run);
	PrintDiagnostics(Result.Diagnostics);
	const FRunDump* const Dump = FindItem(Result.Dumps, std::string("CombineLUTs"), &FRunDump::Resource);
	if (Dump == nullptr)
	{
		throw BadArgument("the frame of " + Run.ConfigFile + " has no tonemapper, and so no table");
	}
	const FImage Table = Dump->Image.ToImage();
	constexpr double Scale = 1.05;
	FColorCube Cube;
	Cube.Size = Table.Height;
	for (int Index = 0; Index < Table.Width * Table.Height; ++Index)
	{
		const int Red = Index % Cube.Size;
		const int Green = Index / Cube.Size % Cube.Size;
		const int Blue = Index / Cube.Size / Cube.Size;
		std::array<double, 3>& Color = Cube.Colors.emplace_back();
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			Color[static_cast<size_t>(Channel)] =
				std::clamp(Table.Get(Blue * Cube.Size + Red, Green, Channel) * Scale, 0.0, 1.0);
		}
	}
	return Cube;
}

int MakeCube(const FCubeOptions& Options)
{
	const FColorCube Cube = BakeTable(Options);
	const std::string Name = std::filesystem::path(Options.Run.ConfigFile).stem().string();
	const std::string File = Options.File.empty() ? Name + ".cube" : Options.File;
	const std::string Input =
		Options.Input == "log"
			? "Input: log. x is exposed scene light, linear Rec.709: light = 0.18 * 2^(14 * (x - 444/1023)) - 0.0026677"
			: "Input: display. x is exposed scene light up to 1, linear Rec.709, encoded as sRGB (IEC 61966-2-1)";
	WriteTextFile(
		File, MakeColorCubeText(Cube, Name,
				  {"The grade of " + std::filesystem::path(Options.Run.ConfigFile).filename().string() +
						  ": white balance, grading, film curve, fade; no bloom, no lens effects, no exposure",
					  Input, "Output: sRGB codes 0..1 of a Rec.709 display (IEC 61966-2-1)"}));
	PrintResult(fmt::format("{}: {} x {} x {} colours. {}\n", File, Cube.Size, Cube.Size, Cube.Size, Input));
	return ExitDone;
}

} // namespace

FVerbCall AddSettingsCubeOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FCubeOptions>();
	AddConfig(Verb, Options->Run);
	Verb.Add("--size", Options->Size, "Colours to a side; 33 by default").RequireOneOf({"33", "65"});
	Verb.Add("--input", Options->Input,
			"Input of the table: log (default), 14 stops around middle grey as the engine's, or display, sRGB codes")
		.RequireOneOf({"log", "display"});
	Verb.Add("--out", Options->File, "File to write; NAME.cube of the config by default").SetType("FILE");
	return CallWith(Options, MakeCube);
}

} // namespace Drydock
