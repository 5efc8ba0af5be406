// Writes charts as JSON. Numbers are floats: these are shorter, and more than a chart shows.
#include "Report/ChartData.h"

namespace Drydock
{

namespace
{

void WriteCurve(FJsonWriter& Writer, const char* Key, const FChartCurve& Curve)
{
	Writer.Key(Key).BeginArray(true);
	for (const auto& [X, Y] : Curve)
	{
		Writer.Value(std::array{static_cast<float>(X), static_cast<float>(Y)});
	}
	Writer.EndArray();
}

void WriteTicks(FJsonWriter& Writer, const char* Key, const std::vector<FChartTick>& Ticks)
{
	Writer.Key(Key).BeginArray(true);
	for (const FChartTick& Tick : Ticks)
	{
		Writer.Object({{"value", static_cast<float>(Tick.Value)}, {"text", Tick.Text}});
	}
	Writer.EndArray();
}

void WriteAxis(FJsonWriter& Writer, const char* Key, const FChartAxis& Axis)
{
	Writer.Key(Key).BeginObject(true);
	Writer.Members({{"name", Axis.Name}, {"log", Axis.bLog}, {"low", static_cast<float>(Axis.Low)},
		{"high", static_cast<float>(Axis.High)}});
	WriteTicks(Writer, "ticks", Axis.Ticks);
	Writer.Member("valueNames", Axis.ValueNames);
	Writer.EndObject();
}

/** Members that say nothing are left out. */
void WritePoint(FJsonWriter& Writer, const FChartPoint& Point)
{
	Writer.BeginObject(true);
	Writer.Members({{"x", static_cast<float>(Point.X)}, {"y", static_cast<float>(Point.Y)}});
	if (Point.Low < Point.High)
	{
		Writer.Members({{"low", static_cast<float>(Point.Low)}, {"high", static_cast<float>(Point.High)}});
	}
	Writer.MemberIfAny("label", Point.Label);
	for (const auto& [Key, bSet] : {std::pair("pale", Point.bPale), {"now", Point.bNow}, {"pick", Point.bPick}})
	{
		if (bSet)
		{
			Writer.Member(Key, true);
		}
	}
	Writer.EndObject();
}

} // namespace

void WriteChartPanel(FJsonWriter& Writer, const FChartPanel& Panel)
{
	Writer.BeginObject(true);
	Writer.Members({{"title", Panel.Title}, {"unit", Panel.Unit}});
	WriteAxis(Writer, "x", Panel.X);
	WriteAxis(Writer, "y", Panel.Y);
	Writer.Member("limit", Panel.Limit);
	Writer.Key("series").BeginArray(true);
	for (const FChartSeries& Series : Panel.Series)
	{
		Writer.BeginObject(true);
		Writer.Members({{"name", Series.Name}, {"color", Series.Color}});
		WriteCurve(Writer, "line", Series.Line);
		Writer.Member("steps", Series.bSteps);
		Writer.Key("points").BeginArray(true);
		for (const FChartPoint& Point : Series.Points)
		{
			WritePoint(Writer, Point);
		}
		Writer.EndArray();
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.EndObject();
}

void WriteChart(FJsonWriter& Writer, const FChart& Chart)
{
	Writer.BeginObject();
	Writer.Member("markName", Chart.MarkName);
	WriteTicks(Writer, "marks", Chart.Marks);
	Writer.Array("shades", Chart.Shades,
		[&](const FChartShade& Shade)
		{
			Writer.BeginObject();
			Writer.Members({{"name", Shade.Name}, {"color", Shade.Color}});
			WriteCurve(Writer, "weights", Shade.Weights);
			Writer.EndObject();
		});
	Writer.Array("panels", Chart.Panels, [&](const FChartPanel& Panel) { WriteChartPanel(Writer, Panel); });
	Writer.EndObject();
}

} // namespace Drydock
