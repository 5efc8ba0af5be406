// Reads a sweep, and reports all mistakes at their places.
#include "Sweep/SweepConfig.h"

#include "Budget/RunAssignment.h"
#include "Config/ConfigFields.h"
#include "Config/FrameList.h"
#include "EngineProfile.h"
#include "Math/ToInteger.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <tuple>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

const std::vector<std::string> SpecialNames = {
	"scene", "frames", "engine", "plugin", "overlay", "resolution", "precision", "storage"};

class FSweepReader
{
public:
	FSweepReader(const FConfig& InConfig, std::vector<FDiagnostic>& Diagnostics)
		: Config(InConfig)
		, Messages(InConfig.File, Diagnostics)
		, Reader(InConfig.File, SpecialNames, Diagnostics)
	{
		Sweep.Config = Config.File;
	}

	FSweep Read(const FJsonValue& Root)
	{
		WithMember(Root, "pass", EJsonType::String, [&](const FJsonValue& Value) { Sweep.Pass = Value.String; });
		WithMember(Root, "task", EJsonType::String,
			[&](const FJsonValue& Value)
			{
				const auto Found = std::ranges::find(GetSweepTaskNames(), Value.String);
				const bool bKnown = Found != GetSweepTaskNames().end(); // another name is reported
				Sweep.Task = static_cast<ESweepTask>(bKnown ? Found - GetSweepTaskNames().begin() : 0);
			});
		WithMember(Root, "frames", EJsonType::String,
			[&](const FJsonValue& Value)
			{
				CheckFrames(Value);
				Sweep.Frames = Value.String;
				Sweep.FramesPlace = PlaceOf(Value);
			});
		Sweep.Lead = ReadCount(Root, "lead", 0);
		WithMember(Root, "split", EJsonType::Object,
			[&](const FJsonValue& Value) {
				Sweep.Split = {ReadCount(Value, "frames", 1), ReadCount(Value, "lead", 0), Value.GetString("check") == "all"};
			});
		ReadBool(Root, "measureEffects", Sweep.bMeasure);
		Sweep.bExr = Contains(Root.GetElements("outputs"), "exr", &FJsonValue::String);
		ReadAxes(Root);
		for (const FJsonValue& Value : Root.GetElements("exclude"))
		{
			Sweep.Exclude.push_back(ReadChosen(Value));
		}
		std::erase(Sweep.Exclude, std::vector<FStudyAssignment>());
		WithMember(Root, "against", EJsonType::Object, [&](const FJsonValue& Value) { Sweep.Against = ReadChosen(Value); });
		CheckTask(Root);
		return Sweep;
	}

private:
	int ReadCount(const FJsonValue& Object, const char* Key, int Least)
	{
		constexpr double Most = 1'000'000;
		int Count = Least;
		WithMember(Object, Key, EJsonType::Number,
			[&](const FJsonValue& Value)
			{
				if (Value.Number != std::floor(Value.Number) || Value.Number < Least || Value.Number > Most)
				{
					Messages.Error(ErrorBadValue, Value,
						std::string("\"") + Key + "\" must be a whole number, " + std::to_string(Least) +
							" to 1000000");
					return;
				}
				Count = ToInteger<int>(Value.Number);
			});
		return Count;
	}

	void CheckFrames(const FJsonValue& Value)
	{
		std::string Error;
		if (!ParseFrameList(Value.Type == EJsonType::String ? Value.String : "", Error))
		{
			Messages.Error(ErrorBadValue, Value, Error);
		}
	}

	/** A value of one name. The special ones are checked here, as far as no file is opened. */
	std::optional<FStudyAssignment> ReadAssignment(
		const std::string& Name, const FJsonValue& NameAt, const FJsonValue& Value)
	{
		const std::optional<FStudyAssignment> Read = Reader.Read(Name, NameAt, Value);
		if (!Read)
		{
			return Read;
		}
		if (Name == "engine")
		{
			CheckIsOneOf(Value, Read->Value, ToVector<std::string>(GetEngineProfiles(), &FEngineProfile::GetVersion),
				"engine version", Messages);
		}
		else if (Name == "frames")
		{
			CheckFrames(Value);
		}
		else if (Name == "resolution" &&
				 (Value.Type != EJsonType::Number || !(Value.Number > 0.0) || Value.Number > 400.0))
		{
			Messages.Error(ErrorBadValue, Value, "resolution must be a number of percent, above 0 and up to 400");
		}
		else if (Name == "plugin" || Name == "overlay")
		{
			std::error_code Ignored;
			if (!Files::exists(Config.Resolve(Value.String), Ignored))
			{
				Messages.Error(ErrorBadValue, Value, "there is no " + Name + " " + Config.Resolve(Value.String));
			}
		}
		return Read;
	}

	std::vector<FStudyAssignment> ReadAssignments(const FJsonValue& Object)
	{
		std::vector<FStudyAssignment> Set;
		for (const auto& [Name, Value] : Object.Members)
		{
			if (std::optional<FStudyAssignment> Assignment = ReadAssignment(Name, Value, Value))
			{
				Set.push_back(std::move(*Assignment));
			}
		}
		return Set;
	}

	/** {"label": "...", "set": {...}} */
	FStudyValue ReadNamedValue(const FJsonValue& Value)
	{
		const FJsonValue* const Set = Value.Find("set");
		if (Value.GetString("label").empty() || Set == nullptr || Set->Type != EJsonType::Object ||
			Value.Members.size() != 2)
		{
			Messages.Error(ErrorWrongType, Value,
				"a value that sets several things must be {\"label\": text, \"set\": {name: value}}");
			return {};
		}
		return {Value.GetString("label"), ReadAssignments(*Set)};
	}

	void ReadAxis(const FJsonValue& Value)
	{
		const FJsonValue* const Name = Value.Find("name");
		const FJsonValue* const Values = Value.Find("values");
		if (Name == nullptr || Name->Type != EJsonType::String || Values == nullptr)
		{
			return; // reported
		}
		FStudyAxis Axis;
		Axis.Name = Name->String;
		Axis.Place = PlaceOf(Value);
		if (Values->Type != EJsonType::Array || Values->Elements.empty())
		{
			Messages.Error(ErrorWrongType, *Values, "\"values\" must be an array of at least one value");
		}
		if (Contains(Sweep.Axes, Axis.Name, &FStudyAxis::Name))
		{
			Messages.Error(ErrorBadValue, *Name, "there are two axes \"" + Axis.Name + "\"");
		}
		const bool bPlain = std::ranges::any_of(
			Values->Elements, [](const FJsonValue& Element) { return Element.Type != EJsonType::Object; });
		if (bPlain && !Reader.CheckName(Axis.Name, *Name))
		{
			return; // once, not for each value
		}
		for (const FJsonValue& Element : Values->Elements)
		{
			if (Element.Type == EJsonType::Object)
			{
				Axis.Values.push_back(ReadNamedValue(Element));
			}
			else if (std::optional<FStudyAssignment> Assignment = ReadAssignment(Axis.Name, *Name, Element))
			{
				Axis.Values.push_back({Assignment->Value, {*Assignment}});
			}
		}
		Sweep.Axes.push_back(std::move(Axis));
	}

	void ReadAxes(const FJsonValue& Root)
	{
		const FJsonValue* const Axes = Root.Find("axes");
		const FJsonValue* const List = Root.Find("list");
		if ((Axes == nullptr) == (List == nullptr))
		{
			Messages.Error(ErrorMissingKey, Root, "a sweep has either \"axes\", which are combined, or a \"list\"");
		}
		for (const FJsonValue& Axis : Root.GetElements("axes"))
		{
			ReadAxis(Axis);
		}
		FStudyAxis Cases{.Name = "case"};
		for (const FJsonValue& Entry : Root.GetElements("list"))
		{
			const std::vector<FStudyAssignment> Set = ReadAssignments(Entry);
			Cases.Values.push_back({JoinText(Set, ", ",
										[](const FStudyAssignment& One) { return One.Name + " " + One.Value; }),
				Set});
		}
		if (List != nullptr)
		{
			Sweep.bList = true;
			Cases.Place = PlaceOf(*List);
			Sweep.Axes.push_back(std::move(Cases));
		}
	}

	/** {axis: value}: values that axes have, or in a list {name: value} of an entry. */
	std::vector<FStudyAssignment> ReadChosen(const FJsonValue& Object)
	{
		std::vector<FStudyAssignment> Chosen;
		for (const auto& [Name, Value] : Object.Members)
		{
			const std::optional<std::string> Text = ReadValueText(Value, Messages);
			const FStudyAxis* const Axis = FindItem(Sweep.Axes, Sweep.bList ? "case" : Name, &FStudyAxis::Name);
			if (Axis == nullptr)
			{
				const auto Names = ToVector<std::string>(Sweep.Axes, &FStudyAxis::Name);
				Messages.ErrorAtKey(ErrorUnknownValue, Value,
					"there is no axis \"" + Name + "\": " + JoinText(Names) + Messages.Suggest(Name, Names));
				continue;
			}
			if (!Text)
			{
				continue;
			}
			std::vector<std::string> Known;
			for (const FStudyValue& Each : Axis->Values)
			{
				if (!Sweep.bList)
				{
					Known.push_back(Each.Label);
				}
				else if (const FStudyAssignment* One = FindItem(Each.Set, Name, &FStudyAssignment::Name))
				{
					AddUnique(Known, One->Value);
				}
			}
			CheckIsOneOf(Value, *Text, Known, ("value of " + Name).c_str(), Messages);
			Chosen.push_back({Name, *Text, PlaceOf(Value)});
		}
		return Chosen;
	}

	/** What only frames of a run have. */
	void CheckTask(const FJsonValue& Root)
	{
		for (const char* const Key : {"frames", "lead", "split", "against", "outputs"})
		{
			const FJsonValue* const Value = Root.Find(Key);
			if (Value != nullptr && Sweep.Task != ESweepTask::Run)
			{
				Messages.ErrorAtKey(ErrorBadValue, *Value,
					"a sweep of \"" + GetSweepTaskNames()[static_cast<size_t>(Sweep.Task)] + "\" has no \"" + Key +
						"\"");
			}
		}
		const FJsonValue* const Lead = Root.Find("lead");
		if (Lead != nullptr && Sweep.Split)
		{
			Messages.ErrorAtKey(ErrorBadValue, *Lead, "with \"split\" the lead of its pieces stands in \"split\"");
		}
	}

	const FConfig& Config;
	FConfigMessages Messages;
	FRunAssignmentReader Reader;
	FSweep Sweep;
};

} // namespace

const std::vector<std::string>& GetSweepTaskNames()
{
	static const std::vector<std::string> Names = {"run", "study", "hazards"};
	return Names;
}

const std::vector<std::string>& GetSweepNames()
{
	return SpecialNames;
}

FSweep ReadSweep(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	std::vector<FDiagnostic> Found;
	FSweep Sweep;
	if (Config.Sweep.Type == EJsonType::Object)
	{
		Sweep = FSweepReader(Config, Found).Read(Config.Sweep);
	}
	else
	{
		FConfigMessages(Config.File, Found)
			.Error(ErrorMissingKey, FConfigPlace{1, 1, ""}, "the config has no \"sweep\": docs/sweeps.md tells what it holds");
	}
	std::ranges::stable_sort(Found, {}, [](const FDiagnostic& One) { return std::tuple(One.Line, One.Column); });
	Diagnostics.insert(Diagnostics.end(), Found.begin(), Found.end());
	return Sweep;
}

} // namespace Drydock
