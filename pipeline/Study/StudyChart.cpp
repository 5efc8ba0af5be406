// Source: drydock. Colours: the first ones also the colour-blind tell apart. Past 500 lines: style sheet and canvas are one
// drawing, whose parts place themselves around one another.
#include "Study/StudyChart.h"

#include "Study/StudyPanel.h"
#include "Study/StudyRank.h"
#include "Study/StudyReport.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>

namespace Drydock
{

namespace
{

// Pixels.
constexpr double Width = 1120.0;
constexpr double Margin = 24.0;
constexpr double AxisLeft = 62.0;   // of a panel: names and ticks of its error axis
constexpr double AxisBottom = 48.0; // likewise of its cost axis
constexpr double PanelTitle = 30.0;
constexpr double PanelGap = 18.0;
constexpr double LegendStep = 20.0;

constexpr size_t NumColors = 10;

const char* const Style =
	"text{font:12px system-ui,-apple-system,'Segoe UI',Helvetica,Arial,sans-serif;fill:#1f2328}\n"
	".title{font-size:19px;font-weight:600}.name{font-size:13.5px;font-weight:600}.quiet{fill:#59636e}.tick{font-size:"
	"11px}"
	".label{font-size:11px}.strong{font-weight:600}\n"
	".end{text-anchor:end}.mid{text-anchor:middle}.page{fill:#ffffff}.plot{fill:#818b98;fill-opacity:.06}\n"
	".grid{stroke:#d1d9e0;stroke-width:.7}.leader{stroke:#818b98;stroke-width:.8}.whisker{stroke-width:1.4;stroke-"
	"opacity:.6}\n"
	".front{fill:none;stroke:#1f2328;stroke-width:1.6;stroke-opacity:.55;stroke-linejoin:round}\n"
	".budget{stroke:#cf222e;stroke-width:1.2;stroke-dasharray:6 4}.budgettext{font-size:11px;fill:#cf222e}"
	".within{fill:#1a7f37;fill-opacity:.07}\n"
	".pick{fill:none;stroke:#1a7f37;stroke-width:2.2}.now{fill:none;stroke:#1f2328;stroke-width:1.5;stroke-dasharray:3 "
	"2.4}\n"
	".line{fill:none;stroke-width:2;stroke-linejoin:round;stroke-linecap:round}.dot{stroke:#ffffff;stroke-width:1.2}"
	".off{fill-opacity:.35}\n"
	".f0{fill:#d9730d}.s0{stroke:#d9730d}.f1{fill:#2f6fdb}.s1{stroke:#2f6fdb}.f2{fill:#2a9d68}.s2{stroke:#2a9d68}"
	".f3{fill:#a651b5}.s3{stroke:#a651b5}.f4{fill:#b08d00}.s4{stroke:#b08d00}.f5{fill:#1b97b0}.s5{stroke:#1b97b0}"
	".f6{fill:#c2335c}.s6{stroke:#c2335c}.f7{fill:#6e7781}.s7{stroke:#6e7781}.f8{fill:#5b4fc9}.s8{stroke:#5b4fc9}"
	".f9{fill:#7a8f1e}.s9{stroke:#7a8f1e}\n"
	"@media (prefers-color-scheme:dark){text{fill:#e6edf3}.quiet{fill:#9198a1}.page{fill:#0d1117}.grid{stroke:#30363d}"
	".dot{stroke:#0d1117}.front{stroke:#e6edf3}.now{stroke:#e6edf3}.pick{stroke:#3fb950}.budget{stroke:#ff7b72}"
	".budgettext{fill:#ff7b72}.within{fill:#3fb950}"
	".f0{fill:#f0883e}.s0{stroke:#f0883e}.f1{fill:#58a6ff}.s1{stroke:#58a6ff}.f2{fill:#3fb950}.s2{stroke:#3fb950}"
	".f3{fill:#d2a8ff}.s3{stroke:#d2a8ff}.f4{fill:#e3b341}.s4{stroke:#e3b341}.f5{fill:#56d4dd}.s5{stroke:#56d4dd}"
	".f6{fill:#ff7b9c}.s6{stroke:#ff7b9c}.f7{fill:#9198a1}.s7{stroke:#9198a1}.f8{fill:#a5a0ff}.s8{stroke:#a5a0ff}"
	".f9{fill:#b9ce5a}.s9{stroke:#b9ce5a}}\n";

std::string BeginSvg(double Height, const std::string& Title)
{
	return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + Px(Width) + " " + Px(Height) + "\" width=\"" +
		   Px(Width) + "\" height=\"" + Px(Height) + "\" role=\"img\" aria-label=\"" + EscapeXml(Title) +
		   "\">\n<style>\n" + Style + "</style>\n<rect width=\"" + Px(Width) + "\" height=\"" + Px(Height) +
		   "\" rx=\"8\" class=\"page\"/>\n";
}

/** A circle, or a diamond for what is no shader. */
std::string DrawMarker(double X, double Y, double Radius, bool bDiamond, const std::string& Class)
{
	if (!bDiamond)
	{
		return "<circle cx=\"" + Px(X) + "\" cy=\"" + Px(Y) + "\" r=\"" + Px(Radius) + "\" class=\"" + Class + "\"/>\n";
	}
	const double R = Radius * 1.25;
	return "<path d=\"M" + Px(X - R) + " " + Px(Y) + " L" + Px(X) + " " + Px(Y - R) + " L" + Px(X + R) + " " + Px(Y) +
		   " L" + Px(X) + " " + Px(Y + R) + " Z\" class=\"" + Class + "\"/>\n";
}

bool Competes(const FStudyVariant& Variant)
{
	return Variant.bRan && Variant.Excluded.empty();
}

/** Draws one study. */
class FStudyCanvas
{
public:
	FStudyCanvas(const FStudyResult& InResult, EStudyCost InCost)
		: Result(InResult)
		, Cost(InCost)
	{
		FindSweep();
	}

	std::string Draw()
	{
		const std::string Title =
			Result.Name + ": accuracy against " + (Cost == EStudyCost::Taps ? "taps per pixel" : "time");
		std::string Body = SvgText(Margin, 36.0, "title", Title) + DrawSubtitle();
		double Y = 104.0;
		Body += DrawLegend(Y);
		Body += DrawSweeps(Y);
		Body += DrawJobs(Y);
		return BeginSvg(Y, Title) + Body + "</svg>\n";
	}

private:
	std::string DrawSubtitle() const
	{
		const std::string Size = std::to_string(Result.Width) + " x " + std::to_string(Result.Height);
		const std::string Clock = "; CPU milliseconds on " + std::to_string(Result.Threads) + " threads, medians of " +
								  std::to_string(Result.Study.Repetitions) +
								  " runs in turn, whiskers between quartiles";
		const std::string Reference = Result.Jobs.empty() ? "nothing" : Result.Jobs[0].Reference;
		constexpr size_t MostCharacters = 160;
		return SvgText(Margin, 58.0, "quiet",
				   Result.Scene + ", " + Size +
					   (Cost == EStudyCost::Taps ? "; taps and errors are the same on every run" : Clock)) +
			   SvgText(Margin, 76.0, "quiet", ShortenText("errors against " + Reference, MostCharacters));
	}

	double GetCost(const FStudyVariant& Variant) const
	{
		return Cost == EStudyCost::Taps ? Variant.Taps : Variant.Time.Median;
	}

	double GetError(const FStudyVariant& Variant) const { return GetErrorToRank(Variant.Error, Result.GetMetric()); }

	const FStudyRank& GetRank(const FStudyVariant& Variant) const
	{
		return Cost == EStudyCost::Taps ? Variant.ByTaps : Variant.ByTime;
	}

	std::string GetCostName() const { return Cost == EStudyCost::Taps ? "taps per pixel" : "CPU ms"; }

	static std::string GetColor(size_t Choice) { return std::to_string(Choice % NumColors); }

	/** The error that the budget allows, where it speaks of what is drawn. */
	std::optional<double> GetBudgetError() const
	{
		const FStudyBudget& Budget = Result.Study.Budget;
		if (!Budget.Max || Budget.Metric != Result.GetMetric())
		{
			return std::nullopt;
		}
		return Budget.Metric == "psnr"   ? std::pow(10.0, -*Budget.Max / 20.0)
			   : Budget.Metric == "ssim" ? 1.0 - *Budget.Max
										 : *Budget.Max;
	}

	// Jobs that differ by a number ------------------------------------------------------------------------------------

	/** The one axis of jobs whose values are three numbers at least, and what other such axes are set to. */
	void FindSweep()
	{
		for (size_t Axis = 0; Axis < Result.Study.Axes.size(); ++Axis)
		{
			const FStudyAxis& Candidate = Result.Study.Axes[Axis];
			const bool bNumbers = std::all_of(Candidate.Values.begin(), Candidate.Values.end(),
				[](const FStudyValue& Value)
				{
					char* End = nullptr;
					return std::strtod(Value.Label.c_str(), &End) > 0.0 && *End == '\0';
				});
			if (!Sweep && Candidate.bEach && bNumbers && Candidate.Values.size() >= 3)
			{
				Sweep = Axis;
			}
		}
		for (const FStudyJob& Job : Result.Jobs)
		{
			const std::string Other = GetOther(Job);
			if (std::find(Others.begin(), Others.end(), Other) == Others.end())
			{
				Others.push_back(Other);
			}
		}
	}

	/** A job's values without the number: "scene". */
	std::string GetOther(const FStudyJob& Job) const
	{
		std::string Other;
		for (size_t Axis = 0; Axis < Job.Case.Values.size(); ++Axis)
		{
			if (Sweep != Axis && !Job.Case.Values[Axis].empty())
			{
				Other += (Other.empty() ? "" : ", ") + Job.Case.Values[Axis];
			}
		}
		return Other;
	}

	double GetSweepNumber(const FStudyJob& Job) const { return std::strtod(Job.Case.Values[*Sweep].c_str(), nullptr); }

	/** Cost or error against the number, a line per choice, each named at its end. */
	std::string DrawSweep(const FSvgBox& Plot, const std::string& Other, bool bErrors)
	{
		const auto Value = [&](const FStudyVariant& Variant)
		{
			return bErrors ? GetError(Variant) : GetCost(Variant);
		};
		std::vector<double> Numbers;
		std::vector<double> Values;
		for (const FStudyJob& Job : Result.Jobs)
		{
			if (GetOther(Job) != Other)
			{
				continue;
			}
			Numbers.push_back(GetSweepNumber(Job));
			for (const size_t Index : Job.Variants)
			{
				if (Competes(Result.Variants[Index]))
				{
					Values.push_back(Value(Result.Variants[Index]));
				}
			}
		}
		const FLogAxis X(Numbers, Plot.Left, Plot.Right);
		const FLogAxis Y(Values, Plot.Bottom, Plot.Top);
		const std::string AxisName =
			Result.Study.Axes[*Sweep].Name + (Result.Study.Axes[*Sweep].Name == "sigma" ? ", pixels" : "");
		std::string Svg =
			DrawAxes(Plot, X, Y, Numbers, AxisName, bErrors ? GetErrorTitle(Result.GetMetric()) : GetCostName());
		if (bErrors)
		{
			Svg += DrawBudget(Plot, Y);
		}
		struct FEnd
		{
			double X;
			double Y;
			size_t Choice;
			std::string Label;
		};
		std::vector<FEnd> Ends;
		std::string Dots;
		for (size_t Choice = 0; Choice < NumChoices(); ++Choice)
		{
			std::vector<FSvgPoint> Points;
			std::string Label;
			for (const FStudyJob& Job : Result.Jobs)
			{
				const FStudyVariant& Variant = Result.Variants[Job.Variants[Choice]];
				if (GetOther(Job) == Other && Competes(Variant) && Value(Variant) > 0.0)
				{
					Points.emplace_back(X.Map(GetSweepNumber(Job)), Y.Map(Value(Variant)));
					Label = Variant.Label;
					Dots += DrawMarker(
						Points.back().first, Points.back().second, 3.4, Variant.bPlainCode, "dot f" + GetColor(Choice));
				}
			}
			if (!Points.empty())
			{
				Svg += SvgPath(Points, "line s" + GetColor(Choice));
				Ends.push_back({Points.back().first, Points.back().second, Choice, Label});
			}
		}
		Svg += Dots;
		// Names one below the other, each as near its line's end as the ones above leave room.
		std::stable_sort(Ends.begin(), Ends.end(), [](const FEnd& A, const FEnd& B) { return A.Y < B.Y; });
		constexpr double Step = 13.5;
		std::vector<double> Places;
		for (const FEnd& End : Ends)
		{
			Places.push_back(Places.empty() ? End.Y : std::max(End.Y, Places.back() + Step));
		}
		for (size_t Index = Places.size(); Index-- > 0;)
		{
			const double Limit = Index + 1 == Places.size() ? Plot.Bottom - 2.0 : Places[Index + 1] - Step;
			Places[Index] = std::min(Places[Index], Limit);
		}
		for (size_t Index = 0; Index < Ends.size(); ++Index)
		{
			const double LabelX = Plot.Right + 12.0;
			Svg += SvgLine(Ends[Index].X + 4.0, Ends[Index].Y, LabelX - 3.0, Places[Index], "leader");
			Svg += SvgText(LabelX, Places[Index] + 4.0, "label f" + GetColor(Ends[Index].Choice), Ends[Index].Label);
		}
		return Svg;
	}

	std::string DrawSweeps(double& Y)
	{
		if (!Sweep)
		{
			return "";
		}
		struct FPanel
		{
			std::string Title;
			std::string Other;
			bool bErrors;
		};
		const std::string Name = Result.Study.Axes[*Sweep].Name;
		std::vector<FPanel> Panels = {{"What it costs against " + Name, Others[0], false}};
		for (const std::string& Other : Others)
		{
			Panels.push_back({"How far off it is against " + Name + (Other.empty() ? "" : ": " + Other), Other, true});
		}
		constexpr double PanelHeight = 320.0;
		constexpr double LabelRoom = 96.0;
		const double PanelWidth = (Width - 2.0 * Margin - PanelGap) / 2.0;
		std::string Svg;
		for (size_t Index = 0; Index < Panels.size(); ++Index)
		{
			const double Left = Margin + static_cast<double>(Index % 2) * (PanelWidth + PanelGap);
			Svg += SvgText(Left, Y + 18.0, "name", Panels[Index].Title);
			const FSvgBox Plot{
				Left + AxisLeft, Y + PanelTitle, Left + PanelWidth - LabelRoom, Y + PanelHeight - AxisBottom};
			Svg += DrawSweep(Plot, Panels[Index].Other, Panels[Index].bErrors);
			Y += Index % 2 == 1 || Index + 1 == Panels.size() ? PanelHeight : 0.0;
		}
		return Svg;
	}

	// One job ---------------------------------------------------------------------------------------------------------

	std::string DrawBudget(const FSvgBox& Plot, const FLogAxis& Y) const
	{
		const std::optional<double> Budget = GetBudgetError();
		if (!Budget || *Budget <= Y.GetLow() || *Budget >= Y.GetHigh())
		{
			return "";
		}
		const double Place = Y.Map(*Budget);
		return "<rect x=\"" + Px(Plot.Left) + "\" y=\"" + Px(Place) + "\" width=\"" + Px(Plot.Right - Plot.Left) +
			   "\" height=\"" + Px(Plot.Bottom - Place) + "\" class=\"within\"/>\n" +
			   SvgLine(Plot.Left, Place, Plot.Right, Place, "budget");
	}

	std::string DrawJob(const FStudyJob& Job, const FSvgBox& Plot)
	{
		std::vector<double> Costs;
		std::vector<double> Errors;
		std::vector<size_t> Drawn;
		for (const size_t Index : Job.Variants)
		{
			const FStudyVariant& Variant = Result.Variants[Index];
			if (!Competes(Variant))
			{
				continue;
			}
			Drawn.push_back(Index);
			Errors.push_back(GetError(Variant));
			Costs.push_back(GetCost(Variant));
			if (Cost == EStudyCost::Milliseconds)
			{
				Costs.insert(Costs.end(), {Variant.Time.Low, Variant.Time.High});
			}
		}
		// The budget is in the picture where it is not far from what was found.
		const std::optional<double> Budget = GetBudgetError();
		if (Budget && !Errors.empty())
		{
			const FLogAxis Probe(Errors, 0.0, 1.0);
			if (*Budget > Probe.GetLow() / 30.0 && *Budget < Probe.GetHigh() * 30.0)
			{
				Errors.push_back(*Budget);
			}
		}
		const FLogAxis X(Costs, Plot.Left, Plot.Right);
		const FLogAxis Y(Errors, Plot.Bottom, Plot.Top);
		std::string Svg = DrawAxes(Plot, X, Y, X.GetTicks(), GetCostName(), GetErrorTitle(Result.GetMetric()));
		Svg += DrawBudget(Plot, Y);
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
		const std::vector<size_t>& Drawn, const FLogAxis& X, const FLogAxis& Y, FLabelPlacer& Labels) const
	{
		std::vector<FSvgPoint> Front;
		for (const size_t Index : Drawn)
		{
			const FStudyVariant& Variant = Result.Variants[Index];
			if (GetRank(Variant).bFront && !Variant.bPlainCode)
			{
				Front.emplace_back(X.Map(GetCost(Variant)), Y.Map(GetError(Variant)));
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
		const std::vector<size_t>& Drawn, const FLogAxis& X, const FLogAxis& Y, FLabelPlacer& Labels) const
	{
		std::string Svg;
		for (const size_t Index : Drawn)
		{
			const FStudyVariant& Variant = Result.Variants[Index];
			const double PointX = X.Map(GetCost(Variant));
			const double PointY = Y.Map(GetError(Variant));
			const std::string Color = GetColor(Variant.Choice);
			if (Cost == EStudyCost::Milliseconds)
			{
				const double Low = X.Map(Variant.Time.Low);
				const double High = X.Map(Variant.Time.High);
				Svg += SvgLine(Low, PointY, High, PointY, "whisker s" + Color);
				Labels.Block({Low - 2.0, PointY - 2.0, High + 2.0, PointY + 2.0});
			}
			Svg += DrawMarker(
				PointX, PointY, 5.0, Variant.bPlainCode, "dot f" + Color + (GetRank(Variant).bFront ? "" : " off"));
			Svg += Variant.bCurrent ? DrawMarker(PointX, PointY, 9.0, false, "now") : "";
			Svg += Variant.bRecommended ? DrawMarker(PointX, PointY, Variant.bCurrent ? 12.5 : 9.0, false, "pick") : "";
			const double Radius = Variant.bRecommended || Variant.bCurrent ? 9.5 : 6.0;
			Labels.Block({PointX - Radius, PointY - Radius, PointX + Radius, PointY + Radius});
		}
		return Svg;
	}

	/** First what matters, so that it gets the room. */
	std::string DrawLabels(std::vector<size_t> Drawn, const FLogAxis& X, const FLogAxis& Y, const FSvgBox& Plot,
		FLabelPlacer& Labels) const
	{
		std::string Svg;
		const std::optional<double> Budget = GetBudgetError();
		if (Budget && *Budget > Y.GetLow() && *Budget < Y.GetHigh())
		{
			const std::string Text = "budget " + ShortText(*Budget);
			const double Place = Y.Map(*Budget);
			const double TextWidth = EstimateTextWidth(Text, 11.0);
			Svg += SvgText(Plot.Right - 4.0, Place - 5.0, "budgettext end", Text);
			Labels.Block({Plot.Right - 6.0 - TextWidth, Place - 16.0, Plot.Right, Place + 2.0});
			Labels.Block({Plot.Left, Place - 1.0, Plot.Right, Place + 1.0});
		}
		const auto Importance = [&](size_t Index)
		{
			const FStudyVariant& Variant = Result.Variants[Index];
			return (Variant.bRecommended ? 8 : 0) + (Variant.bCurrent ? 4 : 0) + (GetRank(Variant).bFront ? 2 : 0);
		};
		std::stable_sort(Drawn.begin(), Drawn.end(), [&](size_t A, size_t B) { return Importance(A) > Importance(B); });
		for (const size_t Index : Drawn)
		{
			const FStudyVariant& Variant = Result.Variants[Index];
			const std::string Class = Importance(Index) >= 4  ? "label strong"
									  : Importance(Index) > 0 ? "label"
															  : "label quiet";
			Svg += Labels.Place(X.Map(GetCost(Variant)), Y.Map(GetError(Variant)),
				Variant.Label + (GetError(Variant) == 0.0 ? " (no error)" : ""), Class);
		}
		return Svg;
	}

	std::string DrawJobs(double& Y)
	{
		std::vector<const FStudyJob*> Jobs;
		for (const FStudyJob& Job : Result.Jobs)
		{
			if (!Sweep || GetOther(Job) == Others[0])
			{
				Jobs.push_back(&Job);
			}
		}
		const size_t Columns = Jobs.size() == 1 ? 1 : Jobs.size() <= 4 ? 2 : 3;
		const double PanelWidth =
			(Width - 2.0 * Margin - PanelGap * static_cast<double>(Columns - 1)) / static_cast<double>(Columns);
		const double PanelHeight = Columns == 1 ? 470.0 : Columns == 2 ? 350.0 : 310.0;
		std::string Svg;
		for (size_t Index = 0; Index < Jobs.size(); ++Index)
		{
			const double Left = Margin + static_cast<double>(Index % Columns) * (PanelWidth + PanelGap);
			const std::string Title = Jobs[Index]->Case.Label.empty() ? "All variants" : Jobs[Index]->Case.Label;
			Svg += SvgText(Left, Y + 18.0, "name", Title);
			Svg += DrawJob(
				*Jobs[Index], {Left + AxisLeft, Y + PanelTitle, Left + PanelWidth - 4.0, Y + PanelHeight - AxisBottom});
			Y += Index % Columns == Columns - 1 || Index + 1 == Jobs.size() ? PanelHeight + 6.0 : 0.0;
		}
		return Svg;
	}

	// Legend ----------------------------------------------------------------------------------------------------------

	size_t NumChoices() const { return Result.Jobs.empty() ? 0 : Result.Jobs[0].Variants.size(); }

	std::string DrawLegend(double& Y)
	{
		std::string Svg;
		double X = Margin;
		const auto Add = [&](const std::string& Text, const std::function<std::string(double, double)>& DrawSymbol)
		{
			const double Room = 26.0 + EstimateTextWidth(Text, 12.0) + 14.0;
			if (X + Room > Width - Margin)
			{
				X = Margin;
				Y += LegendStep;
			}
			Svg += DrawSymbol(X + 8.0, Y - 4.0) + SvgText(X + 22.0, Y, "", Text);
			X += Room;
		};
		for (size_t Choice = 0; Choice < NumChoices(); ++Choice)
		{
			for (const FStudyJob& Job : Result.Jobs)
			{
				const FStudyVariant& Variant = Result.Variants[Job.Variants[Choice]];
				if (Competes(Variant))
				{
					Add(Variant.Label, [&](double SymbolX, double SymbolY)
						{ return DrawMarker(SymbolX, SymbolY, 5.0, Variant.bPlainCode, "dot f" + GetColor(Choice)); });
					break;
				}
			}
		}
		X = Margin;
		Y += LegendStep;
		Add("front: nobody is cheaper and as exact", [](double SymbolX, double SymbolY)
			{ return SvgLine(SymbolX - 8.0, SymbolY, SymbolX + 8.0, SymbolY, "front"); });
		const auto Any = [&](bool FStudyVariant::*Member)
		{
			return std::any_of(Result.Variants.begin(), Result.Variants.end(),
				[&](const FStudyVariant& Variant) { return Variant.*Member && Competes(Variant); });
		};
		if (Any(&FStudyVariant::bRecommended))
		{
			Add("recommended: the cheapest by time within the budget",
				[](double SymbolX, double SymbolY) { return DrawMarker(SymbolX, SymbolY, 6.5, false, "pick"); });
		}
		if (Any(&FStudyVariant::bCurrent))
		{
			Add("in use now",
				[](double SymbolX, double SymbolY) { return DrawMarker(SymbolX, SymbolY, 6.5, false, "now"); });
		}
		if (Any(&FStudyVariant::bPlainCode))
		{
			Add("plain code in double, no shader",
				[](double SymbolX, double SymbolY) { return DrawMarker(SymbolX, SymbolY, 5.0, true, "f7"); });
		}
		Y += 14.0;
		return Svg;
	}

	const FStudyResult& Result;
	EStudyCost Cost;
	std::optional<size_t> Sweep;
	std::vector<std::string> Others; // values of the jobs' other axes
};

std::string EncodeBase64(const std::string& Bytes)
{
	static const char Digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	std::string Text;
	for (size_t Index = 0; Index < Bytes.size(); Index += 3)
	{
		unsigned Group = 0;
		for (size_t Byte = 0; Byte < 3; ++Byte)
		{
			const size_t At = Index + Byte;
			Group = Group << 8 | (At < Bytes.size() ? static_cast<unsigned char>(Bytes[At]) : 0u);
		}
		const size_t Left = Bytes.size() - Index;
		for (size_t Digit = 0; Digit < 4; ++Digit)
		{
			Text += Digit <= Left ? Digits[Group >> (18 - 6 * Digit) & 63u] : '=';
		}
	}
	return Text;
}

} // namespace

std::string DrawStudyChart(const FStudyResult& Result, EStudyCost Cost)
{
	return FStudyCanvas(Result, Cost).Draw();
}

std::string DrawStudyInsets(const std::string& Title, const std::vector<FStudyInsetRow>& Rows)
{
	constexpr double Gap = 10.0;
	size_t Columns = 1;
	for (const FStudyInsetRow& Row : Rows)
	{
		Columns = std::max(Columns, Row.Insets.size());
	}
	const double InsetWidth = std::min(260.0, (Width - 2.0 * Margin + Gap) / static_cast<double>(Columns) - Gap);
	std::string Body = SvgText(Margin, 36.0, "title", Title);
	double Y = 52.0;
	for (const FStudyInsetRow& Row : Rows)
	{
		Body += SvgText(Margin, Y + 16.0, "name", Row.Title);
		double Tallest = 0.0;
		for (size_t Index = 0; Index < Row.Insets.size(); ++Index)
		{
			const FStudyInset& Inset = Row.Insets[Index];
			const double X = Margin + static_cast<double>(Index) * (InsetWidth + Gap);
			const double InsetHeight = InsetWidth * Inset.Height / std::max(1, Inset.Width);
			Body += "<image x=\"" + Px(X) + "\" y=\"" + Px(Y + 26.0) + "\" width=\"" + Px(InsetWidth) + "\" height=\"" +
					Px(InsetHeight) + "\" href=\"data:image/png;base64," + EncodeBase64(Inset.Png) + "\"/>\n";
			Body += SvgText(X, Y + 42.0 + InsetHeight, "label strong", Inset.Title);
			Body += SvgText(X, Y + 57.0 + InsetHeight, "label quiet", Inset.Subtitle);
			Tallest = std::max(Tallest, InsetHeight);
		}
		Y += Tallest + 76.0;
	}
	constexpr int Steps = 40;
	for (int Step = 0; Step < Steps; ++Step)
	{
		double Color[3];
		GetHeatColor((Step + 0.5) / Steps, Color);
		char Hex[8];
		std::snprintf(Hex, sizeof(Hex), "#%02x%02x%02x", static_cast<unsigned>(Color[0] * 255.0 + 0.5),
			static_cast<unsigned>(Color[1] * 255.0 + 0.5), static_cast<unsigned>(Color[2] * 255.0 + 0.5));
		Body += "<rect x=\"" + Px(Margin + Step * 6.0) + "\" y=\"" + Px(Y) + "\" width=\"6.3\" height=\"10\" fill=\"" +
				Hex + "\"/>\n";
	}
	Body += SvgText(Margin + Steps * 6.0 + 10.0, Y + 9.0, "label quiet",
		"error: from a ten-thousandth of the row's largest to the largest, in steps of ten");
	return BeginSvg(Y + 28.0, Title) + Body + "</svg>\n";
}

} // namespace Drydock
