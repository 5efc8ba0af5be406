// Combines the values of a sweep's axes, leaves out what is excluded, and cuts frames into pieces.
#include "Sweep/SweepPlanner.h"

#include "Budget/StudyConfig.h"
#include "Config/ConfigFields.h"
#include "Config/FrameList.h"
#include "Config/FrameSequence.h"
#include "Math/ToInteger.h"
#include "RangeTools.h"
#include "Run/RunSetup.h"
#include "Sweep/SweepErrors.h"
#include "Sweep/SweepInputs.h"
#include "Text/TextFormat.h"
#include "TextTools.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>

namespace Drydock
{

namespace
{

const std::vector<std::string> SweepNames = {"scene", "frames", "engine", "plugin", "overlay", "resolution"};

/** A chosen value of an axis. */
struct FSweepChoice
{
	size_t Axis = 0;
	std::string Label;
};

/** The frames that a task renders; none of a scene that is one frame. */
struct FSweepFrames
{
	std::vector<int> Lead;
	std::vector<int> Frames;
};

class FSweepPlanner
{
public:
	FSweepPlanner(const FConfig& InConfig, const FJsonValue& InRoot)
		: Config(InConfig)
		, Root(InRoot)
		, Messages(InConfig.File, Found)
		, Axes(ReadAxes(InConfig, InRoot, SweepNames, Found))
		, Inputs(Plan, true)
	{
	}

	FSweepPlan MakePlan(std::vector<FDiagnostic>& Remarks)
	{
		ReadMembers();
		ThrowMistakes(); // of names and values
		std::ranges::for_each(Axes, [this](const FStudyAxis& Axis) { CheckAxis(Axis); });
		ThrowMistakes(); // of values with the config
		AddTasks();
		ThrowMistakes(); // of frames
		std::ranges::for_each(Plan.Tasks, [this](FSweepTask& Task) { Task.Hash = Inputs.Hash(Task); });
		Plan.Inputs = Inputs.GetInputs();
		Remarks.insert(Remarks.end(), Found.begin(), Found.end());
		return Plan;
	}

private:
	void ThrowMistakes()
	{
		std::ranges::stable_sort(Found, {}, [](const FDiagnostic& One) { return std::tuple(One.Line, One.Column); });
		if (HasErrors(Found))
		{
			throw FError(Found, ExitUsage);
		}
	}

	int ReadCount(const FJsonValue& Object, const char* Key, int Least)
	{
		constexpr double Most = 1'000'000;
		const FJsonValue* const Value = Object.Find(Key);
		const bool bGood = Value != nullptr && Value->Type == EJsonType::Number && Value->Number >= Least &&
						   Value->Number <= Most && Value->Number == ToInteger<int>(Value->Number);
		if (Value != nullptr && Value->Type == EJsonType::Number && !bGood)
		{
			Messages.Error(ErrorBadValue, *Value,
				std::string("\"") + Key + "\" must be a whole number, " + std::to_string(Least) + " to 1000000");
		}
		return bGood ? ToInteger<int>(Value->Number) : Least;
	}

	/** All but the axes. */
	void ReadMembers()
	{
		Plan.Config = std::filesystem::absolute(Config.File).lexically_normal().string();
		const std::string Kind = Root.GetString("task");
		Plan.Kind = Kind.empty() ? "run" : Kind;
		Plan.Pass = Root.GetString("pass");
		Plan.bExr = Contains(Root.GetElements("outputs"), "exr", &FJsonValue::String);
		ReadBool(Root, "measureEffects", Plan.bMeasure);
		Lead = ReadCount(Root, "lead", 0);
		Split = Root.Find("split");
		PieceLength = Split != nullptr ? ReadCount(*Split, "frames", 1) : 0;
		PieceLead = Split != nullptr ? ReadCount(*Split, "lead", 0) : 0;
		if (Root.GetElements("axes").empty())
		{
			Messages.Error(ErrorMissingKey, Root, "\"axes\" is missing: a sweep varies at least one thing");
		}
		for (const FStudyAxis& Axis : Axes)
		{
			Plan.Axes.push_back({Axis.Name, ToVector<std::string>(Axis.Values, &FStudyValue::Label)});
		}
		for (const FJsonValue& Value : Root.GetElements("exclude"))
		{
			Excluded.push_back({ReadChoices(Value), PlaceOf(Value)});
		}
		const FJsonValue* const Against = Root.Find("against");
		for (const FSweepChoice& One : Against != nullptr ? ReadChoices(*Against) : std::vector<FSweepChoice>())
		{
			Plan.Against.push_back({Plan.Axes[One.Axis].Name, One.Label});
		}
		for (const char* const Key : {"frames", "lead", "split", "against", "outputs", "measureEffects"})
		{
			const FJsonValue* const Value = Root.Find(Key);
			if (Value != nullptr && Plan.Kind != "run")
			{
				Messages.ErrorAtKey(ErrorBadValue, *Value, "a sweep of " + Plan.Kind + " has no \"" + Key + "\"");
			}
		}
		if (Split != nullptr && Root.Find("lead") != nullptr)
		{
			Messages.ErrorAtKey(
				ErrorBadValue, *Root.Find("lead"), "with \"split\" the lead of pieces stands in \"split\"");
		}
	}

	/** {axis: value}; what no axis has is reported. */
	std::vector<FSweepChoice> ReadChoices(const FJsonValue& Object)
	{
		std::vector<FSweepChoice> Choices;
		for (const auto& [Name, Value] : Object.Members)
		{
			const auto Names = ToVector<std::string>(Axes, &FStudyAxis::Name);
			const auto Axis = static_cast<size_t>(std::ranges::find(Names, Name) - Names.begin());
			const std::string Label = Value.Type == EJsonType::Number ? NumberText(Value.Number)
									  : Value.Type == EJsonType::Bool ? (Value.Bool ? "true" : "false")
																	  : Value.String;
			if (Axis == Names.size())
			{
				Messages.ErrorAtKey(ErrorUnknownValue, Value,
					"there is no axis \"" + Name + "\": " + JoinText(Names) + Messages.Suggest(Name, Names));
			}
			else if (!Contains(Plan.Axes[Axis].Values, Label))
			{
				Messages.Error(ErrorUnknownValue, Value,
					"the axis \"" + Name + "\" has no value \"" + Label + "\": " +
						ListSome(Plan.Axes[Axis].Values, 12) + Messages.Suggest(Label, Plan.Axes[Axis].Values));
			}
			else
			{
				Choices.push_back({Axis, Label});
			}
		}
		return Choices;
	}

	/** Calls Check; what it throws is about that place of the sweep. */
	template<typename TCheck>
	void CallAt(const FConfigPlace& Place, const TCheck& Check)
	{
		try
		{
			Check();
		}
		catch (const FError& Error)
		{
			for (const FDiagnostic& One : Error.GetDiagnostics())
			{
				if (One.Severity == ESeverity::Error)
				{
					Messages.Error(One.Code, Place, One.Message);
				}
			}
		}
	}

	/** Values were read one by one; here they meet the config and its files. */
	void CheckAxis(const FStudyAxis& Axis)
	{
		std::set<std::string> Labels;
		if (Axis.Values.size() == 1)
		{
			Messages.Warn(
				WarnSweepAxis, Axis.Place, "the axis \"" + Axis.Name + "\" changes nothing: it has one value");
		}
		if (std::ranges::count(Axes, Axis.Name, &FStudyAxis::Name) > 1)
		{
			Messages.Error(ErrorBadValue, Axis.Place, "there are two axes \"" + Axis.Name + "\"");
		}
		for (const FStudyValue& Value : Axis.Values)
		{
			if (!Labels.insert(Value.Label).second)
			{
				Messages.Error(ErrorBadValue, Axis.Place,
					"the axis \"" + Axis.Name + "\" has the value \"" + Value.Label + "\" twice");
			}
			for (const FStudyAssignment& One : Value.Set)
			{
				const std::optional<double> Percent = ParseAll<double>(One.Value);
				if (One.Name == "resolution" && !(Percent && *Percent > 0.0 && *Percent <= 400.0))
				{
					Messages.Error(ErrorBadValue, One.Place, "resolution must be a percentage, above 0 and up to 400");
				}
				else if (One.Name == "engine")
				{
					CallAt(One.Place,
						[&] {
							FRunSetup(MakeTaskOptions(Plan, {{One.Name, One.Value}}), ESceneNeed::IfNamed);
						});
				}
				else if (One.Name == "scene" || One.Name == "plugin" || One.Name == "overlay")
				{
					FSweepTask Bare;
					Bare.Set = {{One.Name, One.Value}};
					CallAt(One.Place, [&] { Inputs.Prepare(Bare); });
				}
			}
		}
	}

	/** Every combination: the index of a value for each axis, the last axis the fastest. */
	std::vector<std::vector<size_t>> Combine()
	{
		std::vector<std::vector<size_t>> All(1);
		for (const FStudyAxis& Axis : Axes)
		{
			std::vector<std::vector<size_t>> Longer;
			for (const std::vector<size_t>& Shorter : All)
			{
				for (size_t Value = 0; Value < Axis.Values.size(); ++Value)
				{
					Longer.push_back(Shorter);
					Longer.back().push_back(Value);
				}
			}
			All = std::move(Longer);
		}
		for (const auto& [Choices, Place] : Excluded)
		{
			const auto IsOne = [&, &Chosen = Choices](const std::vector<size_t>& Combination)
			{
				return !Chosen.empty() &&
					   std::ranges::all_of(Chosen, [&](const FSweepChoice& One)
						   { return Plan.Axes[One.Axis].Values[Combination[One.Axis]] == One.Label; });
			};
			if (std::erase_if(All, IsOne) == 0)
			{
				Messages.Warn(WarnSweepAxis, Place, "this leaves nothing out: no task is left that has these values");
			}
		}
		return All;
	}

	void AddTasks()
	{
		const std::vector<std::vector<size_t>> All = Combine();
		if (Split != nullptr)
		{
			Plan.Axes.push_back({"piece", {}});
		}
		const FJsonValue* const Given = Root.Find("frames");
		for (const std::vector<size_t>& Combination : All)
		{
			FSweepTask Task;
			std::string List = Given != nullptr ? Given->String : "";
			FConfigPlace Place = Given != nullptr ? PlaceOf(*Given) : PlaceOf(Root);
			for (size_t Axis = 0; Axis < Combination.size(); ++Axis)
			{
				const FStudyValue& Value = Axes[Axis].Values[Combination[Axis]];
				Task.Values.push_back(Value.Label);
				for (const FStudyAssignment& One : Value.Set)
				{
					Task.Set.push_back({One.Name, One.Value});
					List = One.Name == "frames" ? One.Value : List;
					Place = One.Name == "frames" ? One.Place : Place;
				}
			}
			CallAt(Place, [&] { AddTask(Task, ChooseFrames(Task, List)); });
		}
	}

	FSweepFrames ChooseFrames(const FSweepTask& Task, const std::string& Given)
	{
		const FConfig& OfTask = Inputs.Prepare(Task);
		const std::string& List = Given.empty() ? OfTask.Scene.Frames.Value : Given;
		if (Plan.Kind != "run" || (OfTask.Scene.Sequence.empty() && List.empty()))
		{
			return {};
		}
		if (List.empty())
		{
			return {{}, {OfTask.Scene.Frame.value_or(0)}};
		}
		const std::vector<FSequenceFrame> Frames = ChooseSequenceFrames(OfTask, List, {});
		std::vector<FSequenceFrame> Before = FindFramesBefore(OfTask, Frames);
		Before.erase(Before.begin(), Before.end() - std::min<std::ptrdiff_t>(Lead, std::ssize(Before)));
		return {ToVector<int>(Before, &FSequenceFrame::Number), ToVector<int>(Frames, &FSequenceFrame::Number)};
	}

	/** The task, or its pieces; behind the pieces of the first cut that cut unsplit. */
	void AddTask(FSweepTask Task, const FSweepFrames& Chosen)
	{
		Task.Frames = FormatFrameList(Chosen.Frames);
		Task.LeadFrames = FormatFrameList(Chosen.Lead);
		const bool bFirst = Plan.Tasks.empty();
		if (PieceLength > 0 && Chosen.Frames.empty())
		{
			throw FError({.Code = ErrorBadValue, .Message = "\"split\" needs the frames of a sequence"}, ExitUsage);
		}
		for (size_t From = 0; PieceLength > 0 && From < Chosen.Frames.size(); From += static_cast<size_t>(PieceLength))
		{
			const auto At = Chosen.Frames.begin() + static_cast<std::ptrdiff_t>(From);
			FSweepTask Piece = Task;
			Piece.Frames = FormatFrameList({At, At + std::min<std::ptrdiff_t>(PieceLength, Chosen.Frames.end() - At)});
			Piece.LeadFrames =
				FormatFrameList({At - std::min<std::ptrdiff_t>(PieceLead, At - Chosen.Frames.begin()), At});
			Piece.Values.push_back(Piece.Frames);
			AddUnique(Plan.Axes.back().Values, Piece.Frames);
			Plan.Tasks.push_back(std::move(Piece));
		}
		if (PieceLength == 0 || bFirst)
		{
			Task.bUnsplit = PieceLength > 0;
			Task.Values.resize(Plan.Axes.size());
			Plan.Tasks.push_back(std::move(Task));
		}
	}

	const FConfig& Config;
	const FJsonValue& Root;
	std::vector<FDiagnostic> Found;
	FConfigMessages Messages;
	const std::vector<FStudyAxis> Axes;
	std::vector<std::pair<std::vector<FSweepChoice>, FConfigPlace>> Excluded;
	const FJsonValue* Split = nullptr;
	int Lead = 0;
	int PieceLength = 0; // 0: frames stay together
	int PieceLead = 0;
	FSweepPlan Plan;
	FSweepInputs Inputs;
};

} // namespace

FJsonValue FindSweep(const FConfigDocument& Document)
{
	const FJsonValue* const Sweep = Document.Root.Find("sweep");
	if (Sweep == nullptr || Sweep->Type != EJsonType::Object)
	{
		throw FError({.Code = ErrorMissingKey,
						 .Message = "the config has no \"sweep\": docs/sweeps.md describes it",
						 .File = Document.File},
			ExitUsage);
	}
	return *Sweep;
}

size_t CountCombinations(const FJsonValue& Sweep)
{
	constexpr size_t Most = 1'000'000'000;
	size_t Count = 1;
	for (const FJsonValue& Axis : Sweep.GetElements("axes"))
	{
		Count = std::min(Most, Count * std::max<size_t>(1, Axis.GetElements("values").size()));
	}
	return Count;
}

FSweepPlan PlanSweep(const FConfig& Config, const FJsonValue& Sweep, std::vector<FDiagnostic>& Remarks)
{
	return FSweepPlanner(Config, Sweep).MakePlan(Remarks);
}

} // namespace Drydock
