// Makes the panels of a study's chart: which variants, which axes, which names.
#include "Study/StudyChart.h"

#include "Budget/StudyBudget.h"
#include "Study/StudyReport.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace Drydock
{

namespace
{

double GetCost(const FStudyVariant& Variant, EStudyCost Cost)
{
	return Cost == EStudyCost::Taps ? Variant.Taps : Variant.Time.Median;
}

std::string NameCost(EStudyCost Cost)
{
	return Cost == EStudyCost::Taps ? "taps per pixel" : "CPU ms";
}

/** "c3" of the fourth choice. */
std::string GetColor(size_t Choice)
{
	constexpr size_t NumColors = 10;
	return "c" + std::to_string(Choice % NumColors);
}

/** The error that the budget allows, where it speaks of this metric. */
std::optional<double> GetBudgetError(const FStudyBudget& Budget, const std::string& Metric)
{
	if (!Budget.Max || Budget.Metric != Metric)
	{
		return std::nullopt;
	}
	return Metric == "psnr" ? std::pow(10.0, -*Budget.Max / 20.0) : Metric == "ssim" ? 1.0 - *Budget.Max : *Budget.Max;
}

/** "2e-7": one digit. */
std::string RoughText(double Number)
{
	std::string Text = fmt::format("{:.0e}", Number);
	const size_t Zero = Text.find("e-0");
	return Zero == std::string::npos ? Text : Text.erase(Zero + 2, 1);
}

/** The error axis of a panel. A few errors a thousand times smaller than all others would push these together: they are
 * drawn at the lower edge, and their labels have the figure. */
class FErrorAxis
{
public:
	/** Errors: of all that is drawn. Shown: one more that the axis must reach. */
	FErrorAxis(const std::string& Metric, std::vector<double> Errors, const std::optional<double>& Shown)
	{
		std::erase_if(Errors, [](double Error) { return !(Error > 0.0); });
		std::ranges::sort(Errors);
		for (size_t NumBelow = 1; 2 * NumBelow < Errors.size() && Floor == 0.0; ++NumBelow)
		{
			constexpr double Gap = 1000.0;
			Floor = Errors[NumBelow] > Gap * Errors[NumBelow - 1] ? Errors[NumBelow] : 0.0;
		}
		Errors.erase(Errors.begin(), std::ranges::lower_bound(Errors, Floor));
		if (Shown)
		{
			Errors.push_back(*Shown);
		}
		Axis = MakeLogAxis(GetErrorTitle(Metric), Errors);
		Edge = Axis.Low;
		if (Floor > 0.0)
		{
			const double Span = Axis.High / Axis.Low;
			Edge *= std::pow(Span, -0.06);
			Axis.Low *= std::pow(Span, -0.1);
		}
	}

	double Place(double Error) const { return Error < Floor ? Edge : std::max(Error, Axis.Low); }
	/** "FFT", or where it is below "FFT: 2e-7". */
	std::string Label(const std::string& Name, double Error) const
	{
		return Error == 0.0 ? Name + " (no error)" : Error < Floor ? Name + ": " + RoughText(Error) : Name;
	}
	const FChartAxis& GetAxis() const { return Axis; }

private:
	double Floor = 0.0;
	double Edge = 0.0; // where what is below is drawn
	FChartAxis Axis;
};

/** The budget, where the axis reaches it. */
std::optional<double> LimitTo(const FChartAxis& Axis, const std::optional<double>& Budget)
{
	return Budget && *Budget > Axis.Low && *Budget < Axis.High ? Budget : std::nullopt;
}

// Jobs by a number ----------------------------------------------------------------------------------------------------

/** The one axis of jobs whose values are three numbers at least. */
std::optional<size_t> FindSweep(const FStudy& Study)
{
	for (size_t Index = 0; Index < Study.Axes.size(); ++Index)
	{
		const FStudyAxis& Axis = Study.Axes[Index];
		const bool bNumbers = std::ranges::all_of(Axis.Values,
			[](const FStudyValue& Value)
			{
				char* End = nullptr;
				return std::strtod(Value.Label.c_str(), &End) > 0.0 && *End == '\0';
			});
		if (Axis.bEach && bNumbers && Axis.Values.size() >= 3)
		{
			return Index;
		}
	}
	return std::nullopt;
}

/** A job's values without the number: "scene". */
std::string GetOther(const FStudyJob& Job, const std::optional<size_t>& Sweep)
{
	std::string Other;
	for (size_t Index = 0; Index < Job.Case.Values.size(); ++Index)
	{
		if (Sweep != Index && !Job.Case.Values[Index].empty())
		{
			Other += (Other.empty() ? "" : ", ") + Job.Case.Values[Index];
		}
	}
	return Other;
}

/** Cost or error against the number, a line per choice, each named at its end. */
FChartPanel MakeSweepPanel(
	const FStudyResult& Result, const std::vector<const FStudyJob*>& Jobs, size_t Sweep, EStudyCost Cost, bool bErrors)
{
	const auto GetNumber = [&](const FStudyJob& Job)
	{
		return std::strtod(Job.Case.Values[Sweep].c_str(), nullptr);
	};
	const auto GetValue = [&](const FStudyVariant& Variant)
	{
		return bErrors ? GetErrorToRank(Variant.Error, Result.GetMetric()) : GetCost(Variant, Cost);
	};
	std::vector<double> Numbers;
	std::vector<double> Values;
	for (const FStudyJob* Job : Jobs)
	{
		Numbers.push_back(GetNumber(*Job));
		for (const size_t Index : Job->Variants)
		{
			if (Result.Variants[Index].Competes())
			{
				Values.push_back(GetValue(Result.Variants[Index]));
			}
		}
	}
	const std::string& Name = Result.Study.Axes[Sweep].Name;
	const FErrorAxis Errors(Result.GetMetric(), Values, {});
	FChartPanel Panel;
	Panel.NumColumns = 2;
	Panel.Height = 262.0;
	Panel.NameRoom = 100.0;
	Panel.X = MakeLogAxis(Name + (Name == "sigma" ? ", pixels" : ""), Numbers);
	Panel.X.Ticks.clear();
	for (const double Number : Numbers)
	{
		Panel.X.Ticks.push_back({Number, NameLogTick(Number)});
	}
	Panel.Y = bErrors ? Errors.GetAxis() : MakeLogAxis(NameCost(Cost), Values);
	Panel.Limit = bErrors ? LimitTo(Panel.Y, GetBudgetError(Result.Study.Budget, Result.GetMetric())) : std::nullopt;
	for (size_t Choice = 0; Choice < Jobs[0]->Variants.size(); ++Choice)
	{
		FChartSeries Series;
		Series.Color = GetColor(Choice);
		for (const FStudyJob* Job : Jobs)
		{
			const FStudyVariant& Variant = Result.Variants[Job->Variants[Choice]];
			const double Value = GetValue(Variant);
			if (Variant.Competes() && Value > 0.0)
			{
				const double X = GetNumber(*Job);
				const double Y = bErrors ? Errors.Place(Value) : Value;
				Series.Name = bErrors ? Errors.Label(Variant.Label, Value) : Variant.Label;
				Series.Line.emplace_back(X, Y);
				Series.Points.push_back({.X = X, .Y = Y, .Low = X, .High = X});
			}
		}
		if (!Series.Line.empty())
		{
			Series.Points.back().Label = Series.Name;
			Panel.Series.push_back(std::move(Series));
		}
	}
	return Panel;
}

/** One row of all choices, then one of what marks mean. */
std::vector<std::vector<FChartLegend>> MakeLegend(const FStudyResult& Result, EStudyCost Cost)
{
	std::vector<FChartLegend> Choices;
	for (size_t Choice = 0; !Result.Jobs.empty() && Choice < Result.Jobs[0].Variants.size(); ++Choice)
	{
		const auto Shown = std::ranges::find_if(
			Result.Jobs, [&](const FStudyJob& Job) { return Result.Variants[Job.Variants[Choice]].Competes(); });
		if (Shown != Result.Jobs.end())
		{
			const FStudyVariant& Variant = Result.Variants[Shown->Variants[Choice]];
			Choices.push_back({Variant.Label, GetColor(Choice), {}});
		}
	}
	const auto Any = [&](bool FStudyVariant::*Member)
	{
		return std::ranges::any_of(
			Result.Variants, [&](const FStudyVariant& Variant) { return Variant.*Member && Variant.Competes(); });
	};
	std::vector<FChartLegend> Marks = {{"front: nobody is cheaper and as exact", "front", {}},
		{"pale: something is cheaper and as exact", "c7", {.bPale = true}}};
	if (Cost == EStudyCost::Milliseconds && Any(&FStudyVariant::bRecommended))
	{
		Marks.push_back({"recommended: the cheapest by time within the budget", "c7", {.bPick = true}});
	}
	if (Any(&FStudyVariant::bCurrent))
	{
		Marks.push_back({"in use now", "c7", {.bNow = true}});
	}
	return {Choices, Marks};
}

} // namespace

FChartPanel MakeStudyPanel(const FStudyResult& Result, const FStudyJob& Job, EStudyCost Cost, const std::string& Metric)
{
	const bool bTime = Cost == EStudyCost::Milliseconds;
	std::vector<double> Costs;
	std::vector<double> Found;
	for (const size_t Index : Job.Variants)
	{
		const FStudyVariant& Variant = Result.Variants[Index];
		if (Variant.Competes())
		{
			Found.push_back(GetErrorToRank(Variant.Error, Metric));
			Costs.push_back(GetCost(Variant, Cost));
			Costs.insert(Costs.end(), bTime ? 1 : 0, Variant.Time.Low);
			Costs.insert(Costs.end(), bTime ? 1 : 0, Variant.Time.High);
		}
	}
	// The budget is in the picture where it is not far from what was found.
	constexpr double Far = 30.0;
	const std::optional<double> Budget = GetBudgetError(Result.Study.Budget, Metric);
	FChartAxis Near = MakeLogAxis("", Found);
	Near.Low /= Far;
	Near.High *= Far;
	const FErrorAxis Errors(Metric, Found, LimitTo(Near, Found.empty() ? std::nullopt : Budget));
	FChartPanel Panel;
	Panel.Title = Job.Case.Label.empty() ? "All variants" : Job.Case.Label;
	Panel.X = MakeLogAxis(NameCost(Cost), Costs);
	Panel.Y = Errors.GetAxis();
	Panel.Limit = LimitTo(Panel.Y, Budget);
	FChartCurve Front;
	for (const size_t Index : Job.Variants)
	{
		const FStudyVariant& Variant = Result.Variants[Index];
		if (!Variant.Competes())
		{
			continue;
		}
		const double Error = GetErrorToRank(Variant.Error, Metric);
		const bool bFront = (bTime ? Variant.ByTime : Variant.ByTaps).bFront;
		const double X = GetCost(Variant, Cost);
		FChartSeries& Series = Panel.Series.emplace_back();
		Series.Name = Variant.Label;
		Series.Color = GetColor(Variant.Choice);
		Series.Points.push_back({X, Errors.Place(Error), bTime ? Variant.Time.Low : X, bTime ? Variant.Time.High : X,
			Errors.Label(Variant.Label, Error), "", !bFront, Variant.bCurrent, Variant.bRecommended});
		if (bFront && !Variant.bPlainCode)
		{
			Front.emplace_back(X, Errors.Place(Error));
		}
	}
	std::ranges::sort(Front);
	if (Front.size() > 1)
	{
		// Between two variants nothing is to be had but the cheaper one's error.
		Panel.Series.insert(Panel.Series.begin(), {"", "front", std::move(Front), true, false, {}});
	}
	return Panel;
}

FChart MakeStudyChart(const FStudyResult& Result, EStudyCost Cost)
{
	const std::string Clock =
		fmt::format("CPU milliseconds on {} threads, medians of {} runs in turn, whiskers between quartiles",
			Result.Threads, Result.Study.Repetitions);
	FChart Chart;
	Chart.Title = Result.Name + ": accuracy against " + (Cost == EStudyCost::Taps ? "taps per pixel" : "time");
	Chart.Notes = {DescribeStudied(Result) + "; " +
					   (Cost == EStudyCost::Taps ? "taps and errors are the same on every run" : Clock),
		"errors against " + (Result.Jobs.empty() ? "nothing" : Result.Jobs[0].Reference)};
	Chart.Legend = MakeLegend(Result, Cost);
	const std::optional<size_t> Sweep = FindSweep(Result.Study);
	std::vector<std::pair<std::string, std::vector<const FStudyJob*>>> Others; // jobs that differ by the number alone
	for (const FStudyJob& Job : Result.Jobs)
	{
		const std::string Other = Sweep ? GetOther(Job, Sweep) : "";
		const auto Known = std::ranges::find_if(Others, [&](const auto& Known) { return Known.first == Other; });
		(Known == Others.end() ? Others.emplace_back(Other, std::vector<const FStudyJob*>()) : *Known)
			.second.push_back(&Job);
	}
	if (Others.empty())
	{
		return Chart;
	}
	const std::vector<const FStudyJob*>& Shown = Others[0].second;
	if (Sweep)
	{
		const std::string Against = " against " + Result.Study.Axes[*Sweep].Name;
		Chart.Panels.push_back(MakeSweepPanel(Result, Shown, *Sweep, Cost, false));
		Chart.Panels.back().Title = "Cost" + Against;
		for (const auto& [Other, Jobs] : Others)
		{
			Chart.Panels.push_back(MakeSweepPanel(Result, Jobs, *Sweep, Cost, true));
			Chart.Panels.back().Title = "Error" + Against + (Other.empty() ? "" : ": " + Other);
		}
	}
	for (const FStudyJob* Job : Shown)
	{
		FChartPanel& Panel = Chart.Panels.emplace_back(MakeStudyPanel(Result, *Job, Cost, Result.GetMetric()));
		Panel.NumColumns = Shown.size() == 1 ? 1 : Shown.size() <= 4 ? 2 : 3;
		Panel.Height = Panel.NumColumns == 1 ? 392.0 : Panel.NumColumns == 2 ? 272.0 : 232.0;
		for (FChartSeries& Series : Panel.Series)
		{
			for (FChartPoint& Point : Series.Points)
			{
				// A recommendation depends on time, and the chart over taps is the same on every run.
				Point.bPick = Point.bPick && Cost == EStudyCost::Milliseconds;
			}
		}
	}
	return Chart;
}

} // namespace Drydock
