// Reads a sweep key by key, and reports all mistakes at their places.
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
#include <map>
#include <tuple>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

const std::vector<std::string> SpecialNames = {
	"scene", "frames", "engine", "plugin", "overlay", "resolution", "precision", "storage"};

/** The keys of each object and the types of their values. */
const std::map<std::string, std::map<std::string, EJsonType>> SweepKeys = {
	{"",
		{{"$schema", EJsonType::String}, {"config", EJsonType::String}, {"task", EJsonType::String},
			{"pass", EJsonType::String}, {"frames", EJsonType::String}, {"lead", EJsonType::Number},
			{"split", EJsonType::Object}, {"axes", EJsonType::Array}, {"list", EJsonType::Array},
			{"exclude", EJsonType::Array}, {"against", EJsonType::Object}, {"outputs", EJsonType::Array},
			{"measureEffects", EJsonType::Bool}}},
	{"split", {{"frames", EJsonType::Number}, {"lead", EJsonType::Number}, {"check", EJsonType::String}}},
	{"axis", {{"name", EJsonType::String}, {"values", EJsonType::Array}}},
	{"value", {{"label", EJsonType::String}, {"set", EJsonType::Object}}},
};

const char* DescribeType(EJsonType Type)
{
	FJsonValue Value;
	Value.Type = Type;
	return Value.Describe();
}

class FSweepReader
{
public:
	FSweepReader(const std::string& File, std::vector<FDiagnostic>& Diagnostics)
		: Messages(File, Diagnostics)
		, Reader(File, SpecialNames, Diagnostics)
	{
		Sweep.File = File;
	}

	FSweep Read(const FJsonValue& Root)
	{
		if (!CheckKeys(Root, "", {"config"}))
		{
			return Sweep;
		}
		WithMember(Root, "config", EJsonType::String, [&](const FJsonValue& Value) { Sweep.Config = Resolve(Value); });
		WithMember(Root, "pass", EJsonType::String, [&](const FJsonValue& Value) { Sweep.Pass = Value.String; });
		WithMember(Root, "task", EJsonType::String,
			[&](const FJsonValue& Value)
			{
				const auto& Names = GetSweepTaskNames();
				CheckIsOneOf(Value, Value.String, Names, "task", Messages);
				const auto Found = std::ranges::find(Names, Value.String);
				Sweep.Task = Found == Names.end() ? ESweepTask::Run : static_cast<ESweepTask>(Found - Names.begin());
			});
		WithMember(Root, "frames", EJsonType::String,
			[&](const FJsonValue& Value)
			{
				CheckFrames(Value);
				Sweep.Frames = Value.String;
				Sweep.FramesPlace = PlaceOf(Value);
			});
		Sweep.Lead = ReadCount(Root, "lead", 0);
		WithMember(Root, "split", EJsonType::Object, [&](const FJsonValue& Value) { ReadSplit(Value); });
		ReadBool(Root, "measureEffects", Sweep.bMeasure);
		ReadOutputs(Root);
		ReadAxes(Root);
		ReadExclude(Root);
		WithMember(Root, "against", EJsonType::Object,
			[&](const FJsonValue& Value)
			{
				Sweep.Against = ReadChosen(Value);
				Sweep.AgainstPlace = PlaceOf(Value);
			});
		CheckTask(Root);
		return Sweep;
	}

	/** False where Value is not an object. Reports unknown keys, wrong types and missing keys. */
	bool CheckKeys(const FJsonValue& Value, const std::string& Object, const std::vector<std::string>& Required)
	{
		if (Value.Type != EJsonType::Object)
		{
			Messages.Error(ErrorWrongType, Value, std::string("expected an object, found ") + Value.Describe());
			return false;
		}
		const std::map<std::string, EJsonType>& Keys = SweepKeys.at(Object);
		std::vector<std::string> Names;
		for (const auto& [Name, Type] : Keys)
		{
			Names.push_back(Name);
		}
		for (const auto& [Key, Member] : Value.Members)
		{
			const auto Found = Keys.find(Key);
			if (Found == Keys.end())
			{
				Messages.ErrorAtKey(ErrorUnknownKey, Member, "unknown key" + Messages.Suggest(Key, Names));
			}
			else if (Member.Type != Found->second && Member.Type != EJsonType::Invalid)
			{
				Messages.Error(ErrorWrongType, Member,
					std::string("expected ") + DescribeType(Found->second) + ", found " + Member.Describe());
			}
		}
		for (const std::string& Name : Required)
		{
			if (Value.Find(Name) == nullptr)
			{
				Messages.Error(ErrorMissingKey, Value, "\"" + Name + "\" is missing");
			}
		}
		return true;
	}

private:
	/** A path of the sweep, relative to its own folder, as one from the working folder. */
	std::string Resolve(const FJsonValue& Value) const
	{
		return (Files::path(Sweep.File).parent_path() / Value.String).lexically_normal().string();
	}

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

	void ReadSplit(const FJsonValue& Value)
	{
		CheckKeys(Value, "split", {"frames", "lead"});
		FSweepSplit Split;
		Split.NumFrames = ReadCount(Value, "frames", 1);
		Split.Lead = ReadCount(Value, "lead", 0);
		WithMember(Value, "check", EJsonType::String,
			[&](const FJsonValue& Check)
			{
				CheckIsOneOf(Check, Check.String, {"first", "all"}, "check", Messages);
				Split.bCheckAll = Check.String == "all";
			});
		Sweep.Split = Split;
	}

	void ReadOutputs(const FJsonValue& Root)
	{
		for (const FJsonValue& Value : Root.GetElements("outputs"))
		{
			CheckIsOneOf(Value, Value.String, {"png", "exr"}, "output", Messages);
			Sweep.bExr = Sweep.bExr || Value.String == "exr";
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
			if (!Files::exists(Resolve(Value), Ignored))
			{
				Messages.Error(ErrorBadValue, Value, "there is no " + Name + " " + Resolve(Value));
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

	void ReadAxis(const FJsonValue& Value)
	{
		if (!CheckKeys(Value, "axis", {"name", "values"}))
		{
			return;
		}
		const FJsonValue* const Name = Value.Find("name");
		const FJsonValue* const Values = Value.Find("values");
		if (Name == nullptr || Name->Type != EJsonType::String || Values == nullptr ||
			Values->Type != EJsonType::Array)
		{
			return; // reported
		}
		FStudyAxis Axis;
		Axis.Name = Name->String;
		Axis.Place = PlaceOf(Value);
		if (Values->Elements.empty())
		{
			Messages.Error(ErrorWrongLength, *Values, "\"values\" must have at least one value");
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
				CheckKeys(Element, "value", {"label", "set"});
				const FJsonValue* const Set = Element.Find("set");
				Axis.Values.push_back({Element.GetString("label"),
					Set != nullptr ? ReadAssignments(*Set) : std::vector<FStudyAssignment>()});
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
			if (Entry.Type != EJsonType::Object)
			{
				Messages.Error(
					ErrorWrongType, Entry, std::string("expected {name: value, ...}, found ") + Entry.Describe());
				continue;
			}
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

	void ReadExclude(const FJsonValue& Root)
	{
		for (const FJsonValue& Value : Root.GetElements("exclude"))
		{
			if (Value.Type != EJsonType::Object || Value.Members.empty())
			{
				Messages.Error(ErrorWrongType, Value, "expected {axis: value, ...}");
				continue;
			}
			Sweep.Exclude.push_back(ReadChosen(Value));
		}
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

	FConfigMessages Messages;
	FRunAssignmentReader Reader;
	FSweep Sweep;
};

/** Nothing after a syntax error. */
std::optional<FJsonValue> Parse(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	bool bSyntaxError = false;
	FJsonValue Root = ParseJson(Text, File, Diagnostics, bSyntaxError);
	return bSyntaxError ? std::nullopt : std::optional(std::move(Root));
}

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

std::optional<std::string> ReadSweepConfigPath(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	const std::optional<FJsonValue> Root = Parse(Text, File, Diagnostics);
	if (!Root)
	{
		return std::nullopt;
	}
	const std::string Config = Root->GetString("config");
	if (Config.empty())
	{
		FSweepReader(File, Diagnostics).CheckKeys(*Root, "", {"config"});
		return std::nullopt;
	}
	return (Files::path(File).parent_path() / Config).lexically_normal().string();
}

FSweep ReadSweep(const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	std::vector<FDiagnostic> Found;
	const std::optional<FJsonValue> Root = Parse(Text, File, Found);
	FSweep Sweep = Root ? FSweepReader(File, Found).Read(*Root) : FSweep();
	std::ranges::stable_sort(Found, {}, [](const FDiagnostic& One) { return std::tuple(One.Line, One.Column); });
	Diagnostics.insert(Diagnostics.end(), Found.begin(), Found.end());
	return Sweep;
}

} // namespace Drydock
