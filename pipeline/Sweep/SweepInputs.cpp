// Collects the inputs of tasks, and remembers what tasks share.
#include "Sweep/SweepInputs.h"

#include "Budget/StudyRequest.h"
#include "ChildProcess.h"
#include "Config/FrameSequence.h"
#include "ContentHash.h"
#include "MarkedFolder.h"
#include "Matrix/Matrix.h"
#include "Overlay/OverlayFolder.h"
#include "Run/RunSetup.h"
#include "Sweep/SweepErrors.h"
#include "Text/ConfigErrors.h"
#include "Text/Fingerprint.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <filesystem>
#include <functional>

namespace Drydock
{

namespace
{

bool IsCode(const FSweepSet::value_type& One)
{
	return One.first == "plugin" || One.first == "overlay";
}

bool NamesFile(const FSweepSet::value_type& One)
{
	return One.first == "scene" || IsCode(One);
}

/** The files of overlays, which FindSequenceInputs leaves out. */
void AddOverlays(const FRunOptions& Options, const FConfig& Config, FRunInputs& Inputs)
{
	std::vector<std::string> Folders = Options.Overlays;
	std::ranges::for_each(Config.Overlays,
		[&](const FConfigOverlay& Overlay) { Folders.push_back(Config.Resolve(Overlay.Folder.Value)); });
	for (const std::string& Folder : Folders)
	{
		std::vector<FDiagnostic> Ignored; // the run reports them
		const FOverlayFolder Overlay = ReadOverlayFolder(Folder, Ignored);
		std::vector<std::string> Paths = Overlay.Read;
		std::ranges::for_each(
			Overlay.Shaders, [&](const std::string& Shader) { Paths.push_back(Overlay.GetShaderFile(Shader)); });
		for (const std::string& Path : Paths)
		{
			const std::string Name = std::filesystem::path(Path).lexically_relative(Folder).generic_string();
			Inputs["overlay " + std::to_string(&Folder - Folders.data()) + " " + Name] = FingerprintFile(Path);
		}
	}
}

/** Inputs as run.json has them, of a run in a process of its own: one plugin would see the shaders of another. */
FRunInputs FindInputsApart(const FRunOptions& Options)
{
	constexpr int MostSeconds = 3600;
	const FMarkedFolder Folder((std::filesystem::temp_directory_path() / "drydock-sweep-").string());
	const std::string Out = Folder.Reserve("run");
	std::vector<std::string> Words = {FindThisProgram(), "run", Options.ConfigFile, "--report", "off", "--out", Out};
	for (const std::string& Plugin : Options.Plugins)
	{
		Words.insert(Words.end(), {"--plugin", Plugin});
	}
	for (const std::string& Overlay : Options.Overlays)
	{
		Words.insert(Words.end(), {"--overlay", Overlay});
	}
	const FChildResult Child = RunChild(Words, MostSeconds);
	const std::optional<FJsonValue> Root = ParseSweepJson(TryReadTextFile(Out + "/run.json").value_or(""));
	const FJsonValue* const Inputs = Root ? Root->Find("inputs") : nullptr;
	if (!Child.Succeeded() || Inputs == nullptr)
	{
		throw FError(
			{.Code = ErrorSweepCrash, .Message = "a run with it " + Child.Describe(MostSeconds) + ": " + Child.Output},
			ExitUsage);
	}
	FRunInputs Found;
	std::ranges::for_each(Inputs->Members, [&](const FJsonMember& One) { Found[One.Key] = One.Value.String; });
	return Found;
}

} // namespace

bool FSweepInputs::NamesCode(const FSweepTask& Task)
{
	return std::ranges::any_of(Task.Set, IsCode);
}

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
	FSweepSet Files, Scenes;
	std::ranges::copy_if(Task.Set, std::back_inserter(Files), NamesFile);
	std::ranges::copy_if(Files, std::back_inserter(Scenes), std::not_fn(IsCode));
	const bool bApart = bPlanning && Scenes.size() < Files.size();
	const FRunOptions Options = MakeTaskOptions(Plan, bApart ? Scenes : Files);
	const bool bRun = Plan.Kind == "run";
	const FRunSetup Setup(Options, bRun ? ESceneNeed::Required : ESceneNeed::IfNamed);
	FKnown Made{Setup.Config, FindSequenceInputs(Options, Setup.Config), {}};
	const FRunOptions All = MakeTaskOptions(Plan, Files);
	for (const auto& [Name, Value] : bApart ? FindInputsApart(All) : FRunInputs())
	{
		Made.Inputs[Name] = Value;
	}
	AddOverlays(All, Made.Config, Made.Inputs);
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
