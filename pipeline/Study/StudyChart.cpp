// Draws the panels of a study's chart, with legend and labels.
#include "Study/StudyChart.h"

#include "Study/StudyPanel.h"
#include "Study/StudyReport.h"
#include "Study/StudyStyle.h"
#include "Study/StudySweep.h"
#include "Study/StudyView.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace Drydock
{

namespace
{

constexpr double LegendStep = 20.0; // pixels

/** Draws one study. */
class FStudyCanvas
{
public:
	FStudyCanvas(const FStudyResult& InResult, EStudyCost InCost)
		: Result(InResult)
		, Cost(InCost)
		, View{InResult, InCost}
		, Sweep(View)
	{
	}

	std::string Draw()
	{
		const std::string Title =
			Result.Name + ": accuracy against " + (Cost == EStudyCost::Taps ? "taps per pixel" : "time");
		std::string Body = SvgText(StudyPageMargin, 36.0, "title", Title) + DrawSubtitle();
		double Y = 104.0;
		Body += DrawLegend(Y);
		Body += Sweep.Draw(Y);
		Body += DrawJobs(Y);
		return BeginStudySvg(Y, Title) + Body + "</svg>\n";
	}

private:
	std::string DrawSubtitle() const
	{
		const std::string Clock =
			fmt::format("CPU milliseconds on {} threads, medians of {} runs in turn, whiskers between quartiles",
				Result.Threads, Result.Study.Repetitions);
		const std::string Reference = Result.Jobs.empty() ? "nothing" : Result.Jobs[0].Reference;
		constexpr size_t MostCharacters = 160;
		return SvgText(StudyPageMargin, 58.0, "quiet",
				   fmt::format("{}; {}", DescribeStudied(Result),
					   Cost == EStudyCost::Taps ? "taps and errors are the same on every run" : Clock)) +
			   SvgText(StudyPageMargin, 76.0, "quiet", ShortenText("errors against " + Reference, MostCharacters));
	}

	std::string DrawJob(const FStudyJob& Job, const FSvgBox& Plot)
	{
		std::vector<double> Costs;
		std::vector<double> Errors;
		std::vector<size_t> Drawn;
		for (const size_t Index : Job.Variants)
		{
			const FStudyVariant& Variant = Result.Variants[Index];
			if (!Variant.Competes())
			{
				continue;
			}
			Drawn.push_back(Index);
			Errors.push_back(View.GetError(Variant));
			Costs.push_back(View.GetCost(Variant));
			if (Cost == EStudyCost::Milliseconds)
			{
				Costs.insert(Costs.end(), {Variant.Time.Low, Variant.Time.High});
			}
		}
		// The budget is in the picture where it is not far from what was found.
		const std::optional<double> Budget = View.GetBudgetError();
		std::vector<double> Shown;
		if (Budget && !Errors.empty())
		{
			const FLogAxis Probe(Errors, 0.0, 1.0);
			if (*Budget > Probe.GetLow() / 30.0 && *Budget < Probe.GetHigh() * 30.0)
			{
				Shown.push_back(*Budget);
			}
		}
		const FLogAxis X(Costs, Plot.Left, Plot.Right);
		const FErrorAxis Y(Errors, Shown, Plot);
		std::string Svg =
			DrawAxes(Plot, X, Y.GetAxis(), X.GetTicks(), View.GetCostName(), GetErrorTitle(Result.GetMetric()));
		Svg += View.DrawBudget(Plot, Y.GetAxis());
		if (Drawn.empty())
		{
			return Svg +
				   SvgText((Plot.Left + Plot.Right) / 2.0, (Plot.Top + Plot.Bottom) / 2.0, "quiet mid", "nothing ran");
		}
		FLabelPlacer Labels({Plot.Left + 2.0, Plot.Top + 2.0, Plot.Right - 2.0, Plot.Bottom - 2.0});
		Svg += DrawFront(Drawn, X, Y, Labels) + DrawPoints(Drawn, X, Y, Labels);
		return Svg + DrawLabels(Drawn, X, Y, Plot, Labels);
	}

	/** Steps: between two variants nothing is to be had but the cheaper one's error. */
	std::string DrawFront(
		const std::vector<size_t>& Drawn, const FLogAxis& X, const FErrorAxis& Y, FLabelPlacer& Labels) const
	{
		std::vector<FSvgPoint> Front;
		for (const size_t Index : Drawn)
		{
			const FStudyVariant& Variant = Result.Variants[Index];
			if (View.GetRank(Variant).bFront && !Variant.bPlainCode)
			{
				Front.emplace_back(X.Map(View.GetCost(Variant)), Y.Map(View.GetError(Variant)));
			}
		}
		std::sort(Front.begin(), Front.end());
		std::vector<FSvgPoint> Steps;
		for (const FSvgPoint& Point : Front)
		{
			if (!Steps.empty())
			{
				Steps.emplace_back(Point.first, Steps.back().second);
			}
			Steps.push_back(Point);
		}
		for (size_t Index = 1; Index < Steps.size(); ++Index)
		{
			const auto [Left, Right] = std::minmax(Steps[Index - 1].first, Steps[Index].first);
			const auto [Top, Bottom] = std::minmax(Steps[Index - 1].second, Steps[Index].second);
			Labels.Block({Left - 1.0, Top - 1.0, Right + 1.0, Bottom + 1.0});
		}
		return Steps.size() > 1 ? SvgPath(Steps, "front") : "";
	}

	std::string DrawPoints(
		const std::vector<size_t>& Drawn, const FLogAxis& X, const FErrorAxis& Y, FLabelPlacer& Labels) const
	{
		std::string Svg;
		for (const size_t Index : Drawn)
		{
			const FStudyVariant& Variant = Result.Variants[Index];
			const double PointX = X.Map(View.GetCost(Variant));
			const double PointY = Y.Map(View.GetError(Variant));
			const std::string Color = GetStudyColor(Variant.Choice);
			if (Cost == EStudyCost::Milliseconds)
			{
				const double Low = X.Map(Variant.Time.Low);
				const double High = X.Map(Variant.Time.High);
				Svg += SvgLine(Low, PointY, High, PointY, "whisker s" + Color);
				Labels.Block({Low - 2.0, PointY - 2.0, High + 2.0, PointY + 2.0});
			}
			Svg += DrawStudyMarker(PointX, PointY, 5.0, Variant.bPlainCode,
				"dot f" + Color + (View.GetRank(Variant).bFront ? "" : " off"));
			Svg += Variant.bCurrent ? DrawStudyMarker(PointX, PointY, 9.0, false, "now") : "";
			Svg += View.IsRecommended(Variant)
					   ? DrawStudyMarker(PointX, PointY, Variant.bCurrent ? 12.5 : 9.0, false, "pick")
					   : "";
			const double Radius = View.IsRecommended(Variant) || Variant.bCurrent ? 9.5 : 6.0;
			Labels.Block({PointX - Radius, PointY - Radius, PointX + Radius, PointY + Radius});
		}
		return Svg;
	}

	/** On the line of the budget, at the end that has room: above it or below. */
	static std::string DrawBudgetName(const std::string& Text, double Line, const FSvgBox& Plot, FLabelPlacer& Labels)
	{
		const double TextWidth = EstimateTextWidth(Text, 11.0);
		const double Right = Plot.Right - 6.0 - TextWidth;
		const double Left = Plot.Left + 6.0;
		for (const auto& [X, Y] : {std::pair(Right, Line - 5.0), std::pair(Right, Line + 13.0),
				 std::pair(Left, Line - 5.0), std::pair(Left, Line + 13.0)})
		{
			const FSvgBox Box{X - 2.0, Y - 10.0, X + TextWidth + 2.0, Y + 3.0};
			if (Labels.IsFree(Box))
			{
				Labels.Block(Box);
				return SvgText(X, Y, "budgettext", Text);
			}
		}
		return "";
	}

	/** First what matters, so that it gets the room. */
	std::string DrawLabels(std::vector<size_t> Drawn, const FLogAxis& X, const FErrorAxis& Y, const FSvgBox& Plot,
		FLabelPlacer& Labels) const
	{
		std::string Svg;
		const std::optional<double> Budget = View.GetBudgetError();
		if (Budget && *Budget > Y.GetAxis().GetLow() && *Budget < Y.GetAxis().GetHigh())
		{
			Svg += DrawBudgetName("budget " + ShortText(*Budget), Y.Map(*Budget), Plot, Labels);
			Labels.Block({Plot.Left, Y.Map(*Budget) - 1.0, Plot.Right, Y.Map(*Budget) + 1.0});
		}
		const auto Importance = [&](size_t Index)
		{
			const FStudyVariant& Variant = Result.Variants[Index];
			return (View.IsRecommended(Variant) ? 8 : 0) + (Variant.bCurrent ? 4 : 0) +
				   (View.GetRank(Variant).bFront ? 2 : 0);
		};
		std::stable_sort(Drawn.begin(), Drawn.end(), [&](size_t A, size_t B) { return Importance(A) > Importance(B); });
		for (const size_t Index : Drawn)
		{
			const FStudyVariant& Variant = Result.Variants[Index];
			const std::string Class = Importance(Index) >= 4  ? "label strong"
									  : Importance(Index) > 0 ? "label"
															  : "label quiet";
			const double Error = View.GetError(Variant);
			Svg += Labels.Place(X.Map(View.GetCost(Variant)), Y.Map(Error), Y.Label(Variant.Label, Error), Class);
		}
		return Svg;
	}

	std::string DrawJobs(double& Y)
	{
		const std::vector<const FStudyJob*> Jobs = Sweep.GetShownJobs();
		const size_t Columns = Jobs.size() == 1 ? 1 : Jobs.size() <= 4 ? 2 : 3;
		const double PanelWidth =
			(StudyPageWidth - 2.0 * StudyPageMargin - StudyPanelGap * static_cast<double>(Columns - 1)) /
			static_cast<double>(Columns);
		const double PanelHeight = Columns == 1 ? 470.0 : Columns == 2 ? 350.0 : 310.0;
		std::string Svg;
		for (size_t Index = 0; Index < Jobs.size(); ++Index)
		{
			const double Left = StudyPageMargin + static_cast<double>(Index % Columns) * (PanelWidth + StudyPanelGap);
			const std::string Title = Jobs[Index]->Case.Label.empty() ? "All variants" : Jobs[Index]->Case.Label;
			Svg += SvgText(Left, Y + 18.0, "name", Title);
			Svg += DrawJob(*Jobs[Index], {Left + StudyAxisLeft, Y + StudyPanelTitle, Left + PanelWidth - 4.0,
											 Y + PanelHeight - StudyAxisBottom});
			Y += Index % Columns == Columns - 1 || Index + 1 == Jobs.size() ? PanelHeight + 6.0 : 0.0;
		}
		return Svg;
	}

	// Legend ----------------------------------------------------------------------------------------------------------

	std::string DrawLegend(double& Y)
	{
		std::string Svg;
		double X = StudyPageMargin;
		const auto Add = [&](const std::string& Text, const std::function<std::string(double, double)>& DrawSymbol)
		{
			const double Room = 26.0 + EstimateTextWidth(Text, 12.0) + 14.0;
			if (X + Room > StudyPageWidth - StudyPageMargin)
			{
				X = StudyPageMargin;
				Y += LegendStep;
			}
			Svg += DrawSymbol(X + 8.0, Y - 4.0) + SvgText(X + 22.0, Y, "", Text);
			X += Room;
		};
		for (size_t Choice = 0; Choice < View.GetNumChoices(); ++Choice)
		{
			for (const FStudyJob& Job : Result.Jobs)
			{
				const FStudyVariant& Variant = Result.Variants[Job.Variants[Choice]];
				if (Variant.Competes())
				{
					Add(Variant.Label,
						[&](double SymbolX, double SymbolY) {
							return DrawStudyMarker(
								SymbolX, SymbolY, 5.0, Variant.bPlainCode, "dot f" + GetStudyColor(Choice));
						});
					break;
				}
			}
		}
		X = StudyPageMargin;
		Y += LegendStep;
		Add("front: nobody is cheaper and as exact", [](double SymbolX, double SymbolY)
			{ return SvgLine(SymbolX - 8.0, SymbolY, SymbolX + 8.0, SymbolY, "front"); });
		Add("pale: something is cheaper and as exact",
			[](double SymbolX, double SymbolY) { return DrawStudyMarker(SymbolX, SymbolY, 5.0, false, "f7 off"); });
		const auto Any = [&](bool FStudyVariant::*Member)
		{
			return std::any_of(Result.Variants.begin(), Result.Variants.end(),
				[&](const FStudyVariant& Variant) { return Variant.*Member && Variant.Competes(); });
		};
		if (Cost == EStudyCost::Milliseconds && Any(&FStudyVariant::bRecommended))
		{
			Add("recommended: the cheapest by time within the budget",
				[](double SymbolX, double SymbolY) { return DrawStudyMarker(SymbolX, SymbolY, 6.5, false, "pick"); });
		}
		if (Any(&FStudyVariant::bCurrent))
		{
			Add("in use now",
				[](double SymbolX, double SymbolY) { return DrawStudyMarker(SymbolX, SymbolY, 6.5, false, "now"); });
		}
		if (Any(&FStudyVariant::bPlainCode))
		{
			Add("plain code in double, no shader",
				[](double SymbolX, double SymbolY) { return DrawStudyMarker(SymbolX, SymbolY, 5.0, true, "f7"); });
		}
		Y += 14.0;
		return Svg;
	}

	const FStudyResult& Result;
	EStudyCost Cost;
	FStudyView View;
	FStudySweep Sweep;
};

} // namespace

std::string DrawStudyChart(const FStudyResult& Result, EStudyCost Cost)
{
	return FStudyCanvas(Result, Cost).Draw();
}

} // namespace Drydock
