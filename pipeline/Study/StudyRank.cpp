// Ranks the variants of each job, and recommends one within the budget.
#include "Study/StudyRank.h"

#include "Budget/StudyBudget.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <functional>

namespace Drydock
{

namespace
{

double Interpolate(const std::vector<double>& Sorted, double Part)
{
	const double Place = Part * static_cast<double>(Sorted.size() - 1);
	const size_t Index = static_cast<size_t>(Place);
	const size_t Next = std::min(Index + 1, Sorted.size() - 1);
	return Sorted[Index] + (Sorted[Next] - Sorted[Index]) * (Place - static_cast<double>(Index));
}

using FCost = std::function<double(const FStudyVariant&)>;

void Rank(FStudyResult& Result, const FStudyJob& Job, const FCost& Cost, FStudyRank FStudyVariant::*Member)
{
	const auto Error = [&](const FStudyVariant& Variant)
	{
		return GetErrorToRank(Variant.Error, Result.GetMetric());
	};
	for (const size_t Index : Job.Variants)
	{
		FStudyVariant& Variant = Result.Variants[Index];
		Variant.*Member = {};
		if (!Variant.Competes())
		{
			continue;
		}
		int Best = -1;
		for (const size_t Other : Job.Variants)
		{
			const FStudyVariant& Rival = Result.Variants[Other];
			// Plain code cannot run where shaders do.
			if (!Rival.Competes() || (Rival.bPlainCode && !Variant.bPlainCode) || Error(Rival) > Error(Variant) ||
				Cost(Rival) > Cost(Variant) || (Error(Rival) == Error(Variant) && Cost(Rival) == Cost(Variant)))
			{
				continue;
			}
			// Name one that is itself on the front: nobody is cheaper and as exact, so take the cheapest.
			if (Best < 0 || Cost(Rival) < Cost(Result.Variants[static_cast<size_t>(Best)]))
			{
				Best = static_cast<int>(Other);
			}
		}
		(Variant.*Member).DominatedBy = Best;
		(Variant.*Member).bFront = Best < 0;
	}
}

FBudgetCandidate MakeCandidate(const FStudyVariant& Variant, const std::string& Metric)
{
	return {true, GetErrorToRank(Variant.Error, Metric), Variant.Time.Median, Variant.Time.Low, Variant.Time.High};
}

void FindNoise(FStudyResult& Result, const FStudyJob& Job)
{
	for (const size_t Index : Job.Variants)
	{
		FStudyVariant& Variant = Result.Variants[Index];
		Variant.WithinNoiseOf.clear();
		for (const size_t Other : Job.Variants)
		{
			const FStudyVariant& Rival = Result.Variants[Other];
			if (Other != Index && Variant.Competes() && Rival.Competes() &&
				MakeCandidate(Variant, Result.GetMetric()).IsWithinNoiseOf(MakeCandidate(Rival, Result.GetMetric())))
			{
				Variant.WithinNoiseOf.push_back(Other);
			}
		}
	}
}

std::string DescribeBudget(const FStudyBudget& Budget)
{
	std::string Text;
	if (Budget.Max)
	{
		Text = fmt::format(
			"{} {} {:.3g}", Budget.Metric, IsHigherBetter(Budget.Metric) ? "at least" : "at most", *Budget.Max);
	}
	if (Budget.Ms)
	{
		Text += fmt::format("{}{:.3g} ms", Text.empty() ? "" : " and ", *Budget.Ms);
	}
	return Text;
}

void Recommend(FStudyResult& Result, FStudyJob& Job)
{
	const FStudyBudget& Budget = Result.Study.Budget;
	std::vector<FBudgetCandidate> Candidates;
	for (const size_t Index : Job.Variants)
	{
		FStudyVariant& Variant = Result.Variants[Index];
		Variant.bRecommended = false;
		Candidates.push_back(MakeCandidate(Variant, Result.GetMetric()));
		Candidates.back().bMeets = Variant.Competes() && !Variant.bPlainCode && MeetsBudget(Variant.Error, Budget) &&
								   (!Budget.Ms || Variant.Time.Median <= *Budget.Ms);
	}
	const std::optional<size_t> Choice = ChooseWithinBudget(Candidates, Budget);
	if (!Choice)
	{
		Job.Recommendation = "no variant meets the budget (" + DescribeBudget(Budget) + ")";
		return;
	}
	const size_t Best = Job.Variants[*Choice];
	FStudyVariant& Chosen = Result.Variants[Best];
	Chosen.bRecommended = true;
	Job.Recommendation = fmt::format("{}: {} {:.3g}, {:.3g} ms", Chosen.Label, Result.GetMetric(),
		GetMetric(Chosen.Error, Result.GetMetric()), Chosen.Time.Median);
	for (const size_t Index : Job.Variants)
	{
		const FStudyVariant& Now = Result.Variants[Index];
		if (Now.bCurrent && Now.bRan && Index != Best)
		{
			const double Faster = Now.Time.Median / Chosen.Time.Median;
			Job.Recommendation += fmt::format("; {:.3g} times as {} as now ({}: {} {:.3g})",
				Faster >= 1.0 ? Faster : 1.0 / Faster, Faster >= 1.0 ? "fast" : "slow", Now.Label, Result.GetMetric(),
				GetMetric(Now.Error, Result.GetMetric()));
		}
	}
}

} // namespace

FStudyTime SummarizeRuns(std::vector<double> Runs)
{
	FStudyTime Time;
	Time.Runs = Runs;
	if (!Runs.empty())
	{
		std::sort(Runs.begin(), Runs.end());
		Time.Median = Interpolate(Runs, 0.5);
		Time.Low = Interpolate(Runs, 0.25);
		Time.High = Interpolate(Runs, 0.75);
	}
	return Time;
}

void RankStudy(FStudyResult& Result)
{
	for (FStudyJob& Job : Result.Jobs)
	{
		Rank(
			Result, Job, [](const FStudyVariant& Variant) { return Variant.Taps; }, &FStudyVariant::ByTaps);
		Rank(
			Result, Job, [](const FStudyVariant& Variant) { return Variant.Time.Median; }, &FStudyVariant::ByTime);
		FindNoise(Result, Job);
		Recommend(Result, Job);
	}
}

} // namespace Drydock
