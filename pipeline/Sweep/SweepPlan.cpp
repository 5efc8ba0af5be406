// Expands a sweep: combines the values of its axes, cuts frames into pieces, checks what each value sets.
#include "Sweep/SweepPlan.h"

#include "Budget/StudyRequest.h"
#include "Config/FrameList.h"
#include "Config/FrameSequence.h"
#include "RangeTools.h"
#include "Run/RunSetup.h"
#include "Sweep/SweepErrors.h"
#include "Sweep/SweepInputs.h"
#include "Text/ConfigErrors.h"
#include "Text/JsonWriter.h"
#include "TextTools.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr const char* PieceAxis = "piece";

std::string GetAbsolute(const std::string& Path)
{
	return Files::absolute(Path).lexically_normal().string();
}

FSweepPlan MakePlan(const FSweep& Sweep)
{
	FSweepPlan Plan;
	Plan.Config = GetAbsolute(Sweep.Config);
	Plan.Task = Sweep.Task;
	Plan.Pass = Sweep.Pass;
	Plan.bExr = Sweep.bExr;
	Plan.bMeasure = Sweep.bMeasure && Sweep.Task == ESweepTask::Run;
	for (const FStudyAxis& Axis : Sweep.Axes)
	{
		Plan.Axes.push_back({Axis.Name, ToVector<std::string>(Axis.Values, &FStudyValue::Label)});
	}
	for (const FStudyAssignment& One : Sweep.Against)
	{
		Plan.Against.push_back({One.Name, One.Value});
	}
	return Plan;
}

/** One combination of the axes' values: the index of a value for each axis. */
using FCombination = std::vector<size_t>;

std::vector<FCombination> Combine(const FSweep& Sweep)
{
	std::vector<FCombination> All(1);
	for (const FStudyAxis& Axis : Sweep.Axes)
	{
		std::vector<FCombination> Longer;
		for (const FCombination& Shorter : All)
		{
			for (size_t Value = 0; Value < Axis.Values.size(); ++Value)
			{
				Longer.push_back(Shorter);
				Longer.back().push_back(Value);
			}
		}
		All = std::move(Longer);
	}
	return All;
}

/** Whether it has one of the values that an entry of "exclude" names: an axis' label, or of a list what an entry sets.
 */
bool HasValue(const FSweep& Sweep, const FCombination& Combination, const FStudyAssignment& Chosen)
{
	for (size_t Axis = 0; Axis < Sweep.Axes.size(); ++Axis)
	{
		const FStudyValue& Value = Sweep.Axes[Axis].Values[Combination[Axis]];
		const auto Sets = [&](const FStudyAssignment& One)
		{
			return One.Name == Chosen.Name && One.Value == Chosen.Value;
		};
		if (Sweep.bList ? std::ranges::any_of(Value.Set, Sets)
						: Sweep.Axes[Axis].Name == Chosen.Name && Value.Label == Chosen.Value)
		{
			return true;
		}
	}
	return false;
}

/** Leaves out what "exclude" names, and says which entry leaves nothing out. */
void Exclude(const FSweep& Sweep, std::vector<FCombination>& All, std::vector<FDiagnostic>& Diagnostics)
{
	for (const std::vector<FStudyAssignment>& Chosen : Sweep.Exclude)
	{
		const size_t NumLeft = std::erase_if(All, [&](const FCombination& Combination)
			{ return std::ranges::all_of(
				  Chosen, [&](const FStudyAssignment& One) { return HasValue(Sweep, Combination, One); }); });
		if (NumLeft == 0)
		{
			const FConfigPlace& Place = Chosen[0].Place;
			Diagnostics.push_back({ESeverity::Warning, WarnSweepAxis,
				"this entry of \"exclude\" leaves nothing out: no task has these values together", Sweep.Config, Place.Line,
				Place.Column, Place.Pointer});
		}
	}
}

/** Runs Check; what it throws, and what it returns beside Known, is about Place of the sweep from then on. */
template<typename TCheck>
std::vector<FDiagnostic> FindAt(
	const FSweep& Sweep, const FConfigPlace& Place, const std::vector<FDiagnostic>& Known, const TCheck& Check)
{
	std::vector<FDiagnostic> Found;
	try
	{
		Found = Check();
	}
	catch (const FError& Error)
	{
		Found = Error.GetDiagnostics();
	}
	std::erase_if(Found, [&](const FDiagnostic& One)
		{ return std::ranges::any_of(Known, [&](const FDiagnostic& Other) { return Other.Message == One.Message; }); });
	for (FDiagnostic& One : Found)
	{
		One.File = Sweep.Config;
		One.Line = Place.Line;
		One.Column = Place.Column;
		One.Where = Place.Pointer;
	}
	return Found;
}

void Say(const FSweep& Sweep, const FStudyAxis& Axis, const std::string& Why, std::vector<FDiagnostic>& Diagnostics)
{
	Diagnostics.push_back({ESeverity::Warning, WarnSweepAxis, "the axis \"" + Axis.Name + "\" changes nothing: " + Why,
		Sweep.Config, Axis.Place.Line, Axis.Place.Column, Axis.Place.Pointer});
}

/** Checks the values of each axis with the config. Values of settings and variables were checked one by one: their first
 * and last tell whether they act. */
void CheckAxes(const FSweep& Sweep, const FSweepPlan& Plan, std::vector<FDiagnostic>& Diagnostics)
{
	const auto SetUp = [&](const std::vector<FStudyAssignment>& Set)
	{
		FSweepTask Task;
		for (const FStudyAssignment& One : Set)
		{
			Task.Set.push_back({One.Name, One.Value});
		}
		return FRunSetup(MakeTaskOptions(Plan, Task), ESceneNeed::IfNamed).Diagnostics;
	};
	const std::vector<FDiagnostic> Known = SetUp({});
	for (const FStudyAxis& Axis : Sweep.Axes)
	{
		if (Axis.Values.size() == 1)
		{
			Say(Sweep, Axis, "it has one value", Diagnostics);
		}
		std::set<std::string> Labels;
		bool bActs = false;
		std::string Why;
		for (size_t Index = 0; Index < Axis.Values.size(); ++Index)
		{
			const FStudyValue& Value = Axis.Values[Index];
			const bool bFiles = std::ranges::any_of(Value.Set, [](const FStudyAssignment& One)
				{ return Contains(GetSweepNames(), One.Name) && One.Name != "frames"; });
			if (!Labels.insert(Value.Label).second)
			{
				Say(Sweep, Axis, "it has the value \"" + Value.Label + "\" twice", Diagnostics);
			}
			if (!bFiles && Index != 0 && Index + 1 != Axis.Values.size())
			{
				continue;
			}
			const FConfigPlace Place = Value.Set.empty() ? Axis.Place : Value.Set[0].Place;
			std::string Inert;
			for (const FDiagnostic& One : FindAt(Sweep, Place, Known, [&] { return SetUp(Value.Set); }))
			{
				const bool bInert = One.Code == WarnIneffectiveValue || One.Code == WarnNotBuilt;
				Inert = bInert ? One.Message : Inert;
				if (One.Severity == ESeverity::Error)
				{
					Diagnostics.push_back(One);
				}
			}
			bActs = bActs || Inert.empty();
			Why = Inert.empty() ? Why : Inert;
		}
		if (!bActs)
		{
			Say(Sweep, Axis, Why, Diagnostics);
		}
	}
}

/** Numbers of frames that a task without pieces renders, and those before them. */
struct FTaskFrames
{
	std::vector<int> Lead;
	std::vector<int> Frames; // empty: the scene is one frame
};

FTaskFrames ChooseTaskFrames(const FSweep& Sweep, const FConfig& Config, const std::string& Own)
{
	const std::string& List = !Own.empty() ? Own : !Sweep.Frames.empty() ? Sweep.Frames : Config.Scene.Frames.Value;
	FTaskFrames Chosen;
	if (Config.Scene.Sequence.empty() && List.empty())
	{
		return Chosen;
	}
	if (List.empty())
	{
		Chosen.Frames = {Config.Scene.Frame.value_or(0)};
		return Chosen;
	}
	const std::vector<FSequenceFrame> Frames = ChooseSequenceFrames(Config, List, Sweep.FramesPlace);
	const std::vector<FSequenceFrame> Before = FindFramesBefore(Config, Frames);
	Chosen.Frames = ToVector<int>(Frames, &FSequenceFrame::Number);
	Chosen.Lead = ToVector<int>(Before, &FSequenceFrame::Number);
	Chosen.Lead.erase(
		Chosen.Lead.begin(), Chosen.Lead.end() - std::min<std::ptrdiff_t>(Sweep.Lead, std::ssize(Chosen.Lead)));
	return Chosen;
}

/** Appends the task, or its pieces and, where it is to be checked, the unsplit cut. */
void AddTask(const FSweep& Sweep, const FTaskFrames& Chosen, const FSweepTask& Whole, bool bCheck, FSweepPlan& Plan)
{
	FSweepTask Task = Whole;
	Task.Frames = FormatFrameList(Chosen.Frames);
	Task.LeadFrames = FormatFrameList(Chosen.Lead);
	if (!Sweep.Split)
	{
		Plan.Tasks.push_back(std::move(Task));
		return;
	}
	const auto Part = [&](size_t From, size_t To)
	{
		return FormatFrameList({Chosen.Frames.begin() + static_cast<std::ptrdiff_t>(From),
			Chosen.Frames.begin() + static_cast<std::ptrdiff_t>(To)});
	};
	const size_t Length = static_cast<size_t>(Sweep.Split->NumFrames);
	const size_t Lead = static_cast<size_t>(Sweep.Split->Lead);
	const size_t NumFrames = Chosen.Frames.size();
	for (size_t From = 0; From < std::max<size_t>(NumFrames, 1); From += Length)
	{
		FSweepTask Piece = Task;
		Piece.Frames = Part(From, std::min(From + Length, NumFrames));
		Piece.LeadFrames = Part(From - std::min(Lead, From), From);
		Piece.Values.push_back(Piece.Frames);
		AddUnique(Plan.Axes.back().Values, Piece.Frames);
		Plan.Tasks.push_back(std::move(Piece));
	}
	if (bCheck && NumFrames > Length)
	{
		Task.Values.emplace_back();
		Task.bUnsplit = true;
		Plan.Tasks.push_back(std::move(Task));
	}
}

} // namespace

size_t CountRendered(const FSweepTask& Task)
{
	return std::max<size_t>(1, ListTaskFrames(Task.Frames).size() + ListTaskFrames(Task.LeadFrames).size());
}

std::vector<int> ListTaskFrames(const std::string& List)
{
	std::string Ignored;
	const std::optional<FFrameList> Parsed = List.empty() ? std::nullopt : ParseFrameList(List, Ignored);
	return Parsed ? ListFrames(*Parsed, {}) : std::vector<int>();
}

double FSweepPlan::GetSeconds() const
{
	double Seconds = 0.0;
	for (const FSweepTask& Each : Tasks)
	{
		Seconds += Cost.Seconds * static_cast<double>(CountRendered(Each));
	}
	return Seconds;
}

uint64_t FSweepPlan::GetBytes() const
{
	uint64_t Bytes = 0;
	for (const FSweepTask& Each : Tasks)
	{
		Bytes += Cost.Bytes * std::max<size_t>(1, ListTaskFrames(Each.Frames).size());
	}
	return Bytes;
}

FRunOptions MakeTaskOptions(const FSweepPlan& Plan, const FSweepTask& Task)
{
	const auto Resolve = [&](const std::string& Path)
	{
		return (Files::path(Plan.Config).parent_path() / Path).lexically_normal().string();
	};
	FRunOptions Options;
	Options.ConfigFile = Plan.Config;
	Options.bMeasureEffects = Plan.bMeasure;
	Options.bUseBudget = false; // by which the measured times of a study would choose
	std::vector<FStudyAssignment> Others;
	for (const auto& [Name, Value] : Task.Set)
	{
		if (Name == "scene")
		{
			Options.ConfigPlaces.push_back("/scene/file=" + FJsonWriter::Quote(Value));
		}
		else if (Name == "engine")
		{
			Options.Engine = Value;
		}
		else if (Name == "plugin")
		{
			Options.Plugins.push_back(Resolve(Value));
		}
		else if (Name == "overlay")
		{
			Options.Overlays.push_back(Resolve(Value));
		}
		else if (Name == "resolution")
		{
			Options.ScreenPercentage = ParseAll<double>(Value);
		}
		else if (Name != "frames")
		{
			Others.push_back({Name, Value, {}});
		}
	}
	ApplyToRun(Others, Options);
	return Options;
}

std::string GetTaskValue(const FSweepTask& Task, const std::string& Name)
{
	std::string Value;
	for (const auto& [Each, Text] : Task.Set)
	{
		Value = Each == Name ? Text : Value;
	}
	return Value;
}

std::string DescribeTask(const FSweepPlan& Plan, const FSweepTask& Task)
{
	std::string Text;
	for (size_t Axis = 0; Axis < Plan.Axes.size() && Axis < Task.Values.size(); ++Axis)
	{
		const std::string& Name = Plan.Axes[Axis].Name;
		const std::string& Value = Task.Values[Axis];
		const bool bPlain = GetTaskValue(Task, Name) == Value || Name == PieceAxis;
		Text += (Text.empty() ? "" : ", ") + (Value.empty() ? "unsplit" : bPlain ? Name + " " + Value : Value);
	}
	return Text;
}

size_t CountCombinations(const FSweep& Sweep)
{
	constexpr size_t Most = 1'000'000'000;
	size_t Count = 1;
	for (const FStudyAxis& Axis : Sweep.Axes)
	{
		Count = std::min(Count * std::max<size_t>(1, Axis.Values.size()), Most);
	}
	return Count;
}

FSweepPlan PlanSweep(const FSweep& Sweep, std::vector<FDiagnostic>& Diagnostics)
{
	FSweepPlan Plan = MakePlan(Sweep);
	std::vector<FDiagnostic> Found;
	CheckAxes(Sweep, Plan, Found);
	if (HasErrors(Found))
	{
		throw FError(Found, ExitUsage);
	}
	std::vector<FCombination> All = Combine(Sweep);
	Exclude(Sweep, All, Found);
	if (Sweep.Split)
	{
		Plan.Axes.push_back({PieceAxis, {}});
	}
	FSweepInputs Inputs(Plan);
	for (const FCombination& Combination : All)
	{
		FSweepTask Task;
		FConfigPlace Place = Sweep.FramesPlace;
		for (size_t Axis = 0; Axis < Combination.size(); ++Axis)
		{
			const FStudyValue& Value = Sweep.Axes[Axis].Values[Combination[Axis]];
			Task.Values.push_back(Value.Label);
			for (const FStudyAssignment& One : Value.Set)
			{
				Task.Set.push_back({One.Name, One.Value});
				Place = One.Name == "frames" ? One.Place : Place;
			}
		}
		FTaskFrames Frames;
		const std::vector<FDiagnostic> Wrong = FindAt(Sweep, Place, Found,
			[&]
			{
				if (Sweep.Task == ESweepTask::Run)
				{
					Frames = ChooseTaskFrames(Sweep, Inputs.GetConfig(Task), GetTaskValue(Task, "frames"));
				}
				return std::vector<FDiagnostic>();
			});
		Found.insert(Found.end(), Wrong.begin(), Wrong.end());
		const bool bFirst = &Combination == All.data();
		AddTask(Sweep, Frames, Task, bFirst || (Sweep.Split && Sweep.Split->bCheckAll), Plan);
	}
	if (HasErrors(Found))
	{
		throw FError(Found, ExitUsage);
	}
	std::ranges::for_each(Plan.Tasks, [&](const FSweepTask& Task) { Inputs.Prepare(Task); });
	for (FSweepTask& Task : Plan.Tasks)
	{
		Task.Hash = Inputs.Hash(Task);
	}
	Plan.Inputs = Inputs.GetInputs();
	Diagnostics.insert(Diagnostics.end(), Found.begin(), Found.end());
	return Plan;
}

} // namespace Drydock
