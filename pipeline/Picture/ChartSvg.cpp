// Draws a chart as SVG: its panels from the top down, their names where nothing is yet.
#include "Picture/Chart.h"

#include "Picture/SvgTools.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

// Pixels.
constexpr double PanelGap = 18.0;
constexpr double TitleRoom = 32.0;
constexpr double AxisNameRoom = 50.0;
constexpr double PanelRoom = 4.0;
constexpr double LabelSize = 11.0;
constexpr double LegendStep = 20.0;

/** About as wide as it will be. */
double EstimateTextWidth(const std::string& Text, double FontSize)
{
	double Width = 0.0;
	for (const char Character : Text)
	{
		const bool bNarrow = std::string("iljt.,:;|'() ").find(Character) != std::string::npos;
		const bool bContinues = (static_cast<unsigned char>(Character) & 0xC0) == 0x80;
		Width += bContinues ? 0.0 : bNarrow ? 0.36 : std::isupper(static_cast<unsigned char>(Character)) ? 0.74 : 0.63;
	}
	return Width * FontSize;
}

/** Leaves out what lies on the line from the last point that stays to the next one, to a fiftieth of a pixel. */
std::vector<FSvgPoint> ThinOut(const std::vector<FSvgPoint>& Points)
{
	std::vector<FSvgPoint> Kept;
	for (size_t Index = 0; Index < Points.size(); ++Index)
	{
		bool bOnLine = false;
		if (!Kept.empty() && Index + 1 < Points.size())
		{
			const auto& [X, Y] = Kept.back();
			const auto& [NextX, NextY] = Points[Index + 1];
			bOnLine = std::abs(Y + (NextY - Y) * (Points[Index].first - X) / (NextX - X) - Points[Index].second) < 0.02;
		}
		if (!bOnLine)
		{
			Kept.push_back(Points[Index]);
		}
	}
	return Kept;
}

std::string DrawCircle(const FSvgPoint& At, double Radius, const std::string& Class, const std::string& Tip = "")
{
	return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" class=\"{}\"{}", Px(At.first), Px(At.second), Px(Radius),
		Class, Tip.empty() ? "/>\n" : "><title>" + EscapeXml(Tip) + "</title></circle>\n");
}

std::string DrawPoint(const FChartPoint& Point, const FSvgPoint& At, double Radius, const std::string& Color)
{
	return DrawCircle(At, Radius, "dot " + Color + (Point.bPale ? " off" : ""), Point.Tip) +
		   (Point.bNow ? DrawCircle(At, Radius + 4.0, "now") : "") +
		   (Point.bPick ? DrawCircle(At, Radius + (Point.bNow ? 7.5 : 4.0), "pick") : "");
}

/** Places labels beside points, one after the other, where nothing is yet. */
class FLabels
{
public:
	explicit FLabels(const FSvgBox& InWithin)
		: Within(InWithin)
	{
	}

	void Block(const FSvgBox& Box) { Taken.push_back(Box); }

	/** Takes the first of these places that is free, and draws there; empty when there is no room. */
	std::string PlaceAt(
		const std::vector<FSvgPoint>& Places, const std::string& Text, double Width, const std::string& Class)
	{
		for (const auto& [X, Y] : Places)
		{
			const FSvgBox Box{X - 2.0, Y - 10.0, X + Width + 2.0, Y + 3.0};
			if (Within.Contains(Box) &&
				std::none_of(Taken.begin(), Taken.end(), [&](const FSvgBox& Other) { return Other.Overlaps(Box); }))
			{
				Taken.push_back(Box);
				return SvgText(X, Y, Class, Text);
			}
		}
		return "";
	}

	/** With a thin line to its point where it had to move away. */
	std::string PlaceBeside(const FSvgPoint& Point, const std::string& Text, bool bStrong, const std::string& Class)
	{
		const auto [X, Y] = Point;
		const double Width = EstimateTextWidth(Text, LabelSize) * (bStrong ? 1.1 : 1.0);
		for (const double Distance : {9.0, 15.0, 24.0, 36.0, 50.0, 66.0})
		{
			const double Diagonal = Distance * 0.75;
			const std::string Label =
				PlaceAt({{X + Distance, Y + 4.0}, {X - Distance - Width, Y + 4.0}, {X + Diagonal, Y - Diagonal},
							{X + Diagonal, Y + Diagonal + 7.0}, {X - Diagonal - Width, Y - Diagonal},
							{X - Diagonal - Width, Y + Diagonal + 7.0}, {X + 16.0, Y + 4.0 + Distance},
							{X + 16.0, Y + 4.0 - Distance}, {X - Width / 2.0, Y - Distance},
							{X - Width / 2.0, Y + Distance + 8.0}},
					Text, Width, Class);
			if (!Label.empty())
			{
				const FSvgBox& Box = Taken.back();
				const double EndX = std::clamp(X, Box.Left + 2.0, Box.Right - 2.0);
				const double EndY = std::clamp(Y, Box.Top + 2.0, Box.Bottom - 2.0);
				return (Distance > 15.0 ? SvgLine(X, Y, EndX, EndY, "leader") : "") + Label;
			}
		}
		return "";
	}

private:
	FSvgBox Within;
	std::vector<FSvgBox> Taken;
};

/** Draws one panel. */
class FPanelDrawing
{
public:
	FPanelDrawing(const FChart& InChart, const FChartPanel& InPanel, const FSvgBox& InPlot)
		: Chart(InChart)
		, Panel(InPanel)
		, Plot(InPlot)
		, Labels({Plot.Left + 2.0, Plot.Top + 2.0, Plot.Right - 2.0 + Panel.NameRoom, Plot.Bottom - 2.0})
	{
	}

	std::string Draw()
	{
		std::string Svg = DrawTitle() + SvgRect(Plot, "plot");
		for (size_t Shade = 0; Panel.bShaded && Shade < Chart.Shades.size(); ++Shade)
		{
			Svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"url(#g{})\"/>\n",
				Px(Plot.Left), Px(Plot.Top), Px(Plot.Right - Plot.Left), Px(Plot.Bottom - Plot.Top), Shade);
		}
		Svg += DrawAxes();
		for (const FChartTick& Mark : Chart.Marks)
		{
			Svg += SvgLine(GetX(Mark.Value), Plot.Top, GetX(Mark.Value), Plot.Bottom, "mark");
		}
		Svg += DrawLimit();
		if (Panel.Series.empty())
		{
			return Svg + SvgText((Plot.Left + Plot.Right) / 2.0, (Plot.Top + Plot.Bottom) / 2.0, "quiet mid",
							 "nothing to show");
		}
		for (const FChartSeries& Series : Panel.Series)
		{
			Svg += DrawLine(Series);
		}
		for (const FChartSeries& Series : Panel.Series)
		{
			Svg += DrawPoints(Series);
		}
		return Svg + DrawLabels();
	}

private:
	double GetX(double Value) const { return Plot.Left + Panel.X.Map(Value) * (Plot.Right - Plot.Left); }
	double GetY(double Value) const { return Plot.Bottom + Panel.Y.Map(Value) * (Plot.Top - Plot.Bottom); }
	FSvgPoint GetPlace(const FChartPoint& Point) const { return {GetX(Point.X), GetY(Point.Y)}; }

	/** Lines with names, such as a colour's components, are named here in their colours. */
	std::string DrawTitle() const
	{
		std::string Markup = EscapeXml(Panel.Title);
		const auto Add = [&](const std::string& Class, const std::string& Text)
		{
			Markup += Text.empty() ? "" : "<tspan class=\"" + Class + "\" dx=\"8\">" + EscapeXml(Text) + "</tspan>";
		};
		Add("quiet plain", Panel.Unit);
		for (const FChartSeries& Series : Panel.Series)
		{
			const bool bNamed = !Series.Line.empty() && !Series.bFilled && Panel.NameRoom == 0.0;
			Add("own " + Series.Color, bNamed ? Series.Name : "");
		}
		return Panel.Title.empty() ? ""
								   : SvgMarkup(Plot.Left, Plot.Top - 12.0, "name", Markup) +
										 SvgText(Plot.Right, Plot.Top - 12.0, "quiet end", Panel.Aside);
	}

	std::string DrawAxes() const
	{
		std::string Svg;
		double LastRight = -HUGE_VAL;
		for (const FChartTick& Tick : Panel.X.Ticks)
		{
			const double Place = GetX(Tick.Value);
			const double Half = EstimateTextWidth(Tick.Text, LabelSize) / 2.0;
			Svg += SvgLine(Place, Plot.Top, Place, Plot.Bottom, "grid");
			if (!Panel.X.Name.empty() && Place - Half > LastRight)
			{
				Svg += SvgText(Place, Plot.Bottom + 16.0, "tick mid", Tick.Text);
				LastRight = Place + Half + 5.0;
			}
		}
		for (const FChartTick& Tick : Panel.Y.Ticks)
		{
			const double Place = GetY(Tick.Value);
			Svg += Panel.Y.Ticks.size() > 1 ? SvgLine(Plot.Left, Place, Plot.Right, Place, "grid") : "";
			Svg += SvgText(Plot.Left - 7.0, Place + 4.0, "tick end", Tick.Text);
		}
		if (!Panel.X.Name.empty())
		{
			Svg += SvgText((Plot.Left + Plot.Right) / 2.0, Plot.Bottom + 33.0, "tick quiet mid", Panel.X.Name);
		}
		return Panel.Y.Name.empty()
				   ? Svg
				   : Svg + fmt::format(
							   "<text transform=\"translate({} {}) rotate(-90)\" class=\"tick quiet mid\">{}</text>\n",
							   Px(Plot.Left - 44.0), Px((Plot.Top + Plot.Bottom) / 2.0), EscapeXml(Panel.Y.Name));
	}

	std::string DrawLimit()
	{
		if (!Panel.Limit)
		{
			return "";
		}
		const double Line = GetY(*Panel.Limit);
		return SvgRect({Plot.Left, Line, Plot.Right, Plot.Bottom}, "within") +
			   SvgLine(Plot.Left, Line, Plot.Right, Line, "budget");
	}

	std::string DrawLine(const FChartSeries& Series)
	{
		std::vector<FSvgPoint> Points;
		for (const auto& [X, Y] : Series.Line)
		{
			if (Series.bSteps && !Points.empty())
			{
				Points.emplace_back(GetX(X), Points.back().second);
			}
			Points.emplace_back(GetX(X), GetY(Y));
		}
		Points = ThinOut(Points);
		for (size_t Index = 1; Index < Points.size(); ++Index)
		{
			const auto [Left, Right] = std::minmax(Points[Index - 1].first, Points[Index].first);
			const auto [Top, Bottom] = std::minmax(Points[Index - 1].second, Points[Index].second);
			Labels.Block({Left - 1.0, Top - 1.0, Right + 1.0, Bottom + 1.0});
		}
		if (Series.bFilled)
		{
			Points.insert(Points.begin(), {Plot.Left, Plot.Bottom});
			Points.emplace_back(Plot.Right, Plot.Bottom);
			return "<path d=\"" + SvgPathData(Points) + " Z\" class=\"own " + Series.Color + "\"><title>" +
				   EscapeXml(Series.Name) + "</title></path>\n";
		}
		return Points.size() > 1 ? SvgPath(Points, "line " + Series.Color) : "";
	}

	std::string DrawPoints(const FChartSeries& Series)
	{
		std::string Svg;
		for (const FChartPoint& Point : Series.Points)
		{
			const FSvgPoint At = GetPlace(Point);
			const double Low = GetX(Point.Low);
			const double High = GetX(Point.High);
			if (Point.Low < Point.High)
			{
				Svg += SvgLine(Low, At.second, High, At.second, "whisker " + Series.Color);
				Labels.Block({Low - 2.0, At.second - 2.0, High + 2.0, At.second + 2.0});
			}
			Svg += DrawPoint(Point, At, Series.Line.empty() ? 5.0 : 3.5, Series.Color);
			const double Radius = Point.bPick || Point.bNow ? 9.5 : 6.0;
			Labels.Block({At.first - Radius, At.second - Radius, At.first + Radius, At.second + Radius});
		}
		return Svg;
	}

	/** First the limit's, at the end of its line that has room; then those that matter. */
	std::string DrawLabels()
	{
		std::string Svg;
		if (Panel.Limit)
		{
			const std::string Text = "budget " + ShortText(*Panel.Limit);
			const double Width = EstimateTextWidth(Text, LabelSize);
			const double Line = GetY(*Panel.Limit);
			const double Right = Plot.Right - 6.0 - Width;
			const double Left = Plot.Left + 6.0;
			Svg += Labels.PlaceAt({{Right, Line - 5.0}, {Right, Line + 13.0}, {Left, Line - 5.0}, {Left, Line + 13.0}},
				Text, Width, "budgettext");
			Labels.Block({Plot.Left, Line - 1.0, Plot.Right, Line + 1.0});
		}
		std::vector<std::pair<const FChartSeries*, const FChartPoint*>> Named;
		for (const FChartSeries& Series : Panel.Series)
		{
			for (const FChartPoint& Point : Series.Points)
			{
				Named.emplace_back(&Series, &Point);
			}
		}
		std::stable_sort(Named.begin(), Named.end(),
			[](const auto& A, const auto& B) { return A.second->GetImportance() > B.second->GetImportance(); });
		for (const auto& [Series, Point] : Named)
		{
			const bool bStrong = Point->GetImportance() >= 4;
			const std::string Class = !Series->Line.empty() ? "label own " + Series->Color
									  : bStrong             ? "label strong"
									  : Point->bPale        ? "label quiet"
															: "label";
			Svg += Point->Label.empty() ? "" : Labels.PlaceBeside(GetPlace(*Point), Point->Label, bStrong, Class);
		}
		return Svg;
	}

	const FChart& Chart;
	const FChartPanel& Panel;
	const FSvgBox Plot;
	FLabels Labels;
};

/** As strong as the weights. */
std::string DrawGradients(const FChart& Chart)
{
	std::string Svg;
	for (size_t Index = 0; Index < Chart.Shades.size(); ++Index)
	{
		constexpr double Across = 1000.0, Full = 100.0; // a picture about as large, for what may be left out
		std::vector<FSvgPoint> Points;
		for (const auto& [X, Weight] : Chart.Shades[Index].Weights)
		{
			Points.emplace_back(Chart.Panels.front().X.Map(X) * Across, Weight * Full);
		}
		Svg += fmt::format("<linearGradient id=\"g{}\">", Index);
		for (const auto& [X, Weight] : ThinOut(Points))
		{
			Svg += fmt::format("<stop offset=\"{}\" class=\"{}\" stop-opacity=\"{}\"/>", FixedText(X / Across, 5),
				Chart.Shades[Index].Color, FixedText(0.2 * Weight / Full, 4));
		}
		Svg += "</linearGradient>\n";
	}
	return Svg;
}

std::string DrawLegend(const std::vector<FChartLegend>& Row, double& Y)
{
	std::string Svg;
	double X = SvgPageMargin;
	for (const FChartLegend& Entry : Row)
	{
		const double Room = 26.0 + EstimateTextWidth(Entry.Text, 12.0) + 14.0;
		if (X + Room > SvgPageWidth - SvgPageMargin)
		{
			X = SvgPageMargin;
			Y += LegendStep;
		}
		Svg += Entry.Color == "front" ? SvgLine(X, Y - 4.0, X + 16.0, Y - 4.0, "line front")
									  : DrawPoint(Entry.Look, {X + 8.0, Y - 4.0}, 5.0, Entry.Color);
		Svg += SvgText(X + 22.0, Y, "", Entry.Text);
		X += Room;
	}
	Y += LegendStep;
	return Svg;
}

} // namespace

std::string DrawChart(const FChart& Chart)
{
	std::string Body = DrawGradients(Chart) + SvgText(SvgPageMargin, 36.0, "title", Chart.Title);
	double Y = 40.0;
	for (const std::string& Note : Chart.Notes)
	{
		constexpr size_t MostCharacters = 175;
		Y += 18.0;
		Body += SvgText(SvgPageMargin, Y, "quiet", ShortenText(Note, MostCharacters));
	}
	Y += 28.0;
	for (const std::vector<FChartLegend>& Row : Chart.Legend)
	{
		Body += DrawLegend(Row, Y);
	}
	const double First = SvgPageMargin + Chart.AxisRoom;
	if (!Chart.Marks.empty())
	{
		Body += SvgText(First - 12.0, Y, "quiet end", Chart.MarkName);
		double Free = First - 24.0; // where the next label may begin
		for (const FChartTick& Mark : Chart.Marks)
		{
			const double X =
				First + Chart.Panels.front().X.Map(Mark.Value) * (SvgPageWidth - SvgPageMargin - PanelRoom - First);
			const std::string Label = ShortenText(Mark.Text, 12);
			const double Half = EstimateTextWidth(Label, 12.0) / 2.0;
			if (X - Half >= Free)
			{
				Body += SvgText(X, Y, "quiet mid", Label);
				Free = X + Half + 6.0;
			}
		}
		Y += PanelRoom;
	}
	size_t Column = 0;
	for (size_t Index = 0; Index < Chart.Panels.size(); ++Index)
	{
		const FChartPanel& Panel = Chart.Panels[Index];
		const double NumColumns = Panel.NumColumns;
		const double Width = (SvgPageWidth - 2.0 * SvgPageMargin - PanelGap * (NumColumns - 1.0)) / NumColumns;
		const double Left = SvgPageMargin + static_cast<double>(Column) * (Width + PanelGap);
		const double Top = Y + (Panel.Title.empty() ? PanelRoom : TitleRoom);
		Body += FPanelDrawing(
			Chart, Panel, {Left + Chart.AxisRoom, Top, Left + Width - PanelRoom - Panel.NameRoom, Top + Panel.Height})
					.Draw();
		const bool bLast = Index + 1 == Chart.Panels.size();
		const bool bRowEnds = ++Column == static_cast<size_t>(Panel.NumColumns) || bLast ||
							  Chart.Panels[Index + 1].NumColumns != Panel.NumColumns;
		if (bRowEnds)
		{
			Column = 0;
			Y = Top + Panel.Height + (Panel.X.Name.empty() ? PanelRoom : AxisNameRoom);
		}
	}
	return BeginSvg(Y + PanelRoom, Chart.Title) + Body + "</svg>\n";
}

} // namespace Drydock
