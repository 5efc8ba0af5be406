// Source: drydock.
#include "Budget/BudgetChoice.h"

#include "Config/ReadConfig.h"
#include "Budget/RunOptions.h"
#include "Budget/StudyBudget.h"
#include "Budget/StudyRequest.h"
#include "Config/ConfigReader.h"
#include "PostProcessSettingsReflection.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

namespace Drydock
{

namespace
{

/** One way, over all jobs of the study. */
struct FCandidate
{
	std::string Label;
	std::vector<FStudyAssignment> Set;
	bool bMeets = true;
	double Milliseconds = 0.0;
	double Worst = 0.0; // of the jobs, as GetErrorToRank has it
	double WorstValue = 0.0;
};

std::optional<FJsonValue> ReadJsonFile(const std::filesystem::path& File)
{
	std::ifstream Stream(File, std::ios::binary);
	if (!Stream)
	{
		return std::nullopt;
	}
	std::stringstream Text;
	Text << Stream.rdbuf();
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	FJsonValue Root = ParseJson(Text.str(), File.string(), Ignored, bSyntaxError);
	return bSyntaxError ? std::nullopt : std::optional<FJsonValue>(std::move(Root));
}

const std::vector<FJsonValue>& GetElements(const FJsonValue& Object, const char* Key)
{
	static const std::vector<FJsonValue> None;
	const FJsonValue* Array = Object.Find(Key);
	return Array != nullptr ? Array->Elements : None;
}

/** Not there, or null as infinite figures are: what is given. */
double GetNumber(const FJsonValue& Object, const char* Key, double Otherwise)
{
	const FJsonValue* Value = Object.Find(Key);
	return Value != nullptr && Value->Type == EJsonType::Number ? Value->Number : Otherwise;
}

std::string GetString(const FJsonValue& Object, const char* Key)
{
	const FJsonValue* Value = Object.Find(Key);
	return Value != nullptr ? Value->String : "";
}

FImageError ReadError(const FJsonValue& Variant)
{
	constexpr double Infinity = std::numeric_limits<double>::infinity();
	FImageError Error;
	Error.Max = GetNumber(Variant, "max", Infinity);
	Error.Rms = GetNumber(Variant, "rms", Infinity);
	Error.Relative = GetNumber(Variant, "relative", Infinity);
	Error.Psnr = GetNumber(Variant, "psnr", Error.Rms == 0.0 ? Infinity : 0.0);
	Error.Ssim = GetNumber(Variant, "ssim", 0.0);
	return Error;
}

/** Candidates of the first job, with what the others add. */
std::vector<FCandidate> ReadCandidates(const FJsonValue& Study, const FJsonValue& Timing, const FStudyBudget& Budget)
{
	std::vector<FCandidate> Candidates;
	const std::vector<FJsonValue>& Jobs = GetElements(Study, "jobs");
	const std::vector<FJsonValue>& Times = GetElements(Timing, "jobs");
	for (size_t Job = 0; Job < Jobs.size() && Job < Times.size(); ++Job)
	{
		const std::vector<FJsonValue>& Variants = GetElements(Jobs[Job], "variants");
		const std::vector<FJsonValue>& TimedVariants = GetElements(Times[Job], "variants");
		Candidates.resize(std::max(Candidates.size(), Variants.size()));
		for (size_t Index = 0; Index < Variants.size() && Index < TimedVariants.size(); ++Index)
		{
			FCandidate& Candidate = Candidates[Index];
			const FImageError Error = ReadError(Variants[Index]);
			Candidate.Label = GetString(Variants[Index], "label");
			Candidate.Milliseconds += GetNumber(TimedVariants[Index], "medianMs", HUGE_VAL);
			Candidate.bMeets =
				Candidate.bMeets && GetString(Variants[Index], "excluded").empty() && MeetsBudget(Error, Budget);
			if (GetErrorToRank(Error, Budget.Metric) >= Candidate.Worst)
			{
				Candidate.Worst = GetErrorToRank(Error, Budget.Metric);
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
		Candidate.bMeets = Candidate.bMeets && (!Budget.Ms || Candidate.Milliseconds <= *Budget.Ms);
	}
	return Candidates;
}

const FCandidate* Choose(const std::vector<FCandidate>& Candidates, const FStudyBudget& Budget)
{
	const FCandidate* Best = nullptr;
	for (const FCandidate& Candidate : Candidates)
	{
		const bool bBetter = Best == nullptr ||
							 (Budget.Max ? Candidate.Milliseconds < Best->Milliseconds : Candidate.Worst < Best->Worst);
		Best = Candidate.bMeets && bBetter ? &Candidate : Best;
	}
	return Best;
}

FBudgetChoice KeepOwn(const std::string& Why, const FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	FDiagnostic Note;
	Note.Severity = ESeverity::Note;
	Note.Code = NoteBudgetWithoutChoice;
	Note.File = Config.File;
	Note.Line = Config.Budget.Line;
	Note.Column = Config.Budget.Column;
	Note.Where = Config.Budget.Pointer;
	Note.Message = Why + "; the config's own values hold";
	Diagnostics.push_back(Note);
	return {{}, Note.Message};
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
		return KeepOwn("a study of blurs chooses nothing that a frame has a place for", Config, Diagnostics);
	}
	const std::string Given = GetString(Config.Budget, "study");
	const std::filesystem::path Folder = Given.empty() ? GetDefaultOutputFolder(Config.File) : Config.Resolve(Given);
	const std::optional<FJsonValue> Study = ReadJsonFile(Folder / "study.json");
	const std::optional<FJsonValue> Timing = ReadJsonFile(Folder / "study_timing.json");
	if (!Study || !Timing)
	{
		return KeepOwn("there is no study in " + Folder.string() + " to choose by (drydock study " + Config.File + ")",
			Config, Diagnostics);
	}
	if (GetString(*Study, "fingerprint") != GetStudyFingerprint(GetConfigText(Options)))
	{
		return KeepOwn(
			"the study in " + Folder.string() + " is of an earlier form of this config", Config, Diagnostics);
	}
	const std::vector<FCandidate> Candidates = ReadCandidates(*Study, *Timing, Read->Budget);
	const FCandidate* Best = Choose(Candidates, Read->Budget);
	if (Best == nullptr)
	{
		return KeepOwn("no variant of the study in " + Folder.string() + " meets the budget", Config, Diagnostics);
	}
	char Text[160];
	std::snprintf(Text, sizeof(Text), " (%s %.3g, %.4g ms) is the %s within the budget by the study in ",
		Read->Budget.Metric.c_str(), Best->WorstValue, Best->Milliseconds,
		Read->Budget.Max ? "cheapest" : "most exact");
	return FBudgetChoice{Best->Set, Best->Label + Text + Folder.string()};
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
