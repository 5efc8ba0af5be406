// Reads "study" and "budget" of a config, and reports mistakes in them.
#include "Budget/StudyConfig.h"

#include "Config/ReadConfig.h"
#include "Budget/BlurNames.h"
#include "Config/ConfigPlaces.h"
#include "Config/ConfigReader.h"
#include "HAL/IConsoleManager.h"
#include "Math/ToInteger.h"
#include "Picture/ImageMetrics.h"
#include "PostProcessSettingsReflection.h"
#include "Text/TextFormat.h"
#include "TextTools.h"
#include "RangeTools.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

constexpr int MaxRepetitions = 1000;
constexpr size_t MaxVariants = 10000;

const std::vector<std::string> GBlurNames = {"algorithm", "sigma", "input", "storage", "precision", "resolution"};
const std::vector<std::string> GInputs = {"scene", "point", "edge"};
const std::vector<std::string> GResolutions = {"100", "50", "25", "12.5"};
const std::vector<std::string> GPrecisions = {"float", "double"};
const std::vector<std::string> GFrameStorages = {"native", "float32", "float64"};

/** False if the value is not a number, a string, true or false, which is reported. */
bool ReadValueText(const FJsonValue& Value, std::string& OutText, FConfigMessages& Messages)
{
	switch (Value.Type)
	{
	case EJsonType::Number:
		OutText = NumberText(Value.Number);
		return true;
	case EJsonType::String:
		OutText = Value.String;
		return true;
	case EJsonType::Bool:
		OutText = Value.Bool ? "true" : "false";
		return true;
	case EJsonType::Invalid:
		return false; // reported
	default:
		Messages.Error(ErrorWrongType, Value,
			std::string("expected a number, a string or true or false, found ") + Value.Describe());
		return false;
	}
}

/** Reads the study of one config. */
class FStudyReader
{
public:
	/** FurtherNames: of axes, which the caller knows what to do with. */
	FStudyReader(const FConfig& InConfig, std::vector<FDiagnostic>& InDiagnostics,
		const std::vector<std::string>& FurtherNames = {})
		: Config(InConfig)
		, Diagnostics(InDiagnostics)
		, Messages(InConfig.File, InDiagnostics)
	{
		FrameNames.insert(FrameNames.end(), FurtherNames.begin(), FurtherNames.end());
	}

	std::vector<FStudyAxis> ReadAxes(const std::vector<FJsonValue>& Axes)
	{
		for (const FJsonValue& Axis : Axes)
		{
			ReadAxis(Axis);
		}
		return Study.Axes;
	}

	FStudy Read(const FJsonValue& Value)
	{
		const std::vector<FJsonValue>& Axes = Value.GetElements("axes");
		Study.bBlur = std::ranges::any_of(Axes, NamesAlgorithm);
		ReadAxes(Axes);
		const FJsonValue* Given = Value.Find("axes");
		if (Given != nullptr && Given->Type == EJsonType::Array && Axes.empty())
		{
			Messages.Error(ErrorMissingKey, Value, "\"axes\" is missing: a study varies at least one thing");
		}
		ReadReference(Value);
		ReadMetrics(Value);
		ReadRepetitions(Value);
		ReadRegion(Value);
		if (const FJsonValue* Measure = Value.Find("measure"); Measure != nullptr && Measure->Type == EJsonType::String)
		{
			Study.Measure = Measure->String;
		}
		if (const FJsonValue* Passes = Value.Find("passes"); Passes != nullptr && Passes->Type == EJsonType::String)
		{
			Study.Passes = Passes->String;
		}
		if (const FJsonValue* Current = Value.Find("current"); Current != nullptr && Current->Type == EJsonType::Object)
		{
			Study.Current = ReadAssignments(*Current);
		}
		CheckSize(Value);
		return std::move(Study);
	}

	FStudyBudget ReadBudget(const FJsonValue& Value)
	{
		FStudyBudget Budget;
		Budget.bDefault = false;
		if (const FJsonValue* Metric = Value.Find("metric"); Metric != nullptr && Metric->Type == EJsonType::String)
		{
			CheckIsOneOf(*Metric, Metric->String, GetMetricNames(), "metric");
			Budget.Metric = Metric->String;
		}
		const auto ReadNumber = [&](const char* Key, std::optional<double>& Number)
		{
			const FJsonValue* Member = Value.Find(Key);
			if (Member == nullptr || Member->Type != EJsonType::Number)
			{
				return;
			}
			if (!(Member->Number > 0.0))
			{
				Messages.Error(ErrorBadValue, *Member, std::string("\"") + Key + "\" must be above 0");
				return;
			}
			Number = Member->Number;
		};
		ReadNumber("max", Budget.Max);
		ReadNumber("ms", Budget.Ms);
		if (Value.Find("max") == nullptr && Value.Find("ms") == nullptr)
		{
			Messages.Error(ErrorMissingKey, Value, "the budget has neither \"max\" nor \"ms\"");
		}
		return Budget;
	}

private:
	static bool NamesAlgorithm(const FJsonValue& Axis) { return Axis.GetString("name") == "algorithm"; }

	void CheckIsOneOf(
		const FJsonValue& At, const std::string& Value, const std::vector<std::string>& Names, const char* What)
	{
		if (!Contains(Names, Value))
		{
			Messages.Error(ErrorUnknownValue, At,
				std::string("there is no ") + What + " \"" + Value + "\": " + JoinText(Names) +
					Messages.Suggest(Value, Names));
		}
	}

	void CheckBlurValue(const std::string& Name, const std::string& Text, const FJsonValue& At)
	{
		auto Algorithms = ToVector<std::string>(GetBlurAlgorithms(), &FBlurAlgorithm::Name);
		const std::vector<std::string>* Allowed = Name == "algorithm"    ? &Algorithms
												  : Name == "input"      ? &GInputs
												  : Name == "storage"    ? &GetBlurStorages()
												  : Name == "precision"  ? &GPrecisions
												  : Name == "resolution" ? &GResolutions
																		 : nullptr;
		if (Allowed != nullptr)
		{
			CheckIsOneOf(At, Text, *Allowed, Name.c_str());
		}
		else if (At.Type != EJsonType::Number || !(At.Number >= 0.5) || At.Number > 1000.0)
		{
			Messages.Error(ErrorBadValue, At, "sigma must be a number of pixels, 0.5 to 1000");
		}
	}

	void CheckFrameValue(const FStudyAssignment& Assignment, const FJsonValue& At)
	{
		if (Assignment.Name == "precision" || Assignment.Name == "storage")
		{
			CheckIsOneOf(At, Assignment.Value, Assignment.Name == "precision" ? GPrecisions : GFrameStorages,
				Assignment.Name.c_str());
		}
		else if (FindSettingField(Assignment.Name) != nullptr)
		{
			FConfig Scratch;
			std::vector<FDiagnostic> Found;
			AddSettingArgument(Scratch, Assignment.Name + "=" + Assignment.Value, Found);
			for (FDiagnostic& Diagnostic : Found)
			{
				Diagnostic.File = Config.File;
				Diagnostic.Line = At.Line;
				Diagnostic.Column = At.Column;
				Diagnostic.Where = At.Pointer;
				Diagnostics.push_back(Diagnostic);
			}
		}
		else if (!IsConfigPlace(Assignment.Name) &&
				 !Contains(FrameNames, Assignment.Name)) // places are checked with the plugins that they belong to
		{
			CheckVariable({Assignment.Name, Assignment.Value, PlaceOf(At)}, Messages);
		}
	}

	/** Reports a name that nothing has. */
	bool CheckName(const std::string& Name, const FJsonValue& At)
	{
		std::vector<std::string> Names = GBlurNames;
		bool bKnown = Contains(Names, Name);
		if (!Study.bBlur)
		{
			Names = FrameNames;
			for (const FSettingField& Field : GetSettingFields())
			{
				Names.emplace_back(Field.Name);
			}
			IConsoleManager::Get().ForEachConsoleObjectThatStartsWith(
				FConsoleObjectVisitor::CreateLambda(
					[&](const TCHAR* Variable, IConsoleObject*) { Names.emplace_back(Variable); }),
				TEXT(""));
			bKnown = IsConfigPlace(Name) || Contains(FrameNames, Name) || FindSettingField(Name) != nullptr ||
					 IConsoleManager::Get().FindConsoleVariable(Name.c_str()) != nullptr;
		}
		if (!bKnown)
		{
			Messages.Error(ErrorUnknownValue, At,
				"\"" + Name + "\" is " +
					(Study.bBlur ? "not an axis of a study of blurs; there are " + JoinText(GBlurNames)
								 : "not a setting, a console variable, " + JoinText(FrameNames) +
									   " or a place such as /objects/UMySettings/Intensity") +
					Messages.Suggest(Name, Names));
		}
		return bKnown;
	}

	/** Empty when it is wrong, which is reported. */
	std::optional<FStudyAssignment> ReadAssignment(
		const std::string& Name, const FJsonValue& NameAt, const FJsonValue& Value)
	{
		FStudyAssignment Assignment{Name, "", PlaceOf(Value)};
		if (!CheckName(Name, NameAt) || !ReadValueText(Value, Assignment.Value, Messages))
		{
			return std::nullopt;
		}
		Study.bBlur ? CheckBlurValue(Name, Assignment.Value, Value) : CheckFrameValue(Assignment, Value);
		return Assignment;
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
		const FJsonValue* Label = Value.Find("label");
		const FJsonValue* Set = Value.Find("set");
		if (Label == nullptr || Label->Type != EJsonType::String || Set == nullptr || Set->Type != EJsonType::Object ||
			Value.Members.size() != 2)
		{
			Messages.Error(ErrorWrongType, Value,
				"a value that sets several things must be {\"label\": text, \"set\": {name: value}}");
			return {};
		}
		return {Label->String, ReadAssignments(*Set)};
	}

	void ReadAxis(const FJsonValue& Value)
	{
		const FJsonValue* Name = Value.Find("name");
		const FJsonValue* Values = Value.Find("values");
		if (Name == nullptr || Name->Type != EJsonType::String || Values == nullptr)
		{
			return; // reported
		}
		if (Values->Type != EJsonType::Array || Values->Elements.empty())
		{
			Messages.Error(ErrorWrongType, *Values, "\"values\" must be an array of at least one value");
			return;
		}
		FStudyAxis Axis;
		Axis.Name = Name->String;
		Axis.Place = PlaceOf(Value);
		Axis.bEach = Axis.Name == "sigma" || Axis.Name == "input";
		if (const FJsonValue* Each = Value.Find("each"); Each != nullptr && Each->Type == EJsonType::Bool)
		{
			Axis.bEach = Each->Bool;
		}
		const bool bPlain = std::ranges::any_of(
			Values->Elements, [](const FJsonValue& Element) { return Element.Type != EJsonType::Object; });
		if (bPlain && !CheckName(Axis.Name, *Name))
		{
			return;
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
		Study.Axes.push_back(std::move(Axis));
	}

	void ReadReference(const FJsonValue& Value)
	{
		const FJsonValue* Reference = Value.Find("reference");
		const FStudyAssignment Double[] = {
			{"precision", "double", {}}, {"storage", "float64", {}}, {"r.Drydock.SampleBits", "0", {}}};
		Study.ReferenceName = Study.bBlur ? "exact" : "double";
		if (!Study.bBlur)
		{
			Study.Reference.assign(std::begin(Double), std::end(Double));
		}
		if (Reference == nullptr || Reference->Type == EJsonType::Invalid)
		{
			return;
		}
		if (Reference->Type == EJsonType::Object && !Study.bBlur)
		{
			for (FStudyAssignment& Assignment : ReadAssignments(*Reference))
			{
				std::erase_if(
					Study.Reference, [&](const FStudyAssignment& Other) { return Other.Name == Assignment.Name; });
				Study.Reference.push_back(std::move(Assignment));
			}
			Study.ReferenceName = JoinText(Study.Reference, ", ",
				[](const FStudyAssignment& Assignment) { return Assignment.Name + " " + Assignment.Value; });
		}
		else if (Reference->Type != EJsonType::String || Reference->String != Study.ReferenceName)
		{
			Messages.Error(ErrorUnknownValue, *Reference,
				Study.bBlur
					? "the reference of a study of blurs must be \"exact\""
					: "the reference of a study of frames must be \"double\", or an object of what differs from it");
		}
	}

	void ReadMetrics(const FJsonValue& Value)
	{
		for (const FJsonValue& Metric : Value.GetElements("metrics"))
		{
			if (Metric.Type == EJsonType::String) // another type is reported
			{
				CheckIsOneOf(Metric, Metric.String, GetMetricNames(), "metric");
				Study.Metrics.push_back(Metric.String);
			}
		}
		if (Study.Metrics.empty())
		{
			Study.Metrics = {"rms", "max", "relative", "psnr", "ssim", "flip"};
		}
	}

	void ReadRepetitions(const FJsonValue& Value)
	{
		const FJsonValue* Repetitions = Value.Find("repetitions");
		if (Repetitions == nullptr || Repetitions->Type != EJsonType::Number)
		{
			return;
		}
		if (Repetitions->Number != std::floor(Repetitions->Number) || Repetitions->Number < 1 ||
			Repetitions->Number > MaxRepetitions)
		{
			Messages.Error(ErrorBadValue, *Repetitions,
				"repetitions must be a whole number, 1 to 1000; 7 are enough for a spread");
			return;
		}
		Study.Repetitions = ToInteger<int>(Repetitions->Number);
	}

	void ReadRegion(const FJsonValue& Value)
	{
		const FJsonValue* Region = Value.Find("region");
		const bool bNumbers = Region != nullptr && Region->Type == EJsonType::Array &&
							  std::ranges::all_of(Region->Elements,
								  [](const FJsonValue& Element) { return Element.Type == EJsonType::Number; });
		if (!bNumbers || Region->Elements.size() != 4)
		{
			return; // absent, or reported
		}
		std::array<int, 4> Corners = {};
		for (size_t Index = 0; Index < Corners.size(); ++Index)
		{
			const double Number = Region->Elements[Index].Number;
			if (Number != std::floor(Number) || Number < 0.0 || Number > 65536.0)
			{
				Messages.Error(
					ErrorBadValue, Region->Elements[Index], "a corner of the region must be a whole number of pixels");
				return;
			}
			Corners[Index] = ToInteger<int>(Number);
		}
		if (Corners[0] >= Corners[2] || Corners[1] >= Corners[3])
		{
			Messages.Error(
				ErrorBadValue, *Region, "the region is empty: it must be [MinX, MinY, MaxX, MaxY] with Max above Min");
			return;
		}
		Study.Region = Corners;
	}

	void CheckSize(const FJsonValue& Value)
	{
		size_t Count = 1;
		for (const FStudyAxis& Axis : Study.Axes)
		{
			Count *= std::max<size_t>(1, Axis.Values.size());
			if (Count > MaxVariants)
			{
				Messages.Error(ErrorBadValue, Value, "the axes make more than 10000 variants");
				return;
			}
		}
	}

	const FConfig& Config;
	std::vector<FDiagnostic>& Diagnostics;
	FConfigMessages Messages;
	std::vector<std::string> FrameNames = {"precision", "storage"}; // of what frames vary beside settings
	FStudy Study;
};

} // namespace

std::optional<FStudy> ReadStudy(const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	FStudyReader Reader(Config, Diagnostics);
	std::optional<FStudyBudget> Budget;
	if (Config.Budget.Type == EJsonType::Object)
	{
		Budget = Reader.ReadBudget(Config.Budget);
	}
	if (Config.Study.Type != EJsonType::Object)
	{
		return std::nullopt;
	}
	FStudy Study = Reader.Read(Config.Study);
	if (Budget)
	{
		Study.Budget = *Budget;
	}
	else
	{
		// Half a step of 8 bits: what rounding to the display's bits may cost anyhow.
		Study.Budget.Max = 0.5 / 255.0;
	}
	return Study;
}

std::vector<FStudyAxis> ReadAxes(const FConfig& Config, const FJsonValue& Value,
	const std::vector<std::string>& FurtherNames, std::vector<FDiagnostic>& Diagnostics)
{
	return FStudyReader(Config, Diagnostics, FurtherNames).ReadAxes(Value.GetElements("axes"));
}

} // namespace Drydock
