// Fronts, noise, budgets: of figures written down here. And what is drawn of them.
#include <gtest/gtest.h>

#include "Budget/StudyBudget.h"
#include "Study/StudyChart.h"
#include "Study/StudyRank.h"
#include "Study/StudyReport.h"
#include "Text/Json.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace Drydock;

namespace
{

struct FFigures
{
	const char* Label;
	double Rms;
	double Taps;
	double Ms;
	double Spread = 0.0; // to each side
};

FStudyResult MakeResult(const std::vector<FFigures>& Figures, const FStudyBudget& Budget = {})
{
	FStudyResult Result;
	Result.Name = "test";
	Result.Scene = "scene.exr";
	Result.Study.Metrics = {"rms"};
	Result.Study.Budget = Budget;
	FStudyAxis Axis;
	Axis.Name = "way";
	FStudyJob Job;
	Job.Reference = "exact";
	Job.Case.Values = {""};
	for (const FFigures& Figure : Figures)
	{
		FStudyVariant Variant;
		Variant.Label = Figure.Label;
		Variant.Choice = Job.Variants.size();
		Variant.bRan = true;
		Variant.Error.Rms = Figure.Rms;
		Variant.Error.Max = 2.0 * Figure.Rms;
		Variant.Taps = Figure.Taps;
		Variant.Bytes = 16.0;
		Variant.Time = {{Figure.Ms}, Figure.Ms, Figure.Ms - Figure.Spread, Figure.Ms + Figure.Spread};
		Job.Variants.push_back(Result.Variants.size());
		Result.Variants.push_back(Variant);
		Axis.Values.push_back({Figure.Label, {{"r.Way", Figure.Label, {}}}});
	}
	Result.Study.Axes = {Axis};
	Job.ReferenceTime = SummarizeRuns({100.0});
	Result.Jobs = {Job};
	RankStudy(Result);
	return Result;
}

FStudyBudget ErrorBudget(double Max)
{
	FStudyBudget Budget;
	Budget.Max = Max;
	return Budget;
}

std::string GetRecommended(const FStudyResult& Result)
{
	for (const FStudyVariant& Variant : Result.Variants)
	{
		if (Variant.bRecommended)
		{
			return Variant.Label;
		}
	}
	return "";
}

int Count(const std::string& Text, const std::string& Part)
{
	int Number = 0;
	for (size_t At = Text.find(Part); At != std::string::npos; At = Text.find(Part, At + 1))
	{
		++Number;
	}
	return Number;
}

/** Exact and slow, good, bad and fast, and one that is worse than good in both. */
const std::vector<FFigures> GFour = {
	{"slow", 1e-4, 100, 80}, {"good", 1e-3, 20, 20}, {"fast", 1e-2, 5, 4}, {"poor", 2e-3, 30, 25}};

} // namespace

TEST(StudyRank, MedianAndQuartilesLieBetweenTheSortedRuns)
{
	const FStudyTime Time = SummarizeRuns({5, 1, 3, 2, 4});
	EXPECT_EQ(3.0, Time.Median);
	EXPECT_EQ(2.0, Time.Low);
	EXPECT_EQ(4.0, Time.High);
	EXPECT_EQ(5.0, Time.Runs[0]); // as they ran
	EXPECT_EQ(1.5, SummarizeRuns({2, 1}).Median);
	EXPECT_EQ(0.0, SummarizeRuns({}).Median);
}

TEST(StudyRank, FrontHoldsWhomNobodyDominates)
{
	const FStudyResult Result = MakeResult(GFour);
	EXPECT_TRUE(Result.Variants[0].ByTime.bFront);
	EXPECT_TRUE(Result.Variants[1].ByTime.bFront);
	EXPECT_TRUE(Result.Variants[2].ByTime.bFront);
	EXPECT_FALSE(Result.Variants[3].ByTime.bFront);
	EXPECT_EQ(1, Result.Variants[3].ByTime.DominatedBy);
	EXPECT_FALSE(Result.Variants[3].ByTaps.bFront);
}

TEST(StudyRank, EqualVariantsDoNotDominateEachOther)
{
	const FStudyResult Result = MakeResult({{"a", 1e-3, 5, 5}, {"b", 1e-3, 5, 5}});
	EXPECT_TRUE(Result.Variants[0].ByTime.bFront);
	EXPECT_TRUE(Result.Variants[1].ByTime.bFront);
}

TEST(StudyRank, PlainCodeDoesNotDominateShadersAndIsNotRecommended)
{
	FStudyResult Result = MakeResult({{"shader", 1e-3, 5, 5}, {"plain", 1e-4, 1, 1}}, ErrorBudget(1e-2));
	Result.Variants[1].bPlainCode = true;
	RankStudy(Result);
	EXPECT_TRUE(Result.Variants[0].ByTime.bFront);
	EXPECT_TRUE(Result.Variants[1].ByTime.bFront);
	EXPECT_EQ("shader", GetRecommended(Result));
}

TEST(StudyRank, ErrorBudgetTakesTheCheapestWithinIt)
{
	EXPECT_EQ("good", GetRecommended(MakeResult(GFour, ErrorBudget(1e-3))));
	EXPECT_EQ("fast", GetRecommended(MakeResult(GFour, ErrorBudget(1e-2))));
	EXPECT_EQ("slow", GetRecommended(MakeResult(GFour, ErrorBudget(5e-4))));
}

TEST(StudyRank, BudgetThatNobodyMeetsRecommendsNone)
{
	const FStudyResult Result = MakeResult(GFour, ErrorBudget(1e-9));
	EXPECT_EQ("", GetRecommended(Result));
	EXPECT_EQ("no variant meets the budget (rms at most 1e-09)", Result.Jobs[0].Recommendation);
}

TEST(StudyRank, TimeBudgetTakesTheMostExactWithinIt)
{
	FStudyBudget Budget;
	Budget.Ms = 30.0;
	EXPECT_EQ("good", GetRecommended(MakeResult(GFour, Budget)));
}

TEST(StudyRank, BudgetOfASimilarityIsTheLeast)
{
	FStudyBudget Budget;
	Budget.Metric = "psnr";
	Budget.Max = 40.0;
	FImageError Error;
	Error.Psnr = 41.0;
	EXPECT_TRUE(MeetsBudget(Error, Budget));
	Error.Psnr = 39.0;
	EXPECT_FALSE(MeetsBudget(Error, Budget));
	EXPECT_EQ(0.0, GetErrorToRank(FImageError(), "ssim"));
	Error.Psnr = 20.0;
	EXPECT_DOUBLE_EQ(0.1, GetErrorToRank(Error, "psnr"));
}

TEST(StudyRank, OfThoseAsFastWithinNoiseTheMostExactIsRecommended)
{
	// Quartiles 9..11 and 10.5..12.5 overlap, 20..21 does not.
	const FStudyResult Result =
		MakeResult({{"a", 1e-3, 5, 10, 1}, {"b", 1e-4, 5, 11.5, 1}, {"c", 1e-5, 5, 20.5, 0.5}}, ErrorBudget(1e-2));
	EXPECT_EQ("b", GetRecommended(Result));
	EXPECT_EQ(std::vector<size_t>{1}, Result.Variants[0].WithinNoiseOf);
	EXPECT_TRUE(Result.Variants[2].WithinNoiseOf.empty());
	EXPECT_NE(std::string::npos, MakeStudyTable(Result).find("within noise of one another: a and b"));
}

TEST(StudyBudget, CheapestWithinTheBoundThenMostExactThenFirst)
{
	using FOption = std::optional<size_t>;
	const FStudyBudget Error = ErrorBudget(1.0); // what meets it is said by bMeets
	FStudyBudget Time;
	Time.Ms = 100.0;
	const FBudgetCandidate Slow{true, 1e-5, 20, 19, 21}, Exact{true, 1e-4, 11, 10.5, 11.5},
		Fast{true, 1e-3, 10, 9.5, 10.6};
	EXPECT_EQ(FOption(1), ChooseWithinBudget({Slow, Exact, Fast}, Error));
	EXPECT_EQ(FOption(0), ChooseWithinBudget({Slow, Exact, Fast}, Time));
	FBudgetCandidate Out = Exact;
	Out.bMeets = false;
	EXPECT_EQ(FOption(2), ChooseWithinBudget({Slow, Out, Fast}, Error));
	EXPECT_EQ(FOption(), ChooseWithinBudget({Out, Out}, Error));
	EXPECT_EQ(FOption(), ChooseWithinBudget({}, Error));

	// The same bits: whichever the clock favours, they are one variant, unless one is cheaper beyond noise.
	const FBudgetCandidate Same{true, 1e-3, 10.1, 9.6, 10.7}, Cheap{true, 1e-3, 5, 4.9, 5.1};
	for (const FStudyBudget& Budget : {Error, Time})
	{
		EXPECT_EQ(FOption(0), ChooseWithinBudget({Fast, Same}, Budget));
		EXPECT_EQ(FOption(0), ChooseWithinBudget({Same, Fast}, Budget));
		EXPECT_EQ(FOption(1), ChooseWithinBudget({Fast, Cheap}, Budget));
	}
}

TEST(StudyRank, FrontsOfTwoRunsDifferOnlyAmongThoseSaidToBeWithinNoise)
{
	// Times of two runs of a study are drawn around the same true ones, some of which lie closer than the noise.
	std::mt19937 Random(7);
	const auto DrawRuns = [&](double Truth)
	{
		std::vector<double> Runs;
		for (int Run = 0; Run < 7; ++Run)
		{
			Runs.push_back(Truth * (1.0 + 0.2 * static_cast<double>(Random() % 1000) / 1000.0));
		}
		return SummarizeRuns(Runs);
	};
	int NumChanged = 0;
	for (int Study = 0; Study < 200; ++Study)
	{
		std::vector<FFigures> Figures;
		for (int Way = 0; Way < 8; ++Way)
		{
			Figures.push_back({"", 0.001 * (Way + 1), 5, 10.0 + static_cast<double>(Random() % 100) / 10.0});
		}
		FStudyResult Runs[2] = {MakeResult(Figures), MakeResult(Figures)};
		for (FStudyResult& Result : Runs)
		{
			for (size_t Way = 0; Way < Figures.size(); ++Way)
			{
				Result.Variants[Way].Time = DrawRuns(Figures[Way].Ms);
			}
			RankStudy(Result);
		}
		for (size_t Way = 0; Way < Figures.size(); ++Way)
		{
			const FStudyVariant& A = Runs[0].Variants[Way];
			const FStudyVariant& B = Runs[1].Variants[Way];
			if (A.ByTime.bFront == B.ByTime.bFront)
			{
				continue;
			}
			++NumChanged;
			const size_t By = static_cast<size_t>(std::max(A.ByTime.DominatedBy, B.ByTime.DominatedBy));
			const auto Says = [&](const FStudyVariant& Variant)
			{
				return std::count(Variant.WithinNoiseOf.begin(), Variant.WithinNoiseOf.end(), By) != 0;
			};
			EXPECT_TRUE(Says(A) || Says(B)) << Study << " " << Way << " " << By;
		}
	}
	EXPECT_GT(NumChanged, 20);
}

TEST(StudyRank, WhatDidNotRunHasNoRank)
{
	FStudyResult Result = MakeResult(GFour);
	Result.Variants[0].bRan = false;
	Result.Variants[0].Exclusion = EStudyExclusion::NotRun;
	Result.Variants[0].Excluded = "not run: too much";
	RankStudy(Result);
	EXPECT_FALSE(Result.Variants[0].ByTime.bFront);
	EXPECT_NE(std::string::npos, MakeStudyTable(Result).find("not run: too much"));
}

TEST(StudyReport, FilesWithoutTimesAreTheSameWhateverTheTimes)
{
	std::vector<FFigures> Slower = GFour;
	for (FFigures& Figure : Slower)
	{
		Figure.Ms = 100.0 / Figure.Ms;
	}
	const FStudyResult A = MakeResult(GFour, ErrorBudget(1e-3));
	FStudyResult B = MakeResult(Slower, ErrorBudget(1e-3));
	B.Seconds = 7.0;
	EXPECT_EQ(MakeStudyJson(A), MakeStudyJson(B));
	EXPECT_EQ(MakeStudyCsv(A, false), MakeStudyCsv(B, false));
	EXPECT_NE(GetRecommended(A), GetRecommended(B));
	EXPECT_EQ(DrawChart(MakeStudyChart(A, EStudyCost::Taps)), DrawChart(MakeStudyChart(B, EStudyCost::Taps)));
	EXPECT_NE(MakeStudyTimingJson(A), MakeStudyTimingJson(B));
}

TEST(StudyReport, IsJson)
{
	const FStudyResult Result = MakeResult(GFour, ErrorBudget(1e-3));
	for (const std::string& Text : {MakeStudyJson(Result), MakeStudyTimingJson(Result)})
	{
		std::vector<FDiagnostic> Diagnostics;
		bool bSyntaxError = true;
		const FJsonValue Root = ParseJson(Text, "study", Diagnostics, bSyntaxError);
		EXPECT_TRUE(Diagnostics.empty());
		EXPECT_EQ(4u, Root.Find("jobs")->Elements.at(0).Find("variants")->Elements.size());
	}
}

TEST(StudyReport, CsvHasALinePerVariantAndQuotesCommas)
{
	FStudyResult Result = MakeResult({{"a, b", 1e-3, 5, 5}, {"c", 1e-3, 5, 5}});
	const std::string Csv = MakeStudyCsv(Result, false);
	EXPECT_EQ(3, Count(Csv, "\n"));
	EXPECT_NE(std::string::npos, Csv.find("\"a, b\""));
	EXPECT_EQ(0u, Csv.find("way,max,rms,relative,psnr,ssim,flip,taps_per_pixel"));
}

TEST(StudyChart, FewErrorsAThousandTimesSmallerStandAtTheEdgeWithTheirFigure)
{
	std::vector<FFigures> Figures = GFour;
	Figures.push_back({"exact", 2e-8, 200, 200});
	const std::string Svg = DrawChart(MakeStudyChart(MakeResult(Figures), EStudyCost::Taps));
	EXPECT_EQ(1, Count(Svg, ">exact: 2e-8<"));
	EXPECT_EQ(0, Count(Svg, "10\u207B\u2077")); // no tick so far down
	// Of two halves neither is the exception.
	const std::string Halves =
		DrawChart(MakeStudyChart(MakeResult({{"a", 1e-3, 5, 5}, {"b", 1e-8, 9, 9}}), EStudyCost::Taps));
	EXPECT_EQ(2, Count(Halves, ">b<")); // legend and label
}

TEST(StudyChart, DrawsEveryVariantTheRingsAndTheBudget)
{
	FStudyResult Result = MakeResult(GFour, ErrorBudget(1e-3));
	Result.Variants[2].bCurrent = true;
	for (FStudyVariant& Variant : Result.Variants)
	{
		Variant.Time.Low *= 0.9;
	}
	const std::string Svg = DrawChart(MakeStudyChart(Result, EStudyCost::Milliseconds));
	for (const FFigures& Figure : GFour)
	{
		EXPECT_LE(2, Count(Svg, ">" + std::string(Figure.Label) + "<")) << Figure.Label; // legend and label
	}
	EXPECT_EQ(2, Count(Svg, "class=\"pick\"")); // legend and ring
	EXPECT_EQ(2, Count(Svg, "class=\"now\""));
	EXPECT_EQ(1, Count(Svg, "class=\"budget\""));
	EXPECT_EQ(4, Count(Svg, "class=\"whisker"));
	EXPECT_EQ(Svg, DrawChart(MakeStudyChart(Result, EStudyCost::Milliseconds)));
}

TEST(StudyChart, TapsHaveNoWhiskers)
{
	EXPECT_EQ(0, Count(DrawChart(MakeStudyChart(MakeResult(GFour), EStudyCost::Taps)), "class=\"whisker"));
}

TEST(StudyChart, HasRoomForNoErrorAndForNothingAtAll)
{
	const std::string Svg = DrawChart(MakeStudyChart(MakeResult({{"same", 0.0, 5, 5}}), EStudyCost::Taps));
	EXPECT_NE(std::string::npos, Svg.find("same (no error)"));
	EXPECT_EQ(std::string::npos, Svg.find("nan"));
	EXPECT_EQ(std::string::npos, Svg.find("inf"));
	FStudyResult Nothing = MakeResult({{"none", 1.0, 5, 5}});
	Nothing.Variants[0].bRan = false;
	EXPECT_NE(std::string::npos, DrawChart(MakeStudyChart(Nothing, EStudyCost::Taps)).find("nothing to show"));
}
