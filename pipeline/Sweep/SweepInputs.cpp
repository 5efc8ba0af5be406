// Collects the inputs of tasks, and remembers what tasks share.
#include "Sweep/SweepInputs.h"

#include "Budget/StudyRequest.h"
#include "Config/FrameSequence.h"
#include "ContentHash.h"
#include "Run/RunFiles.h"
#include "Run/RunSetup.h"
#include "Text/ConfigErrors.h"
#include "Text/Fingerprint.h"

#include <algorithm>
#include <filesystem>

namespace Drydock
{

namespace
{

bool NamesFile(const std::pair<std::string, std::string>& One)
{
	return One.first == "scene" || One.first == "plugin" || One.first == "overlay";
}

/** Files that FindSequenceInputs leaves out: those of overlays, and what plugins read beside themselves. */
void AddFurtherFiles(const FRunOptions& Options, FRunInputs& Inputs)
{
	namespace Files = std::filesystem;
	FWatchedFiles Shaders;
	Shaders.AddShaders(); // which count already
	const std::vector<std::string> Known = Shaders.GetPaths();
	for (const std::string& Path : FindRunFiles(Options).GetPaths())
	{
		std::error_code Ignored;
		if (!std::ranges::binary_search(Known, Path) && Path != Options.ConfigFile &&
			Files::is_regular_file(Path, Ignored))
		{
			Inputs["read " + Files::path(Path).filename().string()] = FingerprintFile(Path);
		}
	}
}

} // namespace

std::string FSweepInputs::NameFiles(const FSweepTask& Task)
{
	std::string Text;
	for (const auto& One : Task.Set)
	{
		Text += NamesFile(One) ? (Text.empty() ? "" : ", ") + One.first + " " + One.second : "";
	}
	return Text;
}

const FSweepInputs::FKnown& FSweepInputs::Find(const FSweepTask& Task)
{
	const std::string Key = NameFiles(Task);
	if (const auto Found = Known.find(Key); Found != Known.end())
	{
		return Found->second;
	}
	FSweepSet Set;
	std::ranges::copy_if(Task.Set, std::back_inserter(Set), NamesFile);
	const FRunOptions Options = MakeTaskOptions(Plan, Set);
	const bool bRun = Plan.Kind == "run";
	const FRunSetup Setup(Options, bRun ? ESceneNeed::Required : ESceneNeed::IfNamed);
	FKnown Made{Setup.Config, FindSequenceInputs(Options, Setup.Config), {}};
	AddFurtherFiles(Options, Made.Inputs);
	const FConfigScene& Scene = Made.Config.Scene;
	if (!Scene.File.Value.empty() && (!bRun || Scene.Sequence.empty())) // else frames count for themselves
	{
		Made.Inputs["scene"] = FingerprintFile(Made.Config.Resolve(Scene.File.Value));
	}
	if (Plan.Kind != "study") // which depends on the budget, too
	{
		Made.Inputs["config"] = GetStudyFingerprint(GetConfigText(Options)); // whose sweep may grow
	}
	Made.Inputs.erase("path");
	Made.Inputs.erase("options");
	for (const FSequenceFrame& Frame :
		Scene.Sequence.empty() ? std::vector<FSequenceFrame>() : ChooseSequenceFrames(Made.Config, "all", {}))
	{
		Made.Frames[Frame.Number] = Frame.Path;
	}
	return Known.emplace(Key, std::move(Made)).first->second;
}

std::string FSweepInputs::Hash(const FSweepTask& Task)
{
	constexpr size_t NumDigits = 32;
	const FKnown& Of = Find(Task);
	FContentHash Hash;
	for (const std::string& Piece : {std::string("drydock sweep 1"), Plan.Kind, Plan.Pass, Task.Frames, Task.LeadFrames,
			 std::string(Plan.bExr ? "exr" : ""), std::string(Plan.bMeasure ? "measure" : "")})
	{
		Hash.Add(Piece);
	}
	for (const auto& [Name, Value] : Of.Inputs)
	{
		Hash.Add(Name);
		Hash.Add(Value);
	}
	for (const auto& [Name, Value] : Task.Set)
	{
		Hash.Add(Name == "frames" ? "" : Name);
		Hash.Add(Name == "frames" ? "" : Value);
	}
	for (const std::string& List : {Task.LeadFrames, Task.Frames})
	{
		for (const int Frame : ListTaskFrames(List))
		{
			const auto Path = Of.Frames.find(Frame);
			if (Path == Of.Frames.end())
			{
				throw FError({.Code = ErrorFileMissing,
								 .Message = "there is no frame " + std::to_string(Frame) + " any more",
								 .File = Of.Config.Resolve(Of.Config.Scene.Sequence)},
					ExitFiles);
			}
			std::string& Fingerprint = FrameFingerprints[Path->second];
			Fingerprint = Fingerprint.empty() ? FingerprintFile(Path->second) : Fingerprint;
			Hash.Add(Fingerprint);
		}
	}
	return Hash.Finish().substr(0, NumDigits);
}

std::map<std::string, FRunInputs> FSweepInputs::GetInputs() const
{
	std::map<std::string, FRunInputs> Inputs;
	for (const auto& [Key, Each] : Known)
	{
		Inputs[Key] = Each.Inputs;
	}
	return Inputs;
}

} // namespace Drydock
