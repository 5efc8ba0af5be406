// `drydock scene`: writes a small sequence with jitter and velocities, and its exact truth.
#include "Program/NumberList.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Scenes/JitteredScenes.h"
#include "Text/ConfigErrors.h"
#include "Text/Fmt.inl"
#include "Text/OutputFolder.h"

#include "Math/ToInteger.h"
#include "PrintText.h"
#include "RangeTools.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace Drydock
{

namespace
{

struct FSceneVerbOptions
{
	FJitteredSceneOptions Scene;
	std::string Name;
	std::string Size;
	std::string OutputFolder;
};

int WriteScene(const FSceneVerbOptions& Options)
{
	FJitteredSceneOptions Scene = Options.Scene;
	Scene.Scene = FindJitteredScene(Options.Name);
	if (!Options.Size.empty())
	{
		constexpr int Largest = 1024;
		const std::vector<double> Size = ParseNumbers("--size", Options.Size, 2, 2, "WIDTH,HEIGHT in pixels");
		if (std::ranges::any_of(Size, [](double Side) { return !(Side >= 1.0 && Side <= Largest); }))
		{
			throw BadArgument(fmt::format("expected 1 to {} pixels on each side", Largest), "--size");
		}
		Scene.Size = FIntPoint(ToInteger<int>(Size[0]), ToInteger<int>(Size[1]));
	}
	const std::string Folder = Options.OutputFolder.empty() ? "out/scene/" + Options.Name : Options.OutputFolder;
	const std::string Config = Options.Name + ".json";
	FOutputFolder Output(
		Folder, {.Name = "scene-" + Options.Name, .Files = {Config}, .Last = Config, .Folders = {}, .Unsteady = {}});
	const std::vector<std::string> Files = WriteJitteredScene(Scene, Output.GetAside().string());
	Output.PutInPlace();
	const std::string Path = (std::filesystem::path(Folder) / Config).string();
	PrintText(stdout, fmt::format("{}: {} frames of {} x {} pixels, and their truth\n{}: drydock run {}\n", Folder,
						  Scene.NumFrames, Scene.Size.X, Scene.Size.Y, Path, Path));
	return ExitDone;
}

} // namespace

FVerbCall AddSceneOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSceneVerbOptions>();
	Verb.Add("NAME", Options->Name,
			"Sequence to write: a line that turns, a point that moves by 0.1 pixels a frame, ...")
		.RequireOneOf(ToVector<std::string>(GetJitteredScenes(), &FJitteredScene::Name))
		.Require();
	Verb.Add("--out", Options->OutputFolder, "Folder to write to; out/scene/NAME by default").SetType("DIR");
	Verb.Add("--size", Options->Size, "Size of a frame in pixels; 160,90 by default").SetType("WIDTH,HEIGHT");
	Verb.Add("--frames", Options->Scene.NumFrames, "Number of frames; 16 by default")
		.RequireRange(1, 9999)
		.SetType("N");
	Verb.Add("--samples", Options->Scene.NumSamples,
			"Frames after which the jitter repeats, as r.TemporalAASamples; 8 by "
			"default, 1: no jitter")
		.RequireRange(1, 255)
		.SetType("N");
	return CallWith(Options, WriteScene);
}

} // namespace Drydock
