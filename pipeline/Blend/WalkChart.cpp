// Draws the chart of a walk. Its first two colours are an orange and a blue, which colour-blind readers tell apart too.
#include "Blend/WalkChart.h"

#include "Math/ToInteger.h"
#include "Picture/SvgTools.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

// Pixels.
constexpr double Width = 960.0;
constexpr double Left = 150.0;
constexpr double Right = Width - 30.0;
constexpr double LanesTop = 104.0;
constexpr double LaneHeight = 14.0;
constexpr double LaneStep = 21.0;
constexpr double RowTitle = 34.0; // above a row's plot
constexpr double RowHeight = 92.0;
constexpr double RowStep = RowTitle + RowHeight + 8.0;
constexpr double AxisHeight = 58.0;

constexpr size_t NumVolumeColors = 6;

const char* const LightStyle =
	".title{font-size:18px;font-weight:600}.name{font-size:13px;font-weight:600}.quiet{fill:#59636e}\n"
	".end{text-anchor:end}.mid{text-anchor:middle}.page{fill:#ffffff}\n"
	".grid{stroke:#d1d9e0}.mark{stroke:#818b98;stroke-dasharray:2 3;stroke-opacity:.6}.track{fill:#818b98;"
	"fill-opacity:.13}\n"
	".line{fill:none;stroke-width:2;stroke-linejoin:round;stroke-linecap:round}.dot{stroke:#ffffff;stroke-width:1.5}\n"
	".l0{stroke:#1f2328}.d0{fill:#1f2328}.l1{stroke:#cf222e}.d1{fill:#cf222e}.l2{stroke:#1a7f37}.d2{fill:#1a7f37}"
	".l3{stroke:#0969da}.d3{fill:#0969da}.l4{stroke:#6e7781}.d4{fill:#6e7781}\n"
	".u{fill:#8c959f}.v0{fill:#d9730d;stop-color:#d9730d}.v1{fill:#2f6fdb;stop-color:#2f6fdb}"
	".v2{fill:#2a9d68;stop-color:#2a9d68}.v3{fill:#a651b5;stop-color:#a651b5}.v4{fill:#b08d00;stop-color:#b08d00}"
	".v5{fill:#1b97b0;stop-color:#1b97b0}\n";

const char* const DarkStyle =
	".l0{stroke:#e6edf3}.d0{fill:#e6edf3}.l1{stroke:#ff7b72}.d1{fill:#ff7b72}.l2{stroke:#56d364}"
	".d2{fill:#56d364}.l3{stroke:#79c0ff}.d3{fill:#79c0ff}.l4{stroke:#9198a1}.d4{fill:#9198a1}"
	".v0{fill:#f0883e;stop-color:#f0883e}.v1{fill:#58a6ff;stop-color:#58a6ff}.v2{fill:#3fb950;stop-color:#3fb950}"
	".v3{fill:#d2a8ff;stop-color:#d2a8ff}.v4{fill:#e3b341;stop-color:#e3b341}.v5{fill:#56d4dd;stop-color:#56d4dd}";

/** From data to pixels. */
class FCanvas
{
public:
	explicit FCanvas(const FWalkChart& InChart)
		: Chart(InChart)
		, RowsTop(LanesTop + LaneStep * static_cast<double>(InChart.Volumes.size()))
		, Bottom(RowsTop + RowStep * static_cast<double>(InChart.Rows.size()))
	{
	}

	std::string Draw() const
	{
		const double Height = Bottom + AxisHeight;
		std::string Svg = BeginSvg(Width, Height, Chart.Title, LightStyle, DarkStyle) + DrawGradients();
		Svg += SvgPage(Width, Height, 6.0);
		Svg += SvgText(24.0, 36.0, "title", Chart.Title) + SvgText(24.0, 58.0, "quiet", Chart.Subtitle);
		Svg += DrawShades() + DrawMarks() + DrawLanes();
		for (size_t Index = 0; Index < Chart.Rows.size(); ++Index)
		{
			Svg += DrawRow(Chart.Rows[Index], RowsTop + RowStep * static_cast<double>(Index) + RowTitle);
		}
		return Svg + DrawAxis() + "</svg>\n";
	}

private:
	double GetX(double Distance) const
	{
		return Left + (Chart.Length > 0.0 ? Distance / Chart.Length : 0.0) * (Right - Left);
	}

	/** "v2", or "u" of a volume that acts everywhere. */
	std::string GetColor(size_t Volume) const
	{
		size_t Bounded = 0;
		for (size_t Index = 0; Index < Volume; ++Index)
		{
			Bounded += Chart.Volumes[Index].bUnbound ? 0 : 1;
		}
		return Chart.Volumes[Volume].bUnbound ? "u" : "v" + std::to_string(Bounded % NumVolumeColors);
	}

	/** The weight along the path, 0..1 in y. */
	std::vector<FSvgPoint> GetWeights(const FWalkChartVolume& Volume, double Height) const
	{
		std::vector<FSvgPoint> Points;
		for (const auto& [Distance, Weight] : Volume.Weights)
		{
			Points.emplace_back(GetX(Distance), Weight * Height);
		}
		return SimplifyCurve(Points);
	}

	std::string DrawGradients() const
	{
		std::string Svg = "<defs>\n";
		for (size_t Index = 0; Index < Chart.Volumes.size(); ++Index)
		{
			if (Chart.Volumes[Index].bUnbound)
			{
				continue;
			}
			Svg += fmt::format(
				"<linearGradient id=\"g{}\" gradientUnits=\"userSpaceOnUse\" x1=\"{}\" y1=\"0\" x2=\"{}\" y2=\"0\">",
				Index, Px(Left), Px(Right));
			for (const FSvgPoint& Point : GetWeights(Chart.Volumes[Index], RowHeight))
			{
				Svg += fmt::format("<stop offset=\"{}\" class=\"{}\" stop-opacity=\"{}\"/>",
					FixedText((Point.first - Left) / (Right - Left), 5), GetColor(Index),
					FixedText(0.2 * Point.second / RowHeight, 4));
			}
			Svg += "</linearGradient>\n";
		}
		return Svg + "</defs>\n";
	}

	/** Of every bounded volume, as strong as its weight, behind every row. */
	std::string DrawShades() const
	{
		std::string Svg;
		for (size_t Row = 0; Row < Chart.Rows.size(); ++Row)
		{
			const double Top = RowsTop + RowStep * static_cast<double>(Row) + RowTitle;
			for (size_t Index = 0; Index < Chart.Volumes.size(); ++Index)
			{
				if (!Chart.Volumes[Index].bUnbound)
				{
					Svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"url(#g{})\"/>\n",
						Px(Left), Px(Top), Px(Right - Left), Px(RowHeight), Index);
				}
			}
		}
		return Svg;
	}

	/** Through the lanes and the plots, not through the words between them. */
	std::string DrawGuides(double X) const
	{
		std::string Path = "M" + Px(X) + " " + Px(LanesTop - 4.0) + " V" + Px(RowsTop - LaneStep + LaneHeight);
		for (size_t Row = 0; Row < Chart.Rows.size(); ++Row)
		{
			const double Top = RowsTop + RowStep * static_cast<double>(Row) + RowTitle;
			Path += " M" + Px(X) + " " + Px(Top) + " V" + Px(Top + RowHeight);
		}
		return "<path d=\"" + Path + "\" class=\"mark\"/>\n";
	}

	std::string DrawMarks() const
	{
		std::string Svg = SvgText(Left - 12.0, LanesTop - 10.0, "quiet end", Chart.MarkName);
		double Free = Left - 24.0; // where the next label may begin
		for (const FWalkChartMark& Mark : Chart.Marks)
		{
			const double X = GetX(Mark.Distance);
			const std::string Label = ShortenText(Mark.Label, 12);
			const double Half = 4.0 * static_cast<double>(Label.size());
			Svg += DrawGuides(X);
			if (X - Half >= Free)
			{
				Svg += SvgText(X, LanesTop - 10.0, "quiet mid", Label);
				Free = X + Half + 6.0;
			}
		}
		return Svg;
	}

	/** A volume each: its name, and its weight as height. */
	std::string DrawLanes() const
	{
		std::string Svg;
		for (size_t Index = 0; Index < Chart.Volumes.size(); ++Index)
		{
			const FWalkChartVolume& Volume = Chart.Volumes[Index];
			const double Top = LanesTop + LaneStep * static_cast<double>(Index);
			std::vector<FSvgPoint> Area = {{Left, Top + LaneHeight}};
			for (const FSvgPoint& Point : GetWeights(Volume, LaneHeight))
			{
				Area.emplace_back(Point.first, Top + LaneHeight - Point.second);
			}
			Area.emplace_back(Right, Top + LaneHeight);
			Svg += SvgText(Left - 12.0, Top + LaneHeight - 3.0, "end", ShortenText(Volume.Name, 17));
			Svg += SvgRect({Left, Top, Right, Top + LaneHeight}, "track");
			Svg += "<path d=\"" + SvgPathData(Area) + " Z\" class=\"" + GetColor(Index) +
				   "\" fill-opacity=\".85\"><title>" + EscapeXml(Volume.Name) +
				   (Volume.bUnbound ? ": everywhere" : ": weight along the path") + "</title></path>\n";
		}
		return Svg;
	}

	static std::string NameValue(const FWalkChartRow& Row, double Value)
	{
		const int32_t NumNames = static_cast<int32_t>(Row.ValueNames.size());
		const bool bNamed = Value >= 0.0 && Value < NumNames;
		return bNamed ? Row.ValueNames[static_cast<size_t>(ToIndex(Value, NumNames))] : ShortText(Value);
	}

	std::string DrawRow(const FWalkChartRow& Row, double Top) const
	{
		double Low = 1e300;
		double High = -1e300;
		for (const FWalkChartLine& Line : Row.Lines)
		{
			for (const auto& [Distance, Value] : Line.Values)
			{
				Low = std::min(Low, Value);
				High = std::max(High, Value);
			}
		}
		if (!(Low <= High) || !std::isfinite(High - Low))
		{
			return SvgText(Left, Top - 10.0, "name", Row.Name);
		}
		const double Pad = High > Low ? 0.1 * (High - Low) : std::max(0.1 * std::abs(High), 0.5);
		Low -= Pad;
		High += Pad;
		const auto GetY = [&](double Value)
		{
			return Top + RowHeight * (1.0 - (Value - Low) / (High - Low));
		};
		return DrawRowTitle(Row, Top) + DrawScale(Row, Low, High, GetY) + DrawCurves(Row, GetY);
	}

	std::string DrawRowTitle(const FWalkChartRow& Row, double Top) const
	{
		std::string Markup = EscapeXml(Row.Name);
		if (!Row.Unit.empty())
		{
			Markup += "<tspan class=\"quiet\" dx=\"8\" font-weight=\"400\">" + EscapeXml(Row.Unit) + "</tspan>";
		}
		for (size_t Line = 0; Line < Row.Lines.size() && Row.Lines.size() > 1; ++Line)
		{
			Markup +=
				fmt::format("<tspan class=\"d{}\" dx=\"8\">{}</tspan>", 1 + Line % 4, EscapeXml(Row.Lines[Line].Label));
		}
		std::string Title = SvgMarkup(Left, Top - 10.0, "name", Markup);
		if (Row.Lines.size() == 1 && !Row.Lines[0].Values.empty())
		{
			const double First = Row.Lines[0].Values.front().second;
			const double Last = Row.Lines[0].Values.back().second;
			Title += First != Last ? SvgText(Right, Top - 10.0, "quiet end",
										 NameValue(Row, First) + " \xE2\x86\x92 " + NameValue(Row, Last))
								   : "";
		}
		return Title;
	}

	template<typename TGetY>
	std::string DrawScale(const FWalkChartRow& Row, double Low, double High, const TGetY& GetY) const
	{
		std::string Svg;
		const FAxisTicks Ticks(Low, High, 5);
		for (const double Value : Ticks.Values)
		{
			const bool bBetweenNames = !Row.ValueNames.empty() && Value != std::floor(Value);
			if (!bBetweenNames)
			{
				Svg += SvgLine(Left, GetY(Value), Right, GetY(Value), "grid");
				Svg += SvgText(Left - 12.0, GetY(Value) + 4.0, "quiet end",
					Row.ValueNames.empty() ? FixedText(Value, Ticks.Digits) : ShortenText(NameValue(Row, Value), 17));
			}
		}
		return Svg;
	}

	template<typename TGetY>
	std::string DrawCurves(const FWalkChartRow& Row, const TGetY& GetY) const
	{
		std::string Svg;
		for (size_t Line = 0; Line < Row.Lines.size(); ++Line)
		{
			const std::string Color = std::to_string(Row.Lines.size() > 1 ? 1 + Line % 4 : 0);
			std::vector<FSvgPoint> Points;
			for (const auto& [Distance, Value] : Row.Lines[Line].Values)
			{
				if (Row.bSteps && !Points.empty())
				{
					Points.emplace_back(GetX(Distance), Points.back().second);
				}
				Points.emplace_back(GetX(Distance), GetY(Value));
			}
			Svg += SvgPath(SimplifyCurve(Points), "line l" + Color);
			Svg += DrawDots(Row, Row.Lines[Line], "d" + Color, GetY);
		}
		return Svg;
	}

	/** At the points of the path. */
	template<typename TGetY>
	std::string DrawDots(
		const FWalkChartRow& Row, const FWalkChartLine& Line, const std::string& Class, const TGetY& GetY) const
	{
		std::string Svg;
		size_t Index = 0;
		for (const FWalkChartMark& Mark : Chart.Marks)
		{
			while (Index < Line.Values.size() && Line.Values[Index].first < Mark.Distance)
			{
				++Index;
			}
			if (Index == Line.Values.size())
			{
				break;
			}
			const double Value = Line.Values[Index].second;
			Svg += "<circle cx=\"" + Px(GetX(Mark.Distance)) + "\" cy=\"" + Px(GetY(Value)) +
				   "\" r=\"3.5\" class=\"dot " + Class + "\"><title>" +
				   EscapeXml(Chart.MarkName + " " + Mark.Label + ": " + NameValue(Row, Value)) + "</title></circle>\n";
		}
		return Svg;
	}

	std::string DrawAxis() const
	{
		std::string Svg;
		if (Chart.Length > 0.0)
		{
			const FAxisTicks Ticks(0.0, Chart.Length, 8);
			for (const double Value : Ticks.Values)
			{
				const double X = GetX(Value);
				Svg += SvgLine(X, Bottom - 8.0, X, Bottom - 3.0, "grid");
				Svg += SvgText(X, Bottom + 12.0, "quiet mid", FixedText(Value, Ticks.Digits));
			}
		}
		return Svg + SvgText((Left + Right) / 2.0, Bottom + 34.0, "quiet mid", "distance along the path, cm");
	}

	const FWalkChart& Chart;
	const double RowsTop;
	const double Bottom;
};

} // namespace

std::string DrawWalkChart(const FWalkChart& Chart)
{
	return FCanvas(Chart).Draw();
}

} // namespace Drydock
