// Collects the inputs of tasks, and remembers what tasks share.
#include "Sweep/SweepInputs.h"

#include "Budget/StudyRequest.h"
#include "ContentHash.h"
#include "RangeTools.h"
#include "Run/RunFiles.h"
#include "Run/RunSetup.h"
#include "Text/ConfigErrors.h"
#include "Text/Fingerprint.h"
#include "TextTools.h"

#include <algorithm>
#include <filesystem>

namespace Drydock
{

namespace
{

/** Files that FindSequenceInputs leaves out: those of overlays, and what plugins read beside themselves. Files that are
 * not there are left out: the run reports them. */
void AddFurtherFiles(const FRunOptions& Options, const FConfig& Config, FRunInputs& Inputs)
{
	namespace Files = std::filesystem;
	FWatchedFiles Shaders;
	Shaders.AddShaders(); // which count already
	const std::vector<std::string> Known = Shaders.GetPaths();
	const Files::path Folder = Files::absolute(Config.File).parent_path();
	for (const std::string& Path : FindRunFiles(Options).GetPaths())
	{
		const std::string Name =
			"file " + Files::absolute(Path).lexically_normal().lexically_relative(Folder).generic_string();
		std::error_code Ignored;
		if (!std::ranges::binary_search(Known, Path) && Path != Options.ConfigFile && !Inputs.count(Name) &&
			Files::is_regular_file(Path, Ignored))
		{
			Inputs[Name] = FingerprintFile(Path);
		}
	}
}

} // namespace

std::string NameTaskFiles(const FSweepTask& Task)
{
	std::string Text;
	for (const auto& [Name, Value] : Task.Set)
	{
		if (Name == "scene" || Name == "plugin" || Name == "overlay")
		{
			Text += (Text.empty() ? "" : ", ") + Name + " " + Value;
		}
	}
	return Text;
}

FSweepInputs::FSweepInputs(const FSweepPlan& InPlan)
	: Plan(InPlan)
{
}

FSweepInputs::FKnown& FSweepInputs::Find(const FSweepTask& Task)
{
	const std::string Key = NameTaskFiles(Task);
	const auto Found = Known.find(Key);
	if (Found != Known.end())
	{
		return Found->second;
	}
	FSweepTask Bare;
	std::ranges::copy_if(Task.Set, std::back_inserter(Bare.Set), [](const auto& One)
		{ return One.first == "scene" || One.first == "plugin" || One.first == "overlay"; });
	const FRunOptions Options = MakeTaskOptions(Plan, Bare);
	FKnown Made;
	{
		const bool bRun = Plan.Task == ESweepTask::Run;
		const FRunSetup Setup(Options, bRun ? ESceneNeed::Required : ESceneNeed::IfNamed);
		Made.Config = Setup.Config;
		Made.Inputs = FindSequenceInputs(Options, Made.Config); // while the plugins' ini files are known
		AddFurtherFiles(Options, Made.Config, Made.Inputs);
		Made.Inputs["config"] = GetStudyFingerprint(GetConfigText(Options)); // whose sweep may grow
		const std::string& Scene = Made.Config.Scene.File.Value;
		if (!Scene.empty() && (!bRun || Made.Config.Scene.Sequence.empty())) // else frames count for themselves
		{
			Made.Inputs["scene"] = FingerprintFile(Made.Config.Resolve(Scene));
		}
	}
	Made.Inputs.erase("path");
	Made.Inputs.erase("options");
	for (const auto& [Name, Value] : Made.Inputs)
	{
		Made.Text += Name + "\n" + Value + "\n";
	}
	if (!Made.Config.Scene.Sequence.empty())
	{
		for (const FSequenceFrame& Frame : ChooseSequenceFrames(Made.Config, "all", {}))
		{
			Made.Frames[Frame.Number] = Frame.Path;
		}
	}
	return Known.emplace(Key, std::move(Made)).first->second;
}

const std::string& FSweepInputs::FindFile(const std::string& Path)
{
	const auto Found = FileFingerprints.find(Path);
	return Found != FileFingerprints.end() ? Found->second
										   : FileFingerprints.emplace(Path, FingerprintFile(Path)).first->second;
}

const FConfig& FSweepInputs::GetConfig(const FSweepTask& Task)
{
	return Find(Task).Config;
}

std::string FSweepInputs::Hash(const FSweepTask& Task)
{
	constexpr size_t NumDigits = 32;
	constexpr const char* Format = "drydock sweep 1"; // of results
	const FKnown& Inputs = Find(Task);
	FContentHash Hash;
	for (const std::string& Piece : {std::string(Format), Inputs.Text,
			 GetSweepTaskNames()[static_cast<size_t>(Plan.Task)], Plan.Pass, std::string(Plan.bExr ? "exr" : ""),
			 std::string(Plan.bMeasure ? "measure" : ""), Task.Frames, Task.LeadFrames})
	{
		Hash.Add(Piece);
	}
	for (const auto& [Name, Value] : Task.Set)
	{
		if (Name != "frames")
		{
			Hash.Add(Name);
			Hash.Add(Value);
		}
	}
	for (const std::string& List : {Task.LeadFrames, Task.Frames})
	{
		for (const int Frame : ListTaskFrames(List))
		{
			const auto Found = Inputs.Frames.find(Frame);
			if (Found == Inputs.Frames.end())
			{
				throw FError({.Code = ErrorFileMissing,
								 .Message = "there is no frame " + std::to_string(Frame) + " any more",
								 .File = Inputs.Config.Resolve(Inputs.Config.Scene.Sequence)},
					ExitFiles);
			}
			Hash.Add(FindFile(Found->second));
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
