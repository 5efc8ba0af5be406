// Reads "study" and "budget" of a config, and reports mistakes in them.
#include "Budget/StudyConfig.h"

#include "Budget/BlurNames.h"
#include "Budget/RunAssignment.h"
#include "Config/ConfigReader.h"
#include "Math/ToInteger.h"
#include "Picture/ImageMetrics.h"
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

/** Reads the study of one config. */
class FStudyReader
{
public:
	FStudyReader(const FConfig& InConfig, std::vector<FDiagnostic>& InDiagnostics)
		: Config(InConfig)
		, Messages(InConfig.File, InDiagnostics)
		, FrameReader(InConfig.File, {"precision", "storage"}, InDiagnostics)
	{
	}

	FStudy Read(const FJsonValue& Value)
	{
		const std::vector<FJsonValue>& Axes = Value.GetElements("axes");
		Study.bBlur = std::ranges::any_of(Axes, NamesAlgorithm);
		for (const FJsonValue& Axis : Axes)
		{
			ReadAxis(Axis);
		}
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
			CheckIsOneOf(*Metric, Metric->String, GetMetricNames(), "metric", Messages);
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
			CheckIsOneOf(At, Text, *Allowed, Name.c_str(), Messages);
		}
		else if (At.Type != EJsonType::Number || !(At.Number >= 0.5) || At.Number > 1000.0)
		{
			Messages.Error(ErrorBadValue, At, "sigma must be a number of pixels, 0.5 to 1000");
		}
	}

	/** Reports a name that nothing has. */
	bool CheckName(const std::string& Name, const FJsonValue& At)
	{
		if (!Study.bBlur)
		{
			return FrameReader.CheckName(Name, At);
		}
		if (!Contains(GBlurNames, Name))
		{
			Messages.Error(ErrorUnknownValue, At,
				"\"" + Name + "\" is not an axis of a study of blurs; there are " + JoinText(GBlurNames) +
					Messages.Suggest(Name, GBlurNames));
			return false;
		}
		return true;
	}

	/** Empty when it is wrong, which is reported. */
	std::optional<FStudyAssignment> ReadAssignment(
		const std::string& Name, const FJsonValue& NameAt, const FJsonValue& Value)
	{
		if (!Study.bBlur)
		{
			return FrameReader.Read(Name, NameAt, Value);
		}
		const bool bKnown = CheckName(Name, NameAt);
		const std::optional<std::string> Text = bKnown ? ReadValueText(Value, Messages) : std::nullopt;
		if (!Text)
		{
			return std::nullopt;
		}
		CheckBlurValue(Name, *Text, Value);
		return FStudyAssignment{Name, *Text, PlaceOf(Value)};
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
				CheckIsOneOf(Metric, Metric.String, GetMetricNames(), "metric", Messages);
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
	FConfigMessages Messages;
	FRunAssignmentReader FrameReader; // of studies of frames
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

} // namespace Drydock
