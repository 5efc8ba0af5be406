// Reads the files of a study and chooses the variant that its budget allows.
#include "Budget/BudgetChoice.h"

#include "Config/ReadConfig.h"
#include "Budget/RunOptions.h"
#include "Budget/StudyBudget.h"
#include "Budget/StudyRequest.h"
#include "Config/ConfigPlaces.h"
#include "Config/ConfigReader.h"
#include "PostProcessSettingsReflection.h"
#include "Text/Fmt.inl"
#include "Text/TextFile.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace Drydock
{

namespace
{

/** One way, over all jobs of the study. */
struct FCandidate : FBudgetCandidate // Error: the worst of the jobs; times: their sums
{
	std::string Label;
	std::vector<FStudyAssignment> Set;
	double WorstValue = 0.0; // as the metric has it
};

std::optional<FJsonValue> ReadJsonFile(const std::filesystem::path& File)
{
	const std::optional<std::string> Text = TryReadTextFile(File.string());
	if (!Text)
	{
		return std::nullopt;
	}
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	FJsonValue Root = ParseJson(*Text, File.string(), Ignored, bSyntaxError);
	return bSyntaxError ? std::nullopt : std::optional<FJsonValue>(std::move(Root));
}

/** Figures that are null are infinite. */
FImageError ReadError(const FJsonValue& Variant)
{
	constexpr double Infinity = std::numeric_limits<double>::infinity();
	FImageError Error;
	Error.Max = Variant.GetNumber("max", Infinity);
	Error.Rms = Variant.GetNumber("rms", Infinity);
	Error.Relative = Variant.GetNumber("relative", Infinity);
	Error.Psnr = Variant.GetNumber("psnr", Error.Rms == 0.0 ? Infinity : 0.0);
	Error.Ssim = Variant.GetNumber("ssim", 0.0);
	Error.Flip = Variant.GetNumber("flip", 1.0);
	return Error;
}

/** Candidates of the first job, with what the others add. */
std::vector<FCandidate> ReadCandidates(const FJsonValue& Study, const FJsonValue& Timing, const FStudyBudget& Budget)
{
	std::vector<FCandidate> Candidates;
	const std::vector<FJsonValue>& Jobs = Study.GetElements("jobs");
	const std::vector<FJsonValue>& Times = Timing.GetElements("jobs");
	for (size_t Job = 0; Job < Jobs.size() && Job < Times.size(); ++Job)
	{
		const std::vector<FJsonValue>& Variants = Jobs[Job].GetElements("variants");
		const std::vector<FJsonValue>& TimedVariants = Times[Job].GetElements("variants");
		Candidates.resize(std::max(Candidates.size(), Variants.size()));
		for (size_t Index = 0; Index < Variants.size() && Index < TimedVariants.size(); ++Index)
		{
			FCandidate& Candidate = Candidates[Index];
			const FImageError Error = ReadError(Variants[Index]);
			Candidate.Label = Variants[Index].GetString("label");
			Candidate.Median += TimedVariants[Index].GetNumber("medianMs", HUGE_VAL);
			Candidate.Low += TimedVariants[Index].GetNumber("lowMs", HUGE_VAL);
			Candidate.High += TimedVariants[Index].GetNumber("highMs", HUGE_VAL);
			Candidate.bMeets =
				Candidate.bMeets && Variants[Index].GetString("excluded").empty() && MeetsBudget(Error, Budget);
			if (GetErrorToRank(Error, Budget.Metric) >= Candidate.Error)
			{
				Candidate.Error = GetErrorToRank(Error, Budget.Metric);
				Candidate.WorstValue = GetMetric(Error, Budget.Metric);
			}
			const FJsonValue* Set = Variants[Index].Find("set");
			if (Job == 0 && Set != nullptr)
			{
				for (const FJsonMember& Member : Set->Members)
				{
					Candidate.Set.push_back({Member.Key, Member.Value.String, {}});
				}
			}
		}
	}
	for (FCandidate& Candidate : Candidates)
	{
		Candidate.bMeets = Candidate.bMeets && (!Budget.Ms || Candidate.Median <= *Budget.Ms);
	}
	return Candidates;
}

FBudgetChoice KeepOwn(const std::string& Why, const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	const std::string Message = Why + "; the config's own values are used";
	Diagnostics.push_back({.Severity = ESeverity::Note,
		.Code = NoteBudgetWithoutChoice,
		.Message = Message,
		.File = Config.File,
		.Line = Config.Budget.Line,
		.Column = Config.Budget.Column,
		.Where = Config.Budget.Pointer});
	return {{}, Message};
}

} // namespace

std::optional<FBudgetChoice> ReadBudgetChoice(
	const FConfig& Config, const FRunOptions& Options, std::vector<FDiagnostic>& Diagnostics)
{
	if (Config.Budget.Type != EJsonType::Object || Config.Study.Type != EJsonType::Object)
	{
		return std::nullopt;
	}
	std::vector<FDiagnostic> Ignored;
	const std::optional<FStudy> Read = ReadStudy(Config, Ignored);
	if (!Read || HasErrors(Ignored))
	{
		return std::nullopt; // reported where the config is checked
	}
	if (Read->bBlur)
	{
		return KeepOwn("the choice of a study of blurs does not apply to a frame", Config, Diagnostics);
	}
	const std::string Given = Config.Budget.GetString("study");
	const std::filesystem::path Folder = Given.empty() ? GetDefaultOutputFolder(Config.File) : Config.Resolve(Given);
	const std::optional<FJsonValue> Study = ReadJsonFile(Folder / "study.json");
	const std::optional<FJsonValue> Timing = ReadJsonFile(Folder / "study_timing.json");
	if (!Study || !Timing)
	{
		return KeepOwn("there is no study in " + Folder.string() + " to choose by (drydock study " + Config.File + ")",
			Config, Diagnostics);
	}
	if (Study->GetString("fingerprint") != GetStudyFingerprint(GetConfigText(Options)))
	{
		return KeepOwn(
			"the study in " + Folder.string() + " was made from an earlier form of this config", Config, Diagnostics);
	}
	const std::vector<FCandidate> Candidates = ReadCandidates(*Study, *Timing, Read->Budget);
	const std::optional<size_t> Chosen =
		ChooseWithinBudget(std::vector<FBudgetCandidate>(Candidates.begin(), Candidates.end()), Read->Budget);
	if (!Chosen)
	{
		return KeepOwn("no variant of the study in " + Folder.string() + " meets the budget", Config, Diagnostics);
	}
	const FCandidate& Best = Candidates[*Chosen];
	if (std::any_of(Best.Set.begin(), Best.Set.end(),
			[](const FStudyAssignment& Assignment) { return IsConfigPlace(Assignment.Name); }))
	{
		return KeepOwn("the study in " + Folder.string() + " recommends " + Best.Label +
						   ", which stands in \"objects\", \"passes\" or \"extensions\" and is not set by a budget",
			Config, Diagnostics);
	}
	return FBudgetChoice{
		Best.Set, fmt::format("{} ({} {:.3g}, {:.4g} ms) is the {} within the budget by the study in {}", Best.Label,
					  Read->Budget.Metric, Best.WorstValue, Best.Median,
					  Read->Budget.Max ? "most exact of the cheapest" : "most exact", Folder.string())};
}

void ApplyBudgetChoice(const FBudgetChoice& Choice, FConfig& Config, FRunOptions& Options)
{
	for (const FStudyAssignment& Assignment : Choice.Set)
	{
		if (Assignment.Name == "precision" || Assignment.Name == "storage")
		{
			const bool bGiven = Options.bDouble || Options.Storage != ERunStorage::Default;
			if (!bGiven)
			{
				ApplyToRun({Assignment}, Options);
			}
		}
		else if (FindSettingField(Assignment.Name) != nullptr)
		{
			if (Config.CommandLine.Places.count(Assignment.Name) == 0)
			{
				std::vector<FDiagnostic> Ignored;
				AddSettingArgument(Config, Assignment.Name + "=" + Assignment.Value, Ignored);
			}
		}
		else
		{
			// As if it stood in the config, after what does: the command line has the last word.
			Config.Variables.push_back({Assignment.Name, Assignment.Value, {}});
		}
	}
}

} // namespace Drydock
