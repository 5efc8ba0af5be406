// Describes tasks, and turns what they set into options of a run.
#include "Sweep/SweepPlan.h"

#include "Budget/StudyRequest.h"
#include "Config/FrameList.h"
#include "RangeTools.h"
#include "Text/JsonWriter.h"
#include "TextTools.h"

#include <algorithm>
#include <filesystem>

namespace Drydock
{

namespace
{

size_t CountFrames(const std::string& List)
{
	return List.empty() ? 0 : ListTaskFrames(List).size();
}

} // namespace

std::vector<int> ListTaskFrames(const std::string& List)
{
	std::string Ignored;
	const std::optional<FFrameList> Parsed = List.empty() ? std::nullopt : ParseFrameList(List, Ignored);
	return Parsed ? ListFrames(*Parsed, {}) : std::vector<int>();
}

double FSweepPlan::GetSeconds() const
{
	size_t NumFrames = 0;
	for (const FSweepTask& Each : Tasks)
	{
		NumFrames += std::max<size_t>(1, CountFrames(Each.Frames) + CountFrames(Each.LeadFrames));
	}
	return SecondsPerFrame * static_cast<double>(NumFrames);
}

uint64_t FSweepPlan::GetBytes() const
{
	uint64_t NumFrames = 0;
	for (const FSweepTask& Each : Tasks)
	{
		NumFrames += std::max<size_t>(1, CountFrames(Each.Frames));
	}
	return BytesPerFrame * NumFrames;
}

FRunOptions MakeTaskOptions(const FSweepPlan& Plan, const FSweepSet& Set)
{
	const auto Resolve = [&](const std::string& Path)
	{
		return (std::filesystem::path(Plan.Config).parent_path() / Path).lexically_normal().string();
	};
	FRunOptions Options;
	Options.ConfigFile = Plan.Config;
	Options.bMeasureEffects = Plan.bMeasure && Plan.Kind == "run";
	Options.bUseBudget = false; // by which measured times would choose
	for (const auto& [Name, Value] : Set)
	{
		if (Name == "scene")
		{
			Options.ConfigPlaces.push_back("/scene/file=" + FJsonWriter::Quote(Value));
		}
		else if (Name == "engine")
		{
			Options.Engine = Value;
		}
		else if (Name == "plugin" || Name == "overlay")
		{
			(Name == "plugin" ? Options.Plugins : Options.Overlays).push_back(Resolve(Value));
		}
		else if (Name == "resolution")
		{
			Options.ScreenPercentage = ParseAll<double>(Value);
		}
		else if (Name != "frames")
		{
			ApplyToRun({{Name, Value, {}}}, Options);
		}
	}
	return Options;
}

std::string DescribeTask(const FSweepPlan& Plan, const FSweepTask& Task, int Without)
{
	std::vector<std::string> Words;
	for (size_t Axis = 0; Axis < Plan.Axes.size() && Axis < Task.Values.size(); ++Axis)
	{
		const std::string& Name = Plan.Axes[Axis].Name;
		const bool bNamed = Name == "piece" || Contains(Task.Set, std::pair(Name, Task.Values[Axis]));
		if (static_cast<int>(Axis) != Without)
		{
			Words.push_back(Task.Values[Axis].empty() ? "unsplit" : (bNamed ? Name + " " : "") + Task.Values[Axis]);
		}
	}
	return JoinText(Words);
}

std::optional<FJsonValue> ParseSweepJson(const std::string& Text)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	FJsonValue Root = ParseJson(Text, "", Ignored, bSyntaxError);
	return bSyntaxError || Root.Type != EJsonType::Object ? std::nullopt : std::optional(std::move(Root));
}

} // namespace Drydock
